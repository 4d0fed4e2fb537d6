// SPDX-License-Identifier: MIT
// Fewer triangles: makeManifold reduces within its tolerance, Grid.extract within a distance of the
// grid's own surface, simplifyMesh any mesh.
import { load, makeManifold, simplifyMesh } from '../../dist/index.js';
import { asSoup, cube, faults, together, torus, volume } from './support/meshes.js';

const { AbortSignal } = globalThis;
let kdm;
beforeAll(async () => {
  kdm = await load();
});

const count = ({ indices }) => indices.length / 3;
const sound = (mesh) => {
  expect(faults(mesh)).toEqual([]);
  expect(kdm.findSelfIntersections(mesh).pairs).toBe(0);
  expect(mesh.sourceFaces).toHaveLength(count(mesh));
};
const arraysOf = ({ positions, indices, sourceFaces }) => [positions, indices, sourceFaces];

test('makeManifold gives few triangles, and the account speaks of the tolerance asked for', async () => {
  const few = await makeManifold(torus(), { tolerance: 0.1 });
  const all = await makeManifold(torus(), { tolerance: 0.1, reduce: false });
  for (const { mesh, report, levels } of [few, all]) {
    sound(mesh);
    expect(levels).toEqual([]);
    expect(report.grid.askedTolerance).toBe(0.1);
    expect(report.grid.tolerance).toBeCloseTo(0.1, 7);
    expect(report.output.triangles).toBe(count(mesh));
  }
  expect(2 * count(few.mesh)).toBeLessThan(count(all.mesh));
  const { trianglesBefore, triangles, collapses } = few.report.reduce;
  expect(triangles).toBe(count(few.mesh));
  expect(trianglesBefore).toBeGreaterThan(triangles);
  expect(collapses).toBeGreaterThan(0);
  expect(few.report.seconds.reduce).toBeGreaterThan(0);
  expect(all.report.reduce).toBeNull();
  expect(all.report.seconds.reduce).toBe(0);
});

test('without reduction makeManifold gives what the grid gives', async () => {
  const { mesh } = await makeManifold(torus(), { tolerance: 0.1, reduce: false });
  const grid = kdm.buildGrid(torus(), { tolerance: 0.1 });
  expect(arraysOf(mesh)).toEqual(arraysOf(grid.extract()));
  grid.delete();
});

test('several numbers make several levels', async () => {
  const targetTriangles = [400, 300];
  const { mesh, levels, report } = await makeManifold(torus(), { tolerance: 0.5, targetTriangles });
  expect(levels).toHaveLength(2);
  levels.forEach((level, i) => {
    sound(level);
    expect(count(level)).toBeLessThanOrEqual(targetTriangles[i]);
  });
  expect(arraysOf(mesh)).toEqual(arraysOf(levels[1]));
  expect(report.reduce.triangles).toBe(count(mesh));
  const one = await makeManifold(torus(), { tolerance: 0.5, targetTriangles: 300 });
  expect(one.levels).toHaveLength(1);
  expect(arraysOf(one.mesh)).toEqual(arraysOf(mesh));
});

test('levels tell how far they are from the input', async () => {
  const options = { tolerance: 0.5, targetTriangles: [400, 300] };
  const { mesh, levels } = await makeManifold(torus(), options);
  const own = kdm.simplifyMesh(torus(), { targetTriangles: [600, 200] });
  const grid = kdm.buildGrid(torus(), { tolerance: 0.05 });
  const extracted = grid.extract({ reduce: { targetTriangles: [600, 200] } });
  for (const of of [levels, own.levels, extracted.levels]) {
    const [fine, coarse] = of.map(({ error }) => error);
    for (const side of ['toInput', 'toOutput']) {
      expect(fine[side].rms).toBeGreaterThan(0);
      expect(coarse[side].rms).toBeGreaterThan(fine[side].rms);
      expect(coarse[side].largest).toBeGreaterThan(coarse[side].rms);
      expect(coarse[side].largest).toBeLessThan(0.6);
    }
  }
  const { error } = grid.compare(torus(), mesh, { error: true });
  expect(levels[1].error.toInput.largest).toBeCloseTo(error.toInput.largest, 2);
  expect(levels[1].error.toOutput.rms).toBeCloseTo(error.toOutput.rms, 2);
  grid.delete();
});

