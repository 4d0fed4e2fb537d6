// SPDX-License-Identifier: MIT
// Options and reports have one source, the tables in src/include/kdmanifold: what is made of them is
// current, and every option is taken and refused alike by all that have it.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { load } from '../../dist/index.js';
import createModule from '../../build/js/kdmanifold.js';
import { generate } from '../../scripts/generate-options.mjs';
import { cube } from './support/meshes.js';
import { execute, nativeCli, nodeCli, root, withFolder } from './support/paths.js';

const description = JSON.parse(execute(nativeCli, ['--describe']).stdout);
const { build, extract, reduction, reduce, analyze } = description.options;
const programs = [
  ['native', (args, options) => execute(nativeCli, args, options)],
  ['Node', (args, options) => execute(process.execPath, [nodeCli, ...args], options)],
];

const { WebAssembly } = globalThis;
let kdm;
let grid;
beforeAll(async () => {
  kdm = await load();
  grid = kdm.buildGrid(cube());
});
afterAll(() => grid.delete());

test('what is made of the tables is current (npm run options)', async () => {
  const page = readFileSync(join(root, 'docs/options.md'), 'utf8');
  for (const [path, text] of Object.entries(await generate(description, page))) {
    expect({ path, text: readFileSync(join(root, path), 'utf8') }).toEqual({ path, text });
  }
});

