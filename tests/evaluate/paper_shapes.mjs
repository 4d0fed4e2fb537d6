// SPDX-License-Identifier: MIT
// The solids that the paper's figures show and nobody publishes, made anew: a thin vase (figure 14) and a battlement
// (figure 15). All are closed 2-manifolds, turned outwards.

/**
 * The solid that a profile sweeps about the z axis: points [radius, z] from axis to axis, what is outside of it to the
 * right. The first and the last point have the radius 0, no other has.
 */
export function revolved(profile, sides) {
  const positions = [];
  const rings = profile.map(([radius, z]) => {
    const first = positions.length / 3;
    const count = radius === 0 ? 1 : sides;
    for (let side = 0; side < count; ++side) {
      const angle = (2 * Math.PI * side) / sides;
      positions.push(radius * Math.cos(angle), radius * Math.sin(angle), z);
    }
    return (side) => first + (side % count);
  });
  const indices = [];
  for (let ring = 0; ring + 1 < rings.length; ++ring) {
    const [here, next] = [rings[ring], rings[ring + 1]];
    for (let side = 0; side < sides; ++side) {
      const [a, b] = [here(side), here(side + 1)];
      const [c, d] = [next(side + 1), next(side)];
      if (a !== b) indices.push(a, b, c);
      if (c !== d) indices.push(a, c, d);
    }
  }
  return { positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
}

/** A vase of height 2 on the plane z = 0, open above: bottom and side are walls of one thickness. */
export function vase(wall, { rings = 48, sides = 96 } = {}) {
  const height = 2;
  const outer = (z) => 0.5 + 0.18 * Math.sin(0.4 + 2.6 * z);
  const slope = (z) => 0.18 * 2.6 * Math.cos(0.4 + 2.6 * z);
  // Across the wall, not along the radius.
  const inner = (z) => outer(z) - wall * Math.hypot(1, slope(z));
  const levels = (from) =>
    Array.from({ length: rings + 1 }, (_, i) => from + ((height - from) * i) / rings);
  const outside = levels(0).map((z) => [outer(z), z]);
  const inside = levels(wall).map((z) => [inner(z), z]);
  return revolved([[0, 0], ...outside, ...inside.reverse(), [0, wall]], sides);
}

/** A box between two corners. */
export function box(low, high) {
  return cubes([[0, 0, 0]], (point) => point.map((x, k) => low[k] + x * (high[k] - low[k])));
}

/** The same surface, turned inwards: a cavity. */
export const inwards = ({ positions, indices }) => ({ positions, indices: indices.toReversed() });

/**
 * A wall of as many merlons and the gaps between them, of cubes of side 1: every face of a cube that is seen is two
 * triangles, however flat the wall is there. It is turned so that none of its faces is parallel to an axis.
 */
export function battlement(merlons = 3, map = turnedBy([7, 1, -2, 3])) {
  const length = 2 * merlons - 1;
  const base = Array.from({ length }, (_, x) => [x, 0, 0]);
  const above = Array.from({ length: merlons }, (_, i) => [2 * i, 0, 1]);
  return cubes([...base, ...above], map);
}

/** The surface of unit cubes, each named by its lowest corner; `map` takes its points elsewhere. */
export function cubes(cells, map) {
  const filled = new Set(cells.map(String));
  const numbers = new Map();
  const positions = [];
  const vertex = (point) => {
    const name = String(point);
    if (!numbers.has(name)) {
      numbers.set(name, numbers.size);
      positions.push(...map(point));
    }
    return numbers.get(name);
  };
  const indices = [];
  for (const cell of cells) {
    for (const [axis, side] of [0, 1, 2].flatMap((k) => [
      [k, 0],
      [k, 1],
    ])) {
      const moved = (steps) => cell.map((x, k) => x + steps[(k - axis + 3) % 3]);
      if (filled.has(String(moved([2 * side - 1, 0, 0])))) continue;
      const square = [
        [side, 0, 0],
        [side, 1, 0],
        [side, 1, 1],
        [side, 0, 1],
      ].map((steps) => vertex(moved(steps)));
      const [a, b, c, d] = side === 1 ? square : square.toReversed();
      indices.push(a, b, c, a, c, d);
    }
  }
  return { positions: Float64Array.from(positions), indices: Uint32Array.from(indices) };
}

/** Turns points as a quaternion (w, x, y, z) of any length says. */
export function turnedBy(quaternion) {
  const [w, x, y, z] = quaternion.map((part) => part / Math.hypot(...quaternion));
  const matrix = [
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ];
  return (point) => matrix.map((row) => row.reduce((sum, m, k) => sum + m * point[k], 0));
}