test('groups stay apart in every way of reducing', async () => {
  const mesh = torus(64, 32);
  const group = (triangle) => (mesh.positions[3 * mesh.indices[3 * triangle]] > 0.2 ? 4 : 9);
  const keepGroups = Uint32Array.from({ length: count(mesh) }, (_, t) => group(t));
  const areas = ({ positions, indices, sourceFaces }) => {
    const sums = { 4: 0, 9: 0 };
    for (let t = 0; t < indices.length / 3; ++t) {
      const part = { positions, indices: indices.slice(3 * t, 3 * t + 3) };
      sums[keepGroups[sourceFaces?.[t] ?? t]] += kdm.describe(part).area;
    }
    return sums;
  };
  const whole = areas(mesh);
  const grid = kdm.buildGrid(mesh, { tolerance: 0.02 });
  const made = [
    (await makeManifold(mesh, { tolerance: 0.05, keepGroups })).mesh,
    (await simplifyMesh(mesh, { error: 0.05, keepGroups: [...keepGroups] })).mesh,
    kdm.simplifyMesh(mesh, { error: 0.05, keepGroups }).mesh,
    grid.extract({ reduce: { error: 0.05, keepGroups } }),
  ];
  grid.delete();
  for (const few of made) {
    sound(few);
    const found = areas(few);
    for (const name of [4, 9]) expect(found[name] / whole[name]).toBeCloseTo(1, 1);
  }
  expect(areas(made[1])[4] / whole[4]).toBeCloseTo(1, 2);
});

test.each([
  [Array(11).fill(1), '`keepGroups`: it has 11 entries, but there is a face 11'],
  [[], 'keepGroups: expected whole numbers from 0 on, but it is empty'],
  [[1, -2], 'keepGroups: expected whole numbers from 0 on, but keepGroups[1] is -2'],
  [[1, 'red'], 'keepGroups: expected whole numbers from 0 on, but keepGroups[1] is red'],
  [true, 'keepGroups: expected an array of whole numbers, one a face, got boolean'],
  [
    new Float32Array(12),
    'keepGroups: expected an array of whole numbers, one a face, got Float32Array',
  ],
])('groups that are none are refused: %j', async (keepGroups, message) => {
  const box = cube();
  for (const work of [
    () => makeManifold(box, { keepGroups }),
    () => simplifyMesh(box, { error: 1, keepGroups }),
  ]) {
    expect(await work().catch((error) => error)).toMatchObject({ code: 'INVALID_OPTION', message });
  }
});

test.each([
  [{ reduce: true, quads: true }, 'reduce: not together with `quads`'],
  [{ targetTriangles: 9, quads: true }, 'targetTriangles: not together with `quads`'],
  [{ reduce: true, strict: 'off' }, 'reduce: not together with `strict` off'],
  [{ reduce: true, strategy: 'octree', cells: 9 }, 'reduce: not together with `cells`'],
  [{ reduce: true, strategy: 'uniform' }, 'reduce: not together with `strategy` uniform'],
  [
    { targetTriangles: [9], strategy: 'median' },
    'targetTriangles: not together with `strategy` median',
  ],
  [{ reduce: true, relativeTolerance: 0 }, 'reduce: not together with `relativeTolerance` 0'],
  [{ reduce: false, targetTriangles: 9 }, 'targetTriangles: not together with `reduce` false'],
  [
    { targetTriangles: [9, 9] },
    'targetTriangles: expected whole numbers from 1 on, each smaller than the one before, got 9,9',
  ],
  [{ keepGroups: [1], quads: true }, '`keepGroups`: not together with `quads`'],
  [{ keepGroups: [1], reduce: false }, '`keepGroups`: not together with `reduce` false'],
])('what excludes reduction is told: %j', async (options, message) => {
  const error = await makeManifold(cube(), options).catch((caught) => caught);
  expect(error).toMatchObject({ code: 'INVALID_OPTION', message });
});

