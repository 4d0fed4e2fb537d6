// SPDX-License-Identifier: MIT
// makeManifold, which in Node works in a worker thread.
import { load, makeManifold } from '../../dist/index.js';
import { cube, faults, torus, volume } from './support/meshes.js';
import { execute, root } from './support/paths.js';

const large = () => torus(512, 256);

test('gives a mesh and a report', async () => {
  const { mesh, report } = await makeManifold(torus());
  expect(faults(mesh)).toEqual([]);
  expect(report.input).toMatchObject({ triangles: 1024, closed: true });
  expect(report.output).toMatchObject({
    vertices: mesh.positions.length / 3,
    triangles: mesh.indices.length / 3,
    quads: 0,
    components: 1,
    eulerCharacteristic: 0,
    twoManifold: true,
    closed: true,
  });
  expect(report.output.volume).toBeCloseTo(volume(mesh), 3);
  expect(report.grid.leaves).toBeGreaterThan(0);
  expect(report.seconds.build).toBeGreaterThan(0);
  expect(report.seconds.extract).toBeGreaterThan(0);
  expect(report.seconds.reduce).toBeGreaterThan(0);
  expect(report.peakBytes).toBeGreaterThan(0);
});

test('warns of what came out otherwise than one may take for granted, and of nothing else', async () => {
  expect((await makeManifold(torus())).report.warnings).toEqual([]);
  const { positions, indices } = torus();
  const { report } = await makeManifold({ positions, indices: indices.slice(30) });
  expect(report.warnings).toEqual([
    { code: 'HOLES_CLOSED', message: expect.stringMatching(/^holes were closed: [\d.]+ % of/) },
  ]);
});

test('gives the same mesh as the synchronous interface', async () => {
  const options = { strategy: 'median', depth: 15, inside: 'odd', pairing: 'hermite' };
  const { mesh } = await makeManifold(torus(), { ...options, quads: true });
  const grid = (await load()).buildGrid(torus(), options);
  const { report, ...expected } = grid.extract({ quads: true });
  grid.delete();
  expect(Object.keys(mesh).sort()).toEqual(Object.keys(expected).sort());
  for (const [name, array] of Object.entries(expected)) expect([...mesh[name]]).toEqual([...array]);
  expect(report.droppedPillows).toBeGreaterThanOrEqual(0);
});

test("leaves the caller's arrays alone, unless told to take them", async () => {
  const kept = torus();
  await makeManifold(kept);
  expect(kept.positions).toHaveLength(32 * 16 * 3);
  const taken = torus();
  const { report } = await makeManifold(taken, { transfer: true });
  expect(report.output.twoManifold).toBe(true);
  expect(taken.positions).toHaveLength(0);
  expect(taken.indices).toHaveLength(0);
});

test('takes the arrays as they are at the time of the call', async () => {
  const mesh = cube();
  const promise = makeManifold(mesh);
  mesh.positions.fill(0);
  expect(volume((await promise).mesh)).toBeCloseTo(8, 5);
});

test('transfer of a part of a buffer copies that part', async () => {
  const { positions, indices } = cube();
  const buffer = new Float32Array(100);
  buffer.set(positions, 10);
  await makeManifold({ positions: buffer.subarray(10, 34), indices }, { transfer: true });
  expect(buffer).toHaveLength(100);
});

test('reports progress that never falls and ends at 1', async () => {
  const seen = [];
  const onProgress = (fraction, phase) => {
    expect(typeof phase).toBe('string');
    seen.push(fraction);
  };
  await makeManifold(large(), { onProgress });
  expect(seen.length).toBeGreaterThan(1);
  expect(seen).toEqual([...seen].sort((a, b) => a - b));
  expect(seen.at(-1)).toBe(1);
});

test('the event loop runs on meanwhile', async () => {
  let ticks = 0;
  const timer = globalThis.setInterval(() => ++ticks, 5);
  await makeManifold(large());
  globalThis.clearInterval(timer);
  expect(ticks).toBeGreaterThan(5);
});

test('a signal stops the conversion in work, soon, and the ones in line', async () => {
  const controller = new AbortController();
  const { signal } = controller;
  const slow = { strategy: 'uniform', depth: 27, signal };
  const jobs = [
    makeManifold(large(), slow),
    makeManifold(cube(), { signal }),
    makeManifold(cube()),
  ];
  const settled = Promise.allSettled(jobs);
  setTimeout(() => controller.abort('changed my mind'), 200);
  const started = performance.now();
  const [first, second, third] = await settled;
  expect(first.reason).toBe('changed my mind');
  expect(second.reason).toBe('changed my mind');
  expect(third.value.report.output.twoManifold).toBe(true);
  expect(performance.now() - started).toBeLessThan(10_000);
});

test('the callback stops the conversion by returning false or by throwing', async () => {
  const stopped = makeManifold(large(), { onProgress: () => false });
  await expect(stopped).rejects.toMatchObject({ code: 'ABORTED' });
  const mine = new RangeError('mine');
  const thrown = makeManifold(large(), {
    onProgress: () => {
      throw mine;
    },
  });
  await expect(thrown).rejects.toBe(mine);
  expect((await makeManifold(cube())).report.output.twoManifold).toBe(true);
});

test('many calls at once are done one after the other', async () => {
  const done = await Promise.all([1, 2, 3, 4, 5].map((size) => makeManifold(cube(size))));
  done.forEach(({ mesh }, i) => expect(volume(mesh)).toBeCloseTo((i + 1) ** 3, 3));
});

test('an idle worker does not keep the process alive', () => {
  const script = `
    import { makeManifold } from '${root}/dist/index.js';
    const positions = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
    const indices = new Uint32Array([0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]);
    const { report } = await makeManifold({ positions, indices });
    console.log(report.output.twoManifold);`;
  const { status, stdout, stderr } = execute(
    process.execPath,
    ['--input-type=module', '--eval', script],
    { timeout: 60_000 },
  );
  expect({ status, stdout, stderr }).toEqual({ status: 0, stdout: 'true\n', stderr: '' });
});

test('without workers it works on the calling thread, and says so', () => {
  const script = `
    import { Worker } from 'node:worker_threads';
    import workerThreads from 'node:worker_threads';
    import { syncBuiltinESMExports } from 'node:module';
    workerThreads.Worker = class { constructor() { throw new Error('no workers here'); } };
    syncBuiltinESMExports();
    const { makeManifold } = await import('${root}/dist/index.js');
    const positions = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
    const indices = new Uint32Array([0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]);
    const stop = new AbortController();
    const seen = [];
    const { report } = await makeManifold({ positions, indices }, { onProgress: (f) => void seen.push(f) });
    const late = makeManifold({ positions, indices }, { signal: stop.signal });
    stop.abort();
    console.log(report.output.twoManifold, report.thread, seen.at(-1), await late.catch((error) => error.code));`;
  const { stdout, stderr } = execute(process.execPath, ['--input-type=module', '--eval', script], {
    timeout: 60_000,
  });
  expect(stdout).toBe('true main 1 ABORTED\n');
  // Once, though two conversions found none.
  expect(stderr.match(/kdmanifold: no worker could be started \(no workers here\)/g)).toHaveLength(
    1,
  );
});
