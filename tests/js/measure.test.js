// SPDX-License-Identifier: MIT
// What the demo page measures by itself: distances between surfaces, at points all over them.
import { join } from 'node:path';
import { build } from 'esbuild';
import { asSoup, cube, torus } from './support/meshes.js';
import { root } from './support/paths.js';

let BoxTree;
let Reference;
let tessellate;

beforeAll(async () => {
  const names = ['box-tree', 'measure', 'tessellate'];
  const outdir = join(root, 'build/demo-tests/measure');
  const entryPoints = names.map((name) => join(root, `web/demo/${name}.ts`));
  const outExtension = { '.js': '.mjs' };
  await build({ entryPoints, outdir, outExtension, bundle: true, format: 'esm' });
  const modules = await Promise.all(names.map((name) => import(join(outdir, `${name}.mjs`))));
  ({ BoxTree, Reference, tessellate } = Object.assign({}, ...modules));
});

// The same numbers each time.
function* numbers(seed) {
  for (let state = seed; ;) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    yield state / 2 ** 32;
  }
}
const take = (source, count) => Array.from({ length: count }, () => source.next().value);

// No cleverness: the least over a fine net of points on the triangle, and a bound for what lies between.
function nearestOnNet(corners, point, steps) {
  let least = Infinity;
  for (let i = 0; i <= steps; ++i) {
    for (let j = 0; j <= steps - i; ++j) {
      const [s, t] = [i / steps, j / steps];
      const at = [0, 1, 2].map(
        (k) => (1 - s - t) * corners[k] + s * corners[3 + k] + t * corners[6 + k],
      );
      least = Math.min(least, Math.hypot(...at.map((value, k) => value - point[k])));
    }
  }
  return least;
}

test('the tree finds what trying every triangle finds', () => {
  const source = numbers(7);
  const steps = 40;
  for (const count of [1, 2, 5, 60]) {
    const positions = take(source, 9 * count);
    // One without area, which is a point.
    for (let i = 3; i < 9; ++i) positions[i] = positions[i % 3];
    const tree = new BoxTree(positions, null);
    for (let round = 0; round < 20; ++round) {
      const point = take(source, 3).map((value) => 2 * value - 0.5);
      const tried = Array.from({ length: count }, (_, t) =>
        nearestOnNet(positions.slice(9 * t, 9 * t + 9), point, steps),
      );
      const expected = Math.min(...tried);
      const found = tree.distance(...point);
      expect(found).toBeLessThanOrEqual(expected + 1e-12);
      // Sides are no longer than the square root of 3.
      expect(found).toBeGreaterThan(expected - Math.sqrt(3) / steps);
      expect(tree.distance(...point, found / 2)).toBe(found / 2);
    }
  }
});

test('many equal triangles are no trouble', () => {
  const positions = Array.from({ length: 500 }, () => [0, 0, 0, 1, 0, 0, 0, 1, 0]).flat();
  expect(new BoxTree(positions, null).distance(0.2, 0.2, 3)).toBe(3);
});

test('pieces cover the mesh, own vertices first, and are as many as are allowed', () => {
  const { positions, indices } = torus(8, 5);
  for (const most of [10, 80, 1000, 20_000]) {
    const pieces = tessellate(positions, indices, most);
    expect(pieces.positions.slice(0, positions.length)).toEqual(positions);
    const count = pieces.indices.length / 3;
    expect(count).toBeLessThanOrEqual(Math.max(most, indices.length / 3));
    expect(count).toBeGreaterThan(Math.min(most, indices.length / 3) / 4);
    expect(area(pieces)).toBeCloseTo(area({ positions, indices }), 3);
  }
});

function area({ positions, indices }) {
  let sum = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) =>
      positions.slice(3 * indices[i + k], 3 * indices[i + k] + 3),
    );
    const [u, v] = [b, c].map((p) => [...p].map((value, k) => value - a[k]));
    const normal = [0, 1, 2].map(
      (k) => u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3],
    );
    sum += Math.hypot(...normal) / 2;
  }
  return sum;
}

test('distances are those of spots, not of vertices alone, and go both ways', () => {
  const reference = new Reference(cube(2));
  // A cube of half the size is half a unit away, in each of its corners.
  const heat = reference.heat(cube(1));
  expect(heat.largest).toBeCloseTo(0.5, 6);
  expect(Math.min(...heat.distances)).toBeCloseTo(0.5, 6);
  // From the larger one's corners it is further.
  expect(reference.apart(cube(1))).toBeCloseTo(Math.sqrt(0.75), 6);
  expect(reference.apart(asSoup(cube(2)))).toBeCloseTo(0, 6);
  // A side of the cube is missing from the reference: its middle is 1 away, its corners are not away at all.
  const open = new Reference({ ...cube(2), indices: cube(2).indices.slice(6) });
  const { largest, distances } = open.heat(cube(2));
  expect(largest).toBeGreaterThan(0.97);
  expect([...distances.slice(0, 8)]).toEqual(Array(8).fill(0));
});
