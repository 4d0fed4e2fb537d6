// SPDX-License-Identifier: MIT
// Nothing leaks: neither a thousand good conversions nor a hundred failures make the heap grow.
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { load } from '../../dist/index.js';
import { cube, torus } from './support/meshes.js';

let kdm;
beforeAll(async () => {
  kdm = await load();
});

function round(mesh) {
  const grid = kdm.buildGrid(mesh, { strategy: 'octree', depth: 12 });
  grid.extract();
  kdm.loadGrid(grid.save()).delete();
  kdm.describe(mesh);
  grid.delete();
}

test('1,000 rounds of build, extract and delete', () => {
  const mesh = torus();
  for (let i = 0; i < 20; ++i) round(mesh);
  const before = kdm.memory();
  for (let i = 0; i < 1000; ++i) round(mesh);
  expect(kdm.memory()).toEqual(before);
});

test('100 failures of each kind', () => {
  const mesh = torus();
  const open = { positions: mesh.positions, indices: mesh.indices.slice(3) };
  const cut = kdm.formatMesh(mesh, 'stl').slice(0, 1000);
  const grid = kdm.buildGrid(mesh);
  const damaged = grid.save();
  grid.delete();
  damaged[damaged.length - 9] ^= 1;
  const failures = [
    () => kdm.buildGrid(open, { inside: 'positive' }),
    () => kdm.buildGrid({ ...open, indices: open.indices.slice(0, 3) }),
    () => kdm.buildGrid(open, { onProgress: (fraction) => fraction < 0.9 }),
    () => kdm.buildGrid(mesh, { onProgress: () => false }),
    () => kdm.buildGrid(mesh, { onProgress: (fraction) => fraction < 0.3 }),
    () => kdm.parseMesh(cut, 'stl'),
    () => kdm.loadGrid(damaged),
    () => kdm.parseMesh('f 1 2 3', 'obj'),
  ];
  const fail = () => failures.forEach((failure) => expect(failure).toThrow());
  fail();
  const before = kdm.memory();
  for (let i = 0; i < 100; ++i) fail();
  expect(kdm.memory()).toEqual(before);
});

test('the heap serves again after memory has run out', async () => {
  // On an instance of its own, whose heap may be as large as it gets.
  const own = await (await import('../../build/js/load.js?own')).load();
  const before = own.memory().usedBytes;
  for (const bytes of [4_200_000_000, 1_000_000_000]) {
    expect(() => own.parseMesh(new Uint8Array(bytes), 'ply')).toThrow();
    expect(own.memory().usedBytes).toBe(before);
  }
  expect(own.memory().heapBytes).toBeGreaterThan(1_000_000_000);
  own.buildGrid(cube()).delete();
  expect(own.memory().usedBytes).toBe(before);
});

test('a grid nobody holds any more is freed by the garbage collector', async () => {
  setFlagsFromString('--expose-gc');
  const gc = runInNewContext('gc');
  const pause = () => new Promise((resolve) => setTimeout(resolve, 20));
  // What earlier tests left may still be held.
  for (let i = 0; i < 10; ++i) {
    gc();
    await pause();
  }
  const before = kdm.memory().usedBytes;
  (() => kdm.buildGrid(torus(128, 64), { strategy: 'uniform', depth: 18 }))();
  expect(kdm.memory().usedBytes).toBeGreaterThan(before);
  for (let i = 0; i < 50 && kdm.memory().usedBytes > before; ++i) {
    gc();
    await pause();
  }
  expect(kdm.memory().usedBytes).toBe(before);
});