test('the descriptions are complete', () => {
  for (const options of Object.values(description.options)) {
    for (const { name, flag, type, help, letter, least, words } of options) {
      expect(name).toMatch(/^[a-z][a-zA-Z]*$/);
      const dashed = name.replace(/[A-Z]/g, (c) => `-${c.toLowerCase()}`);
      expect([`--${dashed}`, `--no-${dashed}`]).toContain(flag);
      expect(help).toMatch(/^[a-z`].*[^.]$/);
      if (['number', 'integer', 'numbers'].includes(type)) {
        expect(letter).toMatch(type === 'numbers' ? /^N\[,N\.\.\.\]$/ : /^[A-Z]$/);
        expect(typeof least).toBe('number');
      }
      if (type === 'choice') for (const { help: meaning } of words) expect(meaning).not.toBe('');
    }
  }
  for (const { help, keys } of Object.values(description.reports)) {
    expect(help).not.toBe('');
    for (const key of keys) expect(key.help).toMatch(/^[A-Z`].*[^.]$/);
  }
});

test('both command lines print the same help', () => {
  const [native, node] = programs.map(([, run]) => run(['--help']));
  expect(node).toEqual(native);
  for (const { flag } of [...build, ...extract, ...reduction])
    expect(native.stdout).toContain(`  ${flag}`);
});

// Values that an option takes, without its default, and values that it refuses.
function values({ type, least, most, below, words, default: standard }) {
  switch (type) {
    case 'choice':
      return [words.map(({ word }) => word), ['nonsense', 'none']];
    case 'boolean':
      return [[!standard], [1]];
    case 'numbers':
      return [
        [[5], [7, 5, 1]],
        [[0], [5, 5], [4, 5], [7, 0.5]],
      ];
    case 'box':
      return [
        [[-1, -1, -1, 4, 4, 4]],
        [
          [1, 2, 3, 4, 5],
          [0, 0, 0, 0, 0, 0],
          [5, 5, 5, -1, -1, -1],
        ],
      ];
    default: {
      const legal = [most ?? (below === undefined ? 1000 : below / 2)];
      const wrong = [least - 1, Infinity];
      if (most !== undefined) wrong.push(most + 1);
      if (below !== undefined) wrong.push(below);
      if (type === 'integer') wrong.push(least + 0.5);
      return [[least, ...legal], wrong];
    }
  }
}

const errorOf = (action) => {
  try {
    action();
    return 'none';
  } catch (error) {
    return error;
  }
};

// All options of the three calls, and how each is tried.
const calls = [
  ...build.map((option) => [option, (options) => kdm.buildGrid(cube(), options).delete()]),
  ...extract.map((option) => [option, (options) => grid.extract(options)]),
  // One of the two is always wanted.
  ...reduce.map((option) => [
    option,
    (options) => kdm.simplifyMesh(cube(), { targetTriangles: 12, ...options }),
  ]),
  ...analyze.map((option) => [option, (options) => kdm.analyze(cube(), options)]),
].map(([option, call]) => [option.name, option, call]);

test.each(calls)(
  'JavaScript: %s takes what is legal and refuses all else',
  (name, option, call) => {
    const [legal, wrong] = values(option);
    for (const value of legal) {
      // That a shell of that thickness cannot be had, or a hole is too wide, is another matter.
      const error = errorOf(() => call({ [name]: value }));
      if (error !== 'none') expect(error.message).not.toMatch(new RegExp(`^${name}: expected`));
    }
    for (const value of [...wrong, null]) {
      const error = errorOf(() => call({ [name]: value }));
      expect(error).toMatchObject({ name: 'KdManifoldError', code: 'INVALID_OPTION' });
      expect(error.message).toMatch(new RegExp(`^${name}: expected`));
    }
  },
);

// Past the checks of the wrapper.
test('the WebAssembly module itself reads every option and refuses what is out of its range', async () => {
  const module = await WebAssembly.compile(readFileSync(join(root, 'dist/kdmanifold.wasm')));
  const raw = await createModule({
    instantiateWasm(imports, receive) {
      WebAssembly.instantiate(module, imports).then((instance) => receive(instance, module));
      return {};
    },
  });
  const { value: rawGrid } = raw.buildGrid(cube(), {}, null);
  const attempts = [
    ...build.map((option) => [option, (options) => raw.buildGrid(cube(), options, null)]),
    ...extract.map((option) => [option, (options) => rawGrid.extract(options, null)]),
    ...reduction.map((option) => [
      option,
      (options) => raw.makeManifold(cube(), options, () => null),
    ]),
  ];
  for (const [option, call] of attempts) {
    const { name, type } = option;
    if (type === 'boolean') continue;
    const [legal, wrong] = values(option);
    for (const value of legal) {
      expect(call({ [name]: value }).message ?? '').not.toContain('it must be a');
    }
    // Fractions and infinity do not get past the wrapper. 0 means "not set" to C++ where it is not legal.
    for (const value of wrong.filter(
      (v) => typeof v === 'string' || [v].flat().every(Number.isInteger),
    )) {
      if (option.unset !== undefined && value === 0) continue;
      const { code, message } = call({ [name]: value });
      expect({ name, value, code }).toEqual({ name, value, code: 'INVALID_OPTION' });
      expect(message.replace(/_([a-z])/g, (_, c) => c.toUpperCase())).toContain(name);
    }
  }
});

test.each([...build, ...extract, ...reduction].map((option) => [option.name, option]))(
  'command lines: %s takes what is legal and refuses all else, with the same words',
  (_, option) =>
    withFolder((folder) => {
      const { flag, type } = option;
      // With an input that is not there, legal arguments are those that get as far as that.
      const tell = (args) =>
        programs.map(([, run]) => run(['none.obj', ...args], { cwd: folder }).stderr);
      const [legal, wrong] = type === 'boolean' ? [[], []] : values(option);
      const taken = type === 'boolean' ? [[flag]] : legal.map((value) => [flag, String(value)]);
      // It has no effect without.
      const beside =
        {
          '--cells': ['--strategy=octree'],
          '--crease-angle': ['--normals'],
          '--thicken-what': ['--thicken=1'],
          '--remove-material': ['--simplify=1'],
          '--add-material': ['--simplify=1'],
        }[flag] ?? [];
      for (const args of taken) {
        for (const line of tell([...args, ...beside]))
          expect(line).toMatch(/^kdmanifold: none\.obj: cannot be/);
      }
      for (const value of wrong) {
        const [native, node] = tell([`${flag}=${value}`]);
        expect(native).toMatch(new RegExp(`^kdmanifold: ${flag}: `));
        expect(node).toBe(native);
      }
    }),
);
