// SPDX-License-Identifier: MIT
// Solids that are moved: in a worker, and on the thread that calls.
import { boolean, close, load, openBooleanScene } from '../../dist/index.js';
import { cube, torus, volume } from './support/meshes.js';

// Columns, as three.js has them.
const movedBy = (x, y, z) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];
const places = [movedBy(3, 0, 0), movedBy(2.9, 0.3, 0.1), movedBy(-3, 0.2, 0), movedBy(4, 0, 0)];
const operands = [torus(), cube(0.5)];
const plain = { relativeTolerance: 0.01, reduce: false };

/** The arrays of a mesh alone. */
const arraysOf = (mesh) =>
  Object.fromEntries(Object.entries(mesh).filter(([, value]) => ArrayBuffer.isView(value)));

const anew = async (place, options = plain) =>
  (await boolean('difference', operands, { ...options, transforms: [null, place] })).mesh;

test.each([plain, { relativeTolerance: 0.01 }])(
  'updates give the bytes of a new operation: %j',
  async (options) => {
    const open = openBooleanScene('difference', operands, options);
    const scene = (await load()).booleanScene('difference', operands, options);
    for (const place of places) {
      const expected = arraysOf(await anew(place, options));
      const { mesh, report } = await open.update(1, place);
      expect(arraysOf(mesh)).toEqual(expected);
      expect(report.thread).toBe('worker');
      expect(report.operands).toHaveLength(2);
      expect(report.output.twoManifold).toBe(true);
      const made = scene.update(1, place);
      expect(arraysOf(made)).toEqual(expected);
      expect(made.report.warnings).toEqual(report.warnings);
      expect(made.reduce === undefined).toBe(options.reduce === false);
    }
    open.close();
    scene.delete();
  },
);

test('operands are at first where transforms say, and go back to where their meshes have them', async () => {
  const scene = (await load()).booleanScene('difference', operands, {
    ...plain,
    transforms: [null, places[0]],
  });
  const expected = await anew(places[0]);
  expect(scene.make().positions).toEqual(expected.positions);
  expect(scene.update(1, null).positions).toEqual((await anew(null)).positions);
  scene.place(1, places[0]);
  expect(scene.make().positions).toEqual(expected.positions);
  scene.delete();
});

test('calls wait for each other, and each has the newest places', async () => {
  const scene = openBooleanScene('difference', operands, plain);
  const results = await Promise.all([scene.update(1, places[0]), scene.update(1, places[1])]);
  const expected = (await anew(places[1])).positions;
  for (const { mesh } of results) expect(mesh.positions).toEqual(expected);
  scene.close();
});

test('what was stopped or refused goes on', async () => {
  const scene = openBooleanScene('intersection', operands, plain);
  await scene.update(1, places[0]);
  await expect(scene.update(1, movedBy(9, 0, 0))).rejects.toMatchObject({ code: 'EMPTY_RESULT' });
  await expect(scene.update(1, places[1], { onProgress: () => false })).rejects.toMatchObject({
    code: 'ABORTED',
  });
  const stopped = new AbortController();
  const update = scene.update(1, places[1], { signal: stopped.signal });
  stopped.abort();
  await expect(update).rejects.toMatchObject({ code: 'ABORTED' });
  const { mesh } = await scene.make();
  const { mesh: expected } = await boolean('intersection', operands, {
    ...plain,
    transforms: [null, places[1]],
  });
  expect(mesh.positions).toEqual(expected.positions);
  scene.close();
});

test('without workers the calling thread has the scene', async () => {
  const scene = openBooleanScene('difference', operands, { ...plain, worker: false });
  for (const place of places.slice(0, 2)) {
    const { mesh, report } = await scene.update(1, place);
    expect(report.thread).toBe('main');
    expect(mesh.positions).toEqual((await anew(place)).positions);
  }
  await expect(scene.update(1, places[2], { onProgress: () => false })).rejects.toMatchObject({
    code: 'ABORTED',
  });
  expect(volume((await scene.make()).mesh)).toBeCloseTo(volume(await anew(places[2])), 6);
  scene.close();
});

test('closed and deleted scenes say so, and close() closes all', async () => {
  const scene = openBooleanScene('union', operands, plain);
  const { mesh } = await scene.make();
  expect(mesh.indices.length).toBeGreaterThan(0);
  const pending = scene.make();
  scene.close();
  scene.close();
  await expect(pending).rejects.toMatchObject({ code: expect.stringMatching(/ABORTED|DELETED/) });
  await expect(scene.make()).rejects.toMatchObject({ code: 'DELETED' });
  await expect(scene.update(1, null)).rejects.toMatchObject({ code: 'DELETED' });
  const other = openBooleanScene('union', operands, plain);
  await other.make();
  await close();
  await expect(other.make()).rejects.toMatchObject({ code: 'DELETED' });

  const synchronous = (await load()).booleanScene('union', operands, plain);
  synchronous.delete();
  synchronous.delete();
  expect(() => synchronous.make()).toThrow(expect.objectContaining({ code: 'DELETED' }));
  expect(() => synchronous.place(0, null)).toThrow(expect.objectContaining({ code: 'DELETED' }));
});

test('what is wrong is told at once', async () => {
  const scene = openBooleanScene('union', operands, plain);
  expect(() => scene.place(2, null)).toThrow('operand: expected a whole number from 0 to 1, got 2');
  expect(() => scene.place(0.5, null)).toThrow('got 0.5');
  expect(() => scene.place(0, [1])).toThrow('transform: expected 16 numbers');
  await expect(scene.update(1, Array(16).fill(NaN))).rejects.toThrow(
    'transform: a number of it is NaN',
  );
  scene.close();
  const refused = { code: 'INVALID_OPTION' };
  for (const options of [
    { onProgress: () => true },
    { signal: null },
    { depht: 3 },
    {
      worker: {
        postMessage() {},
        terminate() {},
      },
    },
  ]) {
    expect(() => openBooleanScene('union', operands, options)).toThrow(
      expect.objectContaining(refused),
    );
  }
  expect(() => openBooleanScene('union', operands, null)).toThrow(expect.objectContaining(refused));
  const kdm = await load();
  expect(() => kdm.booleanScene('union', operands, { onProgress: () => true })).toThrow(
    'onProgress',
  );
  expect(() => kdm.booleanScene('union', [])).toThrow('operands: expected an array');
});

test('forgotten memory: what scenes held is given back', async () => {
  const kdm = await load();
  const used = () => kdm.memory().usedBytes;
  const make = () => {
    const scene = kdm.booleanScene('difference', operands, plain);
    for (const place of places) scene.update(1, place);
    scene.delete();
  };
  make();
  const before = used();
  for (let i = 0; i < 3; ++i) make();
  expect(used()).toBeLessThanOrEqual(before + 1024);
});
