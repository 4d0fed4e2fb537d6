// SPDX-License-Identifier: MIT
// preload, close, concurrency, reasons of aborts, and who does the work; in Node.
import { close, load, makeManifold, preload } from '../../dist/index.js';
import { cube, torus } from './support/meshes.js';
import { execute, root } from './support/paths.js';

const { AbortSignal } = globalThis;
afterEach(() => close());

const script = (body) => {
  const { stdout, stderr, status } = execute(
    process.execPath,
    [
      '--input-type=module',
      '--eval',
      `import workerThreads, { Worker } from 'node:worker_threads';
      import { syncBuiltinESMExports } from 'node:module';
      const started = [];
      workerThreads.Worker = class extends Worker {
        constructor(...args) { super(...args); started.push(this); }
      };
      syncBuiltinESMExports();
      const { close, load, makeManifold, preload } = await import('${root}/dist/index.js');
      const positions = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
      const indices = new Uint32Array([0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]);
      const mesh = () => ({ positions, indices });
      ${body}`,
    ],
    { timeout: 60_000 },
  );
  return { stdout: stdout.trim(), stderr, status };
};
const clean = (stdout) => ({ stdout, stderr: '', status: 0 });

test('preload starts the workers that conversions then use', () => {
  expect(
    script(`
    await preload({ concurrency: 2 });
    const before = started.length;
    const reports = await Promise.all([1, 2, 3].map(() => makeManifold(mesh(), { concurrency: 2 })));
    console.log(before, started.length, reports.map(({ report }) => report.thread).join());`),
  ).toEqual(clean('2 2 worker,worker,worker'));
});

test('one worker at a time by default, as many as `concurrency` says', () => {
  const most = (options) => `
    await Promise.all(Array.from({ length: 6 }, () => makeManifold(mesh(), ${options})));
    console.log(started.length);`;
  expect(script(most('{}'))).toEqual(clean('1'));
  expect(script(most('{ concurrency: 3 }'))).toEqual(clean('3'));
});

test('conversions at once are done at once: none waits for the others', async () => {
  const controller = new AbortController();
  const slow = { strategy: 'uniform', depth: 27, signal: controller.signal, concurrency: 2 };
  const long = makeManifold(torus(512, 256), slow);
  const quick = await makeManifold(cube(), { concurrency: 2 });
  expect(quick.report.output.twoManifold).toBe(true);
  controller.abort('enough');
  await expect(long).rejects.toBe('enough');
});

test('close ends the workers, rejects what is under way, and all works afterwards', () => {
  expect(
    script(`
    await makeManifold(mesh());
    const running = [makeManifold(mesh()), makeManifold(mesh())];
    const codes = Promise.all(running.map((one) => one.catch((error) => error.code)));
    await close();
    const alive = started.filter((worker) => worker.threadId !== -1).length;
    console.log((await codes).join(), alive);
    console.log((await makeManifold(mesh())).report.thread, started.length);
    await close();`),
  ).toEqual(clean('ABORTED,ABORTED 0\nworker 2'));
});

test('close lets what load gave be used, and forgets it', async () => {
  const kdm = await load();
  await close();
  expect(kdm.describe(cube()).twoManifold).toBe(true);
  expect(await load()).not.toBe(kdm);
});

test('an abort rejects with the reason that was given, else with ABORTED', async () => {
  const abortWith = (...reason) => {
    const controller = new AbortController();
    const done = makeManifold(torus(256, 128), { signal: controller.signal });
    controller.abort(...reason);
    return done.catch((error) => error);
  };
  const mine = new Error('mine');
  expect(await abortWith(mine)).toBe(mine);
  expect(await abortWith(null)).toBe(null);
  expect(await abortWith()).toMatchObject({ code: 'ABORTED', cause: { name: 'AbortError' } });
  const timeout = makeManifold(torus(512, 256), { depth: 27, signal: AbortSignal.timeout(1) });
  await expect(timeout).rejects.toMatchObject({ name: 'TimeoutError' });
});

test('a signal that outlives many conversions keeps no listeners', async () => {
  let listeners = 0;
  const signal = {
    aborted: false,
    addEventListener: () => ++listeners,
    removeEventListener: () => --listeners,
  };
  await Promise.all([1, 2, 3].map(() => makeManifold(cube(), { signal })));
  expect(listeners).toBe(0);
});

test('worker: false works on the calling thread without a word', () => {
  expect(
    script(`
    await preload();
    const { report } = await makeManifold(mesh(), { worker: false, threads: 1 });
    console.log(report.thread, started.length);`),
  ).toEqual(clean('main 1'));
});

test('a worker that is not where it is said to be: one warning with the reason', () => {
  const { stdout, stderr } = script(`
    for (let i = 0; i < 2; ++i) {
      const { report } = await makeManifold(mesh(), { workerUrl: 'nowhere/worker.js' });
      console.log(report.thread);
    }`);
  expect(stdout).toBe('main\nmain');
  expect(stderr.match(/no worker could be started \(.*nowhere\/worker\.js/g)).toHaveLength(1);
});

test('preload refuses what it does not know', async () => {
  await expect(preload({ depth: 3 })).rejects.toMatchObject({
    code: 'INVALID_OPTION',
    message: 'depth: no such option',
  });
});
