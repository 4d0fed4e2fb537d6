// SPDX-License-Identifier: MIT
// What importing the package does to its surroundings, and what it may not need: nothing.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { filesOf, parts, zippedSize } from '../../scripts/sizes.mjs';
import { execute, root } from './support/paths.js';

const dist = join(root, 'dist');
const run = (flags, script) => {
  const { status, stdout, stderr } = execute(
    process.execPath,
    [...flags, '--input-type=module', '--eval', script],
    { timeout: 60_000 },
  );
  return { status, stdout, stderr };
};
const clean = (stdout) => ({ status: 0, stdout, stderr: '' });

test('importing touches no global and starts nothing', () => {
  const script = `
    // Everything that a server-side renderer lacks or forbids is a trap.
    for (const name of ['window', 'document', 'self', 'navigator', 'fetch', 'Worker', 'process']) {
      Object.defineProperty(globalThis, name, {
        configurable: true,
        get() { throw new Error(name + ' was touched'); },
      });
    }
    const { compile, instantiate, compileStreaming } = WebAssembly;
    WebAssembly.compile = WebAssembly.instantiate = () => { throw new Error('compiled'); };
    const before = Object.getOwnPropertyNames(globalThis).sort().join();
    await import('${dist}/index.js');
    const after = Object.getOwnPropertyNames(globalThis).sort().join();
    console.log(before === after);`;
  // The trap on process would catch Node's own console, too: give it back before printing.
  const kept = script
    .replace('// Everything', 'const kept = process;\n    // Everything')
    .replace(
      'console.log(',
      "Object.defineProperty(globalThis, 'process', { value: kept });\n    console.log(",
    );
  expect(run([], kept)).toEqual(clean('true\n'));
});

test('works where code generation from strings is forbidden', () => {
  const script = `
    import { load, makeManifold } from '${dist}/index.js';
    const positions = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
    const indices = new Uint32Array([0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]);
    const grid = (await load()).buildGrid({ positions, indices });
    grid.extract();
    grid.delete();
    const { report } = await makeManifold({ positions, indices });
    console.log(report.output.twoManifold);`;
  expect(run(['--disallow-code-generation-from-strings'], script)).toEqual(clean('true\n'));
});

test('no file of the package evaluates strings or requires modules', () => {
  // dist/cjs is for those who require.
  for (const name of readdirSync(dist).filter((file) => file.endsWith('.js'))) {
    const code = readFileSync(join(dist, name), 'utf8');
    expect([name, /\beval\(|new Function\b|\brequire\(/.test(code)]).toEqual([name, false]);
  }
});

// Raise the numbers when something worth its size is added, never in passing.
test('size budget: what a page has to fetch, zipped', () => {
  const size = (part) => zippedSize(filesOf(parts[part], dist), dist);
  expect(filesOf(parts['making manifolds'], dist)).toEqual(
    expect.arrayContaining(['index.js', 'kdmanifold-worker.js', 'kdmanifold.wasm']),
  );
  expect(size('making manifolds')).toBeLessThan(522_000);
  expect(size('tools')).toBeLessThan(100_000);
});

const { WebAssembly } = globalThis;

const functionsOf = async (name) => {
  const { default: createModule } = await import(`${root}/build/js/${name}.js`);
  const bytes = readFileSync(join(root, `build/js/${name}.wasm`));
  const module = await createModule({
    instantiateWasm(imports, receive) {
      WebAssembly.instantiate(bytes, imports).then(({ instance }) => receive(instance));
      return {};
    },
  });
  return Object.keys(module).filter((key) => /^[a-z]+([A-Z][a-z]+)*$/.test(key));
};

test('each module exports its functions', async () => {
  expect(await functionsOf('kdmanifold')).toEqual(
    expect.arrayContaining([
      ...['buildGrid', 'loadGrid', 'thicken', 'describe', 'findSelfIntersections'],
      ...['memory', 'version'],
    ]),
  );
  expect(await functionsOf('kdmanifold-tools')).toEqual(
    expect.arrayContaining(['parseMesh', 'formatMesh', 'analyze', 'memory', 'version']),
  );
});
