// SPDX-License-Identifier: MIT
// Meshes for the tests, and a judge of meshes that shares no code with the library.

/** A cube with 8 vertices and 12 triangles, counter-clockwise seen from outside. */
export function cube(size = 2, [x, y, z] = [0, 0, 0]) {
  const positions = [];
  for (let corner = 0; corner < 8; ++corner) {
    positions.push(
      x + size * ((corner & 1) - 0.5),
      y + size * (((corner >> 1) & 1) - 0.5),
      z + size * ((corner >> 2) - 0.5),
    );
  }
  //    2---3     6---7
  //    |   |     |   |   lower and upper layer, seen from above
  //    0---1     4---5
  const quads = [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
  ];
  return {
    positions: Float32Array.from(positions),
    indices: Uint32Array.from(quads.flatMap(([a, b, c, d]) => [a, b, c, a, c, d])),
  };
}

/** A torus of `along` times `around` quads, each cut into two triangles. */
export function torus(along = 32, around = 16, major = 3, minor = 1) {
  const positions = [];
  const indices = [];
  for (let i = 0; i < along; ++i) {
    for (let j = 0; j < around; ++j) {
      const [u, v] = [(i / along) * 2 * Math.PI, (j / around) * 2 * Math.PI];
      const radius = major + minor * Math.cos(v);
      positions.push(radius * Math.cos(u), radius * Math.sin(u), minor * Math.sin(v));
      const [a, b] = [i * around, ((i + 1) % along) * around];
      const [c, d] = [j, (j + 1) % around];
      indices.push(a + c, b + c, b + d, a + c, b + d, a + d);
    }
  }
  return { positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
}

/** Several meshes in one pair of arrays. */
export function together(...meshes) {
  const positions = meshes.flatMap((mesh) => [...mesh.positions]);
  let first = 0;
  const indices = meshes.flatMap((mesh) => {
    const own = [...mesh.indices].map((index) => index + first);
    first += mesh.positions.length / 3;
    return own;
  });
  return { positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
}

/** Every three positions a triangle. */
export function asSoup({ positions, indices }) {
  const soup = new Float32Array(indices.length * 3);
  indices.forEach((index, i) => soup.set(positions.subarray(3 * index, 3 * index + 3), 3 * i));
  return { positions: soup };
}

function* facesOf({ indices, quads = [] }) {
  for (let i = 0; i < indices.length; i += 3) yield [...indices.subarray(i, i + 3)];
  for (let i = 0; i < quads.length; i += 4) yield [...quads.subarray(i, i + 4)];
}

/** What is wrong with a mesh as a closed oriented 2-manifold: a list of words, empty if nothing. */
export function faults(mesh) {
  const found = new Set();
  const count = mesh.positions.length / 3;
  if (![...mesh.positions].every(Number.isFinite)) found.add('position not finite');
  const edges = new Map();
  const corners = new Map();
  const faces = new Set();
  for (const face of facesOf(mesh)) {
    if (face.some((v) => v >= count)) found.add('index out of range');
    if (new Set(face).size < face.length) found.add('repeated vertex');
    const name = [...face].sort((a, b) => a - b).join();
    if (faces.has(name)) found.add('repeated face');
    faces.add(name);
    face.forEach((v, i) => {
      const [next, previous] = [face[(i + 1) % face.length], face.at(i - 1)];
      const edge = `${v},${next}`;
      if (edges.has(edge)) found.add('edge used twice in one direction');
      edges.set(edge, true);
      if (!corners.has(v)) corners.set(v, new Map());
      corners.get(v).set(next, previous);
    });
  }
  for (const edge of edges.keys()) {
    if (!edges.has(edge.split(',').reverse().join())) found.add('open edge');
  }
  // Around a vertex, going from face to face must visit all of its faces in one turn.
  for (const around of corners.values()) {
    const [start] = around.keys();
    let at = start;
    let steps = 0;
    do {
      at = around.get(at);
      ++steps;
    } while (at !== undefined && at !== start && steps <= around.size);
    if (at !== start || steps !== around.size) found.add('vertex with more than one fan');
  }
  return [...found];
}

/** Volume enclosed by an oriented mesh. */
export function volume(mesh) {
  let sum = 0;
  const point = (v) => mesh.positions.subarray(3 * v, 3 * v + 3);
  for (const [first, ...rest] of facesOf(mesh)) {
    for (let i = 0; i + 1 < rest.length; ++i) {
      const [a, b, c] = [first, rest[i], rest[i + 1]].map(point);
      sum += a[0] * (b[1] * c[2] - b[2] * c[1]);
      sum += a[1] * (b[2] * c[0] - b[0] * c[2]);
      sum += a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
  }
  return sum / 6;
}

/** V - E + F over the vertices that faces use. */
export function eulerCharacteristic(mesh) {
  const vertices = new Set();
  const edges = new Set();
  let faces = 0;
  for (const face of facesOf(mesh)) {
    ++faces;
    face.forEach((v, i) => {
      const next = face[(i + 1) % face.length];
      vertices.add(v);
      edges.add(v < next ? `${v},${next}` : `${next},${v}`);
    });
  }
  return vertices.size - edges.size + faces;
}
