// SPDX-License-Identifier: MIT
// The solids of the paper's figures are what `npm run figures` takes them for.
import {
  battlement,
  box,
  cubes,
  inwards,
  revolved,
  turnedBy,
  vase,
} from '../evaluate/paper_shapes.mjs';
import { drill, turnedTwice } from '../bench/turned_twice.mjs';
import { cube, eulerCharacteristic, faults, volume } from './support/meshes.js';

const triangles = ({ indices }) => indices.length / 3;

test('a profile that is turned about the axis is a closed solid', () => {
  const cylinder = revolved([[0, 0], [2, 0], [2, 3], [0, 3]], 256); // prettier-ignore
  expect(faults(cylinder)).toEqual([]);
  expect(eulerCharacteristic(cylinder)).toBe(2);
  expect(volume(cylinder) / (12 * Math.PI)).toBeCloseTo(1, 3);
});

test('the vase is one closed part with a wall of one thickness', () => {
  const sides = 96;
  const wall = 0.04;
  const mesh = vase(wall, { sides });
  expect(faults(mesh)).toEqual([]);
  expect(eulerCharacteristic(mesh)).toBe(2);
  const points = Array.from({ length: mesh.positions.length / 3 }, (_, i) => {
    const [x, y, z] = mesh.positions.subarray(3 * i, 3 * i + 3);
    return [Math.hypot(x, y), z];
  });
  const outside = points.slice(1, 1 + 49 * sides);
  const inside = points.slice(1 + 49 * sides, -1);
  expect(points.filter(([radius]) => radius === 0)).toEqual([
    [0, 0],
    [0, expect.closeTo(wall, 6)],
  ]);
  // Of every ring of the inside the nearest point of the outside, between rings too.
  const rings = (part) => part.filter((_, i) => i % sides === 0);
  const gaps = rings(inside).map(([radius, z]) =>
    Math.min(
      ...rings(outside)
        .slice(1)
        .map(([r1, z1], i) => {
          const [r0, z0] = rings(outside)[i];
          const [dr, dz] = [r1 - r0, z1 - z0];
          const share = ((radius - r0) * dr + (z - z0) * dz) / (dr * dr + dz * dz);
          const t = Math.min(1, Math.max(0, share));
          return Math.hypot(radius - r0 - t * dr, z - z0 - t * dz);
        }),
    ),
  );
  expect(Math.min(...gaps)).toBeGreaterThan(0.95 * wall);
  expect(Math.max(...gaps)).toBeLessThan(1.05 * wall);
  expect(Math.max(...points.map(([, z]) => z))).toBe(2);
});

test('the battlement has the volume of its cubes, and no face along an axis', () => {
  for (const merlons of [1, 2, 3, 5]) {
    const mesh = battlement(merlons);
    expect(faults(mesh)).toEqual([]);
    expect(eulerCharacteristic(mesh)).toBe(2);
    expect(volume(mesh)).toBeCloseTo(2 * merlons - 1 + merlons, 10);
    const size = 2 * merlons - 1;
    expect(triangles(mesh)).toBe(2 * (2 * size + 2 * size + 2 + 4 * merlons));
    for (let axis = 0; axis < 3; ++axis) {
      const heights = mesh.positions.filter((_, i) => i % 3 === axis).map((x) => x.toFixed(9));
      expect(new Set(heights).size).toBe(mesh.positions.length / 3);
    }
  }
});

test('cubes in a ring have a tunnel, and a box turned inwards takes its volume away', () => {
  const ring = [0, 1, 2]
    .flatMap((x) => [0, 1, 2].map((y) => [x, y, 0]))
    .filter(([x, y]) => x !== 1 || y !== 1);
  const mesh = cubes(ring, (point) => point);
  expect(faults(mesh)).toEqual([]);
  expect([volume(mesh), eulerCharacteristic(mesh)]).toEqual([8, 0]);
  const block = box([0, -1, 2], [1, 2, 4]);
  expect(faults(block)).toEqual([]);
  expect(volume(block)).toBeCloseTo(6, 10);
  expect(faults(inwards(block))).toEqual([]);
  expect(volume(inwards(block))).toBeCloseTo(-6, 10);
});

test('a quaternion turns points and leaves their lengths', () => {
  expect(turnedBy([1, 0, 0, 1])([1, 2, 3])).toEqual([-2, 1, 3].map((x) => expect.closeTo(x, 12)));
  expect(Math.hypot(...turnedBy([7, 1, -2, 3])([1, 2, 3]))).toBeCloseTo(Math.hypot(1, 2, 3), 12);
});

test('a model, the same turned about its upright axis, and a cylinder through it', () => {
  const model = cube(2, [5, 1, 0]);
  const bounds = { min: [4, 0, -1], max: [6, 2, 1] };
  const [same, turned, cylinder] = turnedTwice(model, bounds, 90);
  expect(same.positions).toEqual(model.positions);
  for (const mesh of [turned, cylinder]) expect(faults(mesh)).toEqual([]);
  expect(volume(turned)).toBeCloseTo(8, 5);
  // A quarter of a turn: x becomes -z, and z becomes x, round the middle.
  model.positions.forEach((x, i) => {
    const at = 3 * Math.floor(i / 3);
    const [px, py, pz] = [0, 1, 2].map((k) => model.positions[at + k] - [5, 1, 0][k]);
    expect(turned.positions[i]).toBeCloseTo([5 + pz, 1 + py, -px][i % 3], 5);
  });
  const sides = 64;
  const circle = (sides / 2) * Math.sin((2 * Math.PI) / sides);
  expect(volume(drill(2, 3, sides))).toBeCloseTo(12 * circle, 4);
  const size = Math.hypot(2, 2, 2);
  expect(volume(cylinder)).toBeCloseTo(circle * (size / 12) ** 2 * 2 * size, 4);
});
