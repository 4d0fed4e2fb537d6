// SPDX-License-Identifier: MIT
// The operands of the paper's figure 16: a model, the same turned about the vertical axis through its middle, and a
// cylinder through that middle, along z.

/**
 * Three meshes in 32 bits, which the peers take too. `bounds` are the model's; the y axis is upright.
 */
export function turnedTwice(model, { min, max }, degrees) {
  const middle = min.map((x, k) => (x + max[k]) / 2);
  const size = Math.hypot(...max.map((x, k) => x - min[k]));
  const angle = (degrees * Math.PI) / 180;
  const [sine, cosine] = [Math.sin(angle), Math.cos(angle)];
  const turned = mapped(model, (p) => {
    const [x, , z] = p.map((value, k) => value - middle[k]);
    return [middle[0] + cosine * x + sine * z, p[1], middle[2] - sine * x + cosine * z];
  });
  const cylinder = mapped(drill(size / 12, 2 * size), (p) => p.map((x, k) => x + middle[k]));
  return [mapped(model, (p) => p), turned, cylinder];
}

/** A cylinder along z through the origin. */
export function drill(radius, length, sides = 64) {
  const ring = Array.from({ length: 2 * sides }, (_, i) => {
    const turn = (2 * Math.PI * (i >> 1)) / sides;
    return [radius * Math.cos(turn), radius * Math.sin(turn), (i % 2 ? 1 : -1) * (length / 2)];
  });
  const ends = [-1, 1].map((end) => [0, 0, (end * length) / 2]);
  const indices = [];
  for (let i = 0; i < sides; ++i) {
    const [a, b, c, d] = [0, 1, 2, 3].map((k) => (2 * i + k) % (2 * sides));
    indices.push(a, c, b, b, c, d, 2 * sides, c, a, 2 * sides + 1, b, d);
  }
  return {
    positions: Float32Array.from([...ring, ...ends].flat()),
    indices: Uint32Array.from(indices),
  };
}

/** The mesh with every point taken to another place. */
function mapped(mesh, map) {
  const positions = new Float32Array(mesh.positions.length);
  for (let i = 0; i < positions.length; i += 3) {
    positions.set(map([...mesh.positions.subarray(i, i + 3)]), i);
  }
  return { positions, indices: Uint32Array.from(mesh.indices) };
}
