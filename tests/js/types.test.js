// SPDX-License-Identifier: MIT
// The packed package's types, in the oldest TypeScript that is supported and in the newest, by every way of
// finding modules; and what the linters of packages say.
import { copyFileSync, mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pack } from '../bundlers/try.mjs';
import { execute, root } from './support/paths.js';

const oldest = 'typescript-oldest';
let folder;
let packed;

beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'kdmanifold-types-'));
  packed = pack(folder);
  writeFileSync(join(folder, 'package.json'), '{ "private": true, "type": "module" }');
  const { status, stderr } = execute(
    'npm',
    ['install', '--no-audit', '--no-fund', packed, `${oldest}@npm:typescript@5.0.4`],
    { cwd: folder },
  );
  expect({ status, stderr: status ? stderr : '' }).toEqual({ status: 0, stderr: '' });
  const modules = join(folder, 'node_modules');
  mkdirSync(join(modules, '@types'), { recursive: true });
  for (const name of ['three', 'typescript', '@types/three', '@types/node']) {
    symlinkSync(join(root, 'node_modules', name), join(modules, name));
  }
}, 120_000);

afterAll(() => rmSync(folder, { recursive: true, force: true }));

/** What a TypeScript says of files, under --strict and with the libraries' types checked. */
function check(typescript, files, compilerOptions) {
  const options = { strict: true, noEmit: true, target: 'es2022', types: [], skipLibCheck: false };
  writeFileSync(
    join(folder, 'tsconfig.json'),
    JSON.stringify({ compilerOptions: { ...options, ...compilerOptions }, files }),
  );
  const tsc = join(folder, 'node_modules', typescript, 'lib/tsc.js');
  return execute(process.execPath, [tsc, '-p', '.'], { cwd: folder }).stdout;
}

test('all that is legal, and nothing else, under tsc --strict', () => {
  copyFileSync(join(root, 'tests/types/usage.ts'), join(folder, 'usage.ts'));
  const lib = ['es2022', 'esnext.disposable', 'dom'];
  // The types of three.js do not hold by themselves.
  const options = { module: 'nodenext', lib, skipLibCheck: true };
  expect(check('typescript', ['usage.ts'], options)).toBe('');
});

const modules = `
import { close, KdManifoldError, load, makeManifold, preload, type Mesh } from 'kdmanifold';
const { mesh, report } = await makeManifold({ positions: new Float32Array(9) }, { concurrency: 2 });
const result: Mesh = mesh;
const positions: Float32Array = result.positions;
const thread: 'worker' | 'main' = report.thread;
const threads: number = report.threads;
const grid = (await load()).buildGrid({ positions });
grid[Symbol.dispose]();
await preload();
await close();
// @ts-expect-error no such place
const nowhere: 'nowhere' = report.thread;
export { KdManifoldError, nowhere, positions, thread, threads };
`;
const commonJs = `
import { makeManifold } from 'kdmanifold';
export const conversion = makeManifold({ positions: new Float32Array(9) });
`;

test.each([
  [oldest, 'node16', 'node16'],
  [oldest, 'nodenext', 'nodenext'],
  [oldest, 'esnext', 'bundler'],
  [oldest, 'es2022', 'node'],
  ['typescript', 'node16', 'node16'],
  ['typescript', 'nodenext', 'nodenext'],
  ['typescript', 'esnext', 'bundler'],
])("%s, module %s, moduleResolution %s, without the DOM's types", (typescript, ...how) => {
  const [module, moduleResolution] = how;
  writeFileSync(join(folder, 'modules.ts'), modules);
  writeFileSync(join(folder, 'common.cts'), commonJs);
  const files = module.startsWith('node') ? ['modules.ts', 'common.cts'] : ['modules.ts'];
  expect(check(typescript, files, { module, moduleResolution, lib: ['es2022'] })).toBe('');
});

const bin = (name) => join(root, 'node_modules/.bin', name);

test('publint has nothing to say', () => {
  const { status, stdout } = execute(bin('publint'), ['--strict', '--pack', 'false'], {
    cwd: root,
  });
  expect(stdout).toMatch(/All good/);
  expect(status).toBe(0);
});

test('are the types wrong? No', () => {
  // The files that are addressed, never imported, are no modules with types.
  const files = ['--exclude-entrypoints', 'kdmanifold.wasm', 'kdmanifold-tools.wasm', 'worker'];
  const { status, stdout } = execute(bin('attw'), [packed, '--no-emoji', '--no-color', ...files]);
  expect(stdout).toMatch(/No problems found/);
  expect(status).toBe(0);
});
