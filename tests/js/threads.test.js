// SPDX-License-Identifier: MIT
// Several threads in WebAssembly, in Node: results, errors and endings are those of one.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { close, load, makeManifold } from '../../dist/index.js';
import { cube, torus } from './support/meshes.js';
import { execute, nodeCli, root, withFolder } from './support/paths.js';

const { AbortController, SharedArrayBuffer } = globalThis;
afterEach(() => close());

/** A torus with a hole of one face, enough for several threads. */
function openTorus() {
  const { positions, indices } = torus(128, 64);
  return { positions, indices: indices.slice(3) };
}

/** Runs a program that has the package and the meshes at hand. */
function script(body, ...flags) {
  const code = `
    import { close, load, makeManifold } from '${root}/dist/index.js';
    import { cube, torus } from '${root}/tests/js/support/meshes.js';
    ${body}`;
  const args = [...flags, '--input-type=module', '--eval', code];
  const { status, stdout, stderr } = execute(process.execPath, args, { timeout: 60_000 });
  return { status, stdout: stdout.trim(), stderr };
}
const clean = (stdout) => ({ status: 0, stdout, stderr: '' });

const arraysOf = (mesh) => Object.values(mesh).filter((value) => ArrayBuffer.isView(value));

test.each([
  ['in a worker', {}],
  ['on the calling thread', { worker: false }],
])('the same result with any number of threads, %s', async (_, where) => {
  const make = async (threads) => {
    const options = { relativeTolerance: 0.001, check: true, threads, ...where };
    const { mesh, report } = await makeManifold(openTorus(), options);
    expect(report.threads).toBe(threads);
    for (const { buffer } of arraysOf(mesh)) expect(buffer).not.toBeInstanceOf(SharedArrayBuffer);
    await close();
    const { lost, error, grid, output, reduce, warnings } = report;
    return { mesh, account: { lost, error, grid, output, reduce, warnings } };
  };
  const alone = await make(1);
  expect(alone.mesh.indices.length).toBeGreaterThan(3000);
  expect(await make(2)).toEqual(alone);
  expect(await make(3)).toEqual(alone);
});

test('step by step with threads: the same grid, the same mesh', async () => {
  const make = async (threads) => {
    const kdm = await load({ threads });
    expect(kdm.threads).toBe(threads);
    const grid = kdm.buildGrid(openTorus(), { tolerance: 0.02 });
    const made = { saved: grid.save(), mesh: grid.extract({ reduce: { error: 0.02 } }) };
    grid.delete();
    await close();
    return made;
  };
  expect(await make(3)).toEqual(await make(1));
});

test('the default is what the machine runs at once, shared among the conversions at a time', () => {
  const count = (options) => `
    const { availableParallelism } = await import('node:os');
    const { report } = await makeManifold(cube(), ${options});
    console.log(report.threads, Math.min(16, availableParallelism()));`;
  const counts = (options) => script(count(options)).stdout.split(' ').map(Number);
  const [threads, machine] = counts('{}');
  expect(threads).toBe(machine);
  expect(counts('{ concurrency: 2 }')[0]).toBe(Math.max(1, Math.floor(machine / 2)));
  expect(counts('{ concurrency: 64 }')[0]).toBe(1);
});

test('who says where kdmanifold.wasm comes from gets one thread', async () => {
  const wasmBinary = readFileSync(join(root, 'dist/kdmanifold.wasm'));
  expect((await load({ wasmBinary, threads: 3 })).threads).toBe(1);
});

test.each([0, 257, 1.5, '2', null])('threads: %p is refused', async (threads) => {
  const refusal = {
    code: 'INVALID_OPTION',
    message: `threads: expected a whole number from 1 to 256, got ${threads}`,
  };
  await expect(makeManifold(cube(), { threads })).rejects.toMatchObject(refusal);
  await expect(load({ threads })).rejects.toMatchObject(refusal);
});

test('errors are those of one thread', async () => {
  const kdm = await load({ threads: 2 });
  const codeOf = (act) => {
    try {
      return act();
    } catch ({ code, message }) {
      return [code, message];
    }
  };
  const build = (mesh, options) => codeOf(() => kdm.buildGrid(mesh, options));
  expect(build(openTorus(), { inside: 'odd' })).toEqual(['NOT_CLOSED', expect.any(String)]);
  expect(build(cube(), { depth: 99 })).toEqual(['INVALID_OPTION', expect.any(String)]);
  const enormous = { positions: new Float32Array(540_000_000) };
  expect(build(enormous)).toEqual(['OUT_OF_MEMORY', expect.any(String)]);
  // And it goes on.
  const grid = kdm.buildGrid(cube());
  expect(kdm.describe(grid.extract()).twoManifold).toBe(true);
  grid.delete();
});

