// SPDX-License-Identifier: MIT
// How far a point is from a triangle.

/** The square of the distance from the triangle whose nine coordinates stand in `corners` from `at` on. */
export function squaredDistance(
  corners: Float64Array,
  at: number,
  x: number,
  y: number,
  z: number,
): number {
  const ax = corners[at] as number;
  const ay = corners[at + 1] as number;
  const az = corners[at + 2] as number;
  const ux = (corners[at + 3] as number) - ax;
  const uy = (corners[at + 4] as number) - ay;
  const uz = (corners[at + 5] as number) - az;
  const vx = (corners[at + 6] as number) - ax;
  const vy = (corners[at + 7] as number) - ay;
  const vz = (corners[at + 8] as number) - az;
  const px = x - ax;
  const py = y - ay;
  const pz = z - az;
  const uu = ux * ux + uy * uy + uz * uz;
  const uv = ux * vx + uy * vy + uz * vz;
  const vv = vx * vx + vy * vy + vz * vz;
  const up = ux * px + uy * py + uz * pz;
  const vp = vx * px + vy * py + vz * pz;
  // The point is near s u + t v; where that lies outside, it is nearest to one of the sides.
  const squaredTo = (s: number, t: number): number => {
    const dx = px - s * ux - t * vx;
    const dy = py - s * uy - t * vy;
    const dz = pz - s * uz - t * vz;
    return dx * dx + dy * dy + dz * dz;
  };
  const determinant = uu * vv - uv * uv;
  const s = vv * up - uv * vp;
  const t = uu * vp - uv * up;
  if (determinant > 0 && s > 0 && t > 0 && s + t < determinant) {
    return squaredTo(s / determinant, t / determinant);
  }
  const w = share(vp - up + uu - uv, uu - 2 * uv + vv);
  return Math.min(squaredTo(share(up, uu), 0), squaredTo(0, share(vp, vv)), squaredTo(1 - w, w));
}

// How far along a side, from 0 to 1.
const share = (dot: number, length: number): number =>
  length > 0 ? Math.min(Math.max(dot / length, 0), 1) : 0;
