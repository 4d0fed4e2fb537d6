// SPDX-License-Identifier: MIT
// Makes the bytes of GLB files: the same ones as src/cli/glb/write.cpp.
import { KdManifoldError } from '../errors.js';
import type { Mesh } from '../types.js';

// What goes into the file.
interface Model {
  positions: Float32Array;
  /** Three numbers a position, or none at all. */
  normals: Float32Array;
  indices: Uint32Array;
}

function checkFinite(positions: Float32Array): void {
  const at = positions.findIndex((value) => !Number.isFinite(value));
  if (at < 0) return;
  throw new KdManifoldError(
    'INVALID_MESH',
    `positions[${Math.floor(at / 3)}].${'xyz'[at % 3]} is no finite 32-bit number; scale the mesh down`,
  );
}

// The corners of all triangles, those of halved quads among them: the number of the corner in the mesh, its vertex.
function* cornersOf({ indices, quads }: Mesh): Generator<[corner: number, vertex: number]> {
  for (let i = 0; i < indices.length; ++i) yield [i, indices[i] ?? 0];
  for (let first = 0; first < (quads?.length ?? 0); first += 4) {
    for (const i of [0, 1, 2, 0, 2, 3]) yield [indices.length + first + i, quads?.[first + i] ?? 0];
  }
}

// The copies of each vertex, one a normal, are chains through the new vertices.
function split(mesh: Mesh, normals: Float32Array): Model {
  const made: Model = { positions: new Float32Array(), normals, indices: new Uint32Array() };
  const none = -1;
  const first = new Int32Array(mesh.positions.length / 3).fill(none);
  const next: number[] = [];
  const corners: number[] = []; // of the new vertices: where their normals are
  const vertices: number[] = []; // of the new vertices: the old ones
  const indices: number[] = [];
  const same = (a: number, b: number): boolean =>
    [0, 1, 2].every((axis) => normals[3 * a + axis] === normals[3 * b + axis]);
  for (const [corner, vertex] of cornersOf(mesh)) {
    let copy = first[vertex] ?? 0;
    while (copy !== none && !same(corners[copy] ?? 0, corner)) copy = next[copy] ?? 0;
    if (copy === none) {
      copy = corners.length;
      corners.push(corner);
      vertices.push(vertex);
      next.push(first[vertex] ?? 0);
      first[vertex] = copy;
    }
    indices.push(copy);
  }
  const gather = (from: Float32Array, places: number[]): Float32Array =>
    Float32Array.from({ length: 3 * places.length }, (_, i) => {
      const place = places[Math.floor(i / 3)] ?? 0;
      return from[3 * place + (i % 3)] ?? 0;
    });
  made.positions = gather(mesh.positions, vertices);
  made.normals = gather(normals, corners);
  made.indices = Uint32Array.from(indices);
  return made;
}

function modelOf(mesh: Mesh): Model {
  checkFinite(mesh.positions);
  if (mesh.cornerNormals !== undefined) return split(mesh, mesh.cornerNormals);
  const { positions, indices, quads } = mesh;
  const triangles = quads === undefined ? indices : Uint32Array.from(cornersOf(mesh), (c) => c[1]);
  return { positions, normals: new Float32Array(), indices: triangles };
}

// The shortest digits that read back as the number; 0.5 is 5e-1.
const numberText = (value: number): string => (value + 0).toExponential().replace('e+0', '');

const pointText = (point: number[]): string => `[${point.map(numberText).join(',')}]`;

function bounds(positions: Float32Array): [low: number[], high: number[]] {
  const low = [...positions.subarray(0, 3)];
  const high = [...low];
  for (let i = 0; i < positions.length; ++i) {
    const value = positions[i] ?? 0;
    if (value < (low[i % 3] ?? 0)) low[i % 3] = value;
    if (value > (high[i % 3] ?? 0)) high[i % 3] = value;
  }
  return [low, high];
}

// The text that describes the arrays, which follow each other without gaps.
function description(model: Model, indexBytes: number, bytes: number): string {
  const [low, high] = bounds(model.positions);
  const count = model.positions.length / 3;
  const normals = model.normals.length > 0;
  const points = `"componentType":5126,"count":${count},"type":"VEC3"`;
  const accessors = [`{"bufferView":0,${points},"min":${pointText(low)},"max":${pointText(high)}}`];
  const views = [`{"buffer":0,"byteOffset":0,"byteLength":${12 * count},"target":34962}`];
  if (normals) {
    accessors.push(`{"bufferView":1,${points}}`);
    views.push(`{"buffer":0,"byteOffset":${12 * count},"byteLength":${12 * count},"target":34962}`);
  }
  const last = accessors.length;
  const type = indexBytes === 2 ? 5123 : 5125;
  const { length } = model.indices;
  accessors.push(
    `{"bufferView":${last},"componentType":${type},"count":${length},"type":"SCALAR"}`,
  );
  views.push(
    `{"buffer":0,"byteOffset":${12 * count * last},"byteLength":${indexBytes * length},"target":34963}`,
  );
  const attributes = `"POSITION":0${normals ? ',"NORMAL":1' : ''}`;
  return (
    '{"asset":{"version":"2.0","generator":"kdmanifold"},"scene":0,"scenes":[{"nodes":[0]}],' +
    `"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{${attributes}},"indices":${last}}]}],` +
    `"accessors":[${accessors.join(',')}],"bufferViews":[${views.join(',')}],` +
    `"buffers":[{"byteLength":${bytes}}]}`
  );
}

const upTo4 = (bytes: number): number => 4 * Math.ceil(bytes / 4);

/**
 * Returns the bytes of a GLB file with one mesh: positions of 32 bits, indices of as many as are needed, quads cut in
 * two. With corner normals a vertex is there once for each of its normals.
 */
export function writeGlb(mesh: Mesh): Uint8Array {
  const model = modelOf(mesh);
  const empty = model.indices.length === 0;
  // 65535 marks the end of strips and is no index.
  const indexBytes = model.positions.length / 3 <= 65535 ? 2 : 4;
  const arrays = [
    model.positions,
    model.normals,
    indexBytes === 2 ? Uint16Array.from(model.indices) : model.indices,
  ];
  const bytes = empty ? 0 : arrays.reduce((sum, { byteLength }) => sum + byteLength, 0);
  const text = empty
    ? '{"asset":{"version":"2.0","generator":"kdmanifold"}}'
    : description(model, indexBytes, bytes);
  const jsonBytes = upTo4(text.length); // all of it is ASCII
  const length = 20 + jsonBytes + (empty ? 0 : 8 + upTo4(bytes));
  if (length > 0xffffffff) {
    throw new KdManifoldError(
      'INVALID_MESH',
      'the mesh is too large for a GLB file: 4 GiB or more',
    );
  }
  const file = new Uint8Array(length);
  const view = new DataView(file.buffer);
  const header = [0x46546c67, 2, length, jsonBytes, 0x4e4f534a];
  header.forEach((word, i) => view.setUint32(4 * i, word, true));
  file.set(new TextEncoder().encode(text.padEnd(jsonBytes)), 20);
  if (empty) return file;
  let at = 20 + jsonBytes;
  view.setUint32(at, upTo4(bytes), true);
  view.setUint32(at + 4, 0x004e4942, true);
  at += 8;
  for (const array of arrays) {
    file.set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength), at);
    at += array.byteLength;
  }
  return file;
}