test('the calling thread stops the work of all, and works on', async () => {
  const kdm = await load({ threads: 3 });
  const mesh = torus(256, 128);
  for (const last of [1, 2]) {
    let calls = 0;
    const stop = () => ++calls < last;
    expect(() => kdm.buildGrid(mesh, { tolerance: 0.01, onProgress: stop })).toThrow(
      expect.objectContaining({ code: 'ABORTED' }),
    );
    expect(calls).toBe(last);
  }
  const fault = new Error('mine');
  const fail = () => {
    throw fault;
  };
  expect(() => kdm.buildGrid(mesh, { onProgress: fail })).toThrow(fault);
  const grid = kdm.buildGrid(cube());
  expect(grid.stats.leaves).toBeGreaterThan(0);
  grid.delete();
});

test('a signal stops a worker with threads', async () => {
  const controller = new AbortController();
  const options = { threads: 3, signal: controller.signal };
  const done = makeManifold(torus(512, 256), {
    ...options,
    onProgress: () => controller.abort('enough'),
  });
  await expect(done).rejects.toBe('enough');
});

test('a program ends by itself, whoever has had threads', () => {
  expect(
    script(`
    const kdm = await load({ threads: 3 });
    const { report } = await makeManifold(torus(128, 64), { threads: 3 });
    const grid = kdm.buildGrid(torus(128, 64));
    console.log(report.threads, kdm.threads, grid.stats.leaves > 0);`),
  ).toEqual(clean('3 3 true'));
});

// Hooks the threads that the calling thread starts.
const hook = (body) => `
  const { createRequire, syncBuiltinESMExports } = await import('node:module');
  const workerThreads = createRequire('/')('node:worker_threads');
  const started = [];
  workerThreads.Worker = class extends workerThreads.Worker {
    constructor(...args) { super(...args); started.push(this); }
    ${body}
  };
  syncBuiltinESMExports();`;

test('threads end with the last that holds the instance', () => {
  expect(
    script(
      `${hook('')}
      let grid = (await load({ threads: 3 })).buildGrid(torus(64, 32));
      await close();
      const alive = () => started.filter((thread) => thread.threadId !== -1).length;
      const settle = async () => {
        for (let i = 0; i < 50 && (i < 5 || alive() > 0); ++i) {
          gc();
          await new Promise((resolve) => setTimeout(resolve, 20));
        }
      };
      await settle();
      const before = alive();
      grid.delete();
      grid = null;
      await settle();
      console.log(before, alive());`,
      '--expose-gc',
    ),
  ).toEqual(clean('2 0'));
});

test('where a thread is lost the call fails as after any trap, and waits no longer', () => {
  const { stdout, status } = script(`
    ${hook(`postMessage(message) {
      super.postMessage(message.cmd === 'run' ? { ...message, start_routine: 0 } : message);
    }`)}
    const kdm = await load({ threads: 2 });
    try {
      kdm.buildGrid(torus(128, 64), { tolerance: 0.01 });
    } catch ({ code }) {
      console.log(code);
    }
    process.exit(0);`);
  expect([stdout.split('\n').at(-1), status]).toEqual(['INTERNAL', 0]);
});

test('threads that cannot be started are done without', () => {
  expect(
    script(`
    ${hook('').replace('super(...args);', "throw new Error('none');")}
    const kdm = await load({ threads: 2 });
    console.log(kdm.threads, kdm.describe(cube()).twoManifold);`),
  ).toEqual(clean('1 true'));
});

test('the command line takes --threads, and writes the same', async () => {
  await withFolder(async (folder) => {
    const input = join(folder, 'torus.obj');
    const { positions, indices } = openTorus();
    const kdm = await load();
    writeFileSync(input, kdm.formatMesh({ positions, indices }, 'obj'));
    const convert = (...args) => {
      const output = join(folder, `${args.join('')}.ply`);
      const run = execute(process.execPath, [nodeCli, input, '-o', output, '--quiet', ...args]);
      expect(run).toEqual({ status: 0, stdout: '', stderr: '' });
      return readFileSync(output);
    };
    const alone = convert('--threads', '1');
    expect(convert('--threads', '2').equals(alone)).toBe(true);
    expect(convert().equals(alone)).toBe(true);
  });
});