test('what excludes reduction leaves it out where nobody asked for it', async () => {
  const sets = [{ quads: true }, { strict: 'off' }, { strategy: 'uniform', depth: 9 }];
  for (const options of sets) {
    expect((await makeManifold(cube(), options)).report.reduce).toBeNull();
  }
});

test('Grid.extract reduces within a distance of its own surface', () => {
  const grid = kdm.buildGrid(torus(), { tolerance: 0.05 });
  const own = grid.extract({ strict: 'embedded' });
  const seen = [];
  const few = grid.extract({
    reduce: { error: 0.2, targetTriangles: [400, 250] },
    onProgress: (fraction) => void seen.push(fraction),
  });
  sound(few);
  expect(few.levels.map(count).at(-1)).toBe(count(few));
  expect(few.reduce.trianglesBefore).toBe(count(own));
  expect(few.report.crossings).toBe(0);
  expect(seen).toEqual([...seen].sort((a, b) => a - b));
  expect(grid.extract().levels).toBeUndefined();
  const refused = (options) => () => grid.extract(options);
  expect(refused({ reduce: {} })).toThrow('error: expected a number above 0');
  expect(refused({ reduce: { error: 1, depth: 3 } })).toThrow('depth: no such option');
  expect(refused({ reduce: { error: 1 }, quads: true })).toThrow('`reduce`: not together with');
  grid.delete();
});

test('simplifyMesh takes a sound mesh as it is, on both threads alike', async () => {
  const options = { error: 0.1, targetTriangles: [500, 300] };
  const here = kdm.simplifyMesh(torus(), options);
  const there = await simplifyMesh(torus(), options);
  for (const { mesh, levels, report } of [here, there]) {
    [mesh, ...levels].forEach(sound);
    expect(report).toMatchObject({ trianglesBefore: 1024, rebuilt: false, warnings: [] });
    expect(report.triangles).toBe(count(mesh));
    expect(volume(mesh)).toBeGreaterThan(0.9 * volume(torus()));
  }
  expect(arraysOf(there.mesh)).toEqual(arraysOf(here.mesh));
  expect(there.report).toMatchObject({ thread: 'worker', seconds: expect.any(Number) });
  const joined = kdm.simplifyMesh(asSoup(torus()), { error: 0.1 });
  expect(joined.report).toMatchObject({ trianglesBefore: 1024, rebuilt: false });
});

test('simplifyMesh makes any other mesh sound first', async () => {
  const { positions, indices } = cube();
  for (const mesh of [
    { positions, indices: indices.slice(6) },
    together(cube(), cube(2, [1, 1, 1])),
  ]) {
    for (const options of [{ error: 0.05 }, { targetTriangles: 60 }]) {
      const made = await simplifyMesh(mesh, options);
      sound(made.mesh);
      expect(made.report.rebuilt).toBe(true);
      expect(count(made.mesh)).toBeLessThanOrEqual(60);
    }
  }
});

test('simplifyMesh is told how far, tells how far it is, and can be stopped', async () => {
  const refused = (options) => simplifyMesh(cube(), options).catch(({ message }) => message);
  expect(await refused({})).toBe(
    'error: expected a number above 0, unless targetTriangles is given',
  );
  expect(await refused({ error: -1 })).toBe('error: expected a number from 0 on, got -1');
  expect(await refused({ error: 1, tolerance: 1 })).toBe('tolerance: no such option');
  const seen = [];
  const onProgress = (fraction) => void seen.push(fraction);
  await simplifyMesh(torus(128, 64), { error: 0.05, onProgress });
  expect(seen.at(-1)).toBe(1);
  expect(seen).toEqual([...seen].sort((a, b) => a - b));
  const signal = AbortSignal.timeout(50);
  await expect(simplifyMesh(torus(512, 256), { error: 0.01, signal })).rejects.toMatchObject({
    name: 'TimeoutError',
  });
  const taken = torus();
  await simplifyMesh(taken, { targetTriangles: 500, transfer: true });
  expect(taken.positions).toHaveLength(0);
});
