// SPDX-License-Identifier: MIT
// Corners of rotated cubes: how far each true corner is from the nearest vertex of the result, in
// cells of the grid. `octree` at 64 cells an axis (depth 18), not stopped by any tolerance, must
// stay within 0.05; meshoptimizer's remesher at 64 stands beside it.
import { load } from '../../../dist/index.js';
import { meshoptimizer } from '../../bench/engines.mjs';
import { printTable } from '../../bench/shared.mjs';
import { turnedBy } from '../paper_shapes.mjs';

const cellsPerAxis = 64;
const limit = 0.05;

export default async function corner() {
  const kdm = await load();
  const rows = [];
  const worst = { octree: 0, remesh: 0, 'remesh, solve': 0 };
  for (const rotation of rotations()) {
    const cube = rotatedCube(rotation);
    const grid = kdm.buildGrid(cube, { strategy: 'octree', depth: 18, relativeTolerance: 0 });
    const cell = (grid.input.latticeStep * 2 ** 20) / cellsPerAxis; // the root cell is a cube
    const { positions } = grid.extract();
    grid.delete();
    const found = { octree: gap(cube.positions, positions) / cell };
    for (const flags of [[], ['Solve']]) {
      const peer = await meshoptimizer(cube, cellsPerAxis, flags);
      const name = flags.length > 0 ? 'remesh, solve' : 'remesh';
      const peerCell = extent(cube.positions) / cellsPerAxis;
      found[name] = gap(cube.positions, peer.mesh.positions) / peerCell;
    }
    for (const [name, value] of Object.entries(found)) worst[name] = Math.max(worst[name], value);
    rows.push(row(rotation.map((x) => x.toFixed(2)).join(' '), found));
  }
  rows.push(row('worst', worst));
  console.log(`largest gap at a corner, in cells, ${cellsPerAxis} cells an axis:`);
  printTable(rows);
  const holds = worst.octree <= limit;
  console.log(`octree ${holds ? 'within' : 'NOT within'} ${limit} cells`);
  return { rows, failures: holds ? 0 : 1 };
}

const row = (rotation, gaps) => ({
  rotation,
  ...Object.fromEntries(Object.entries(gaps).map(([name, value]) => [name, value.toFixed(4)])),
});

// Unit quaternions (w, x, y, z) from small integers, none of which leaves a face axis-parallel.
function rotations() {
  const integers = [
    [4, 1, 2, 3],
    [5, 2, 1, 1],
    [3, 1, 1, 2],
    [7, 1, -2, 3],
    [6, 3, 2, -1],
    [9, 1, 2, 1],
    [5, -3, 1, 2],
    [8, 2, 3, 5],
  ];
  return integers.map((q) => q.map((x) => x / Math.hypot(...q)));
}

function rotatedCube(quaternion) {
  const turn = turnedBy(quaternion);
  const corners = Array.from({ length: 8 }, (_, n) => turn([n & 1, (n >> 1) & 1, n >> 2]));
  const faces = [
    ...[0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4],
    ...[2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5],
  ];
  return { positions: Float64Array.from(corners.flat()), indices: Uint32Array.from(faces) };
}

/** The largest distance from one of `points` to the nearest of `others`. */
function gap(points, others) {
  let largest = 0;
  for (let i = 0; i < points.length; i += 3) {
    let nearest = Infinity;
    for (let j = 0; j < others.length; j += 3) {
      const distance = Math.hypot(
        points[i] - others[j],
        points[i + 1] - others[j + 1],
        points[i + 2] - others[j + 2],
      );
      nearest = Math.min(nearest, distance);
    }
    largest = Math.max(largest, nearest);
  }
  return largest;
}

function extent(positions) {
  const lengths = [0, 1, 2].map((axis) => {
    const values = positions.filter((_, i) => i % 3 === axis);
    return Math.max(...values) - Math.min(...values);
  });
  return Math.max(...lengths);
}
