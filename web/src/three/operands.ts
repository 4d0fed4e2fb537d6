// SPDX-License-Identifier: MIT
// The operands of a Boolean operation as one source: their triangles one after the other, where the
// operation placed them.
import type { Material } from 'three';
import { KdManifoldError } from '../errors.js';
import { checkSourced, type MeshSource, type SourcedMesh } from './source.js';
import { transformPoints } from './transform.js';

/** Where operands went: what the option `transforms` of `boolean` was given. */
export type Transforms = readonly (ArrayLike<number> | null | undefined)[] | null;

/** Several sources as one. */
export interface JoinedOperands {
  from: SourcedMesh;
  /** Per operand the number of its first triangle in the whole; the last one is the number of all. */
  firstTriangles: number[];
}

/** Joins sources. Materials that several operands have are one. */
export function joinOperands(
  operands: readonly SourcedMesh[],
  transforms: Transforms,
): JoinedOperands {
  if (operands.length === 0) fail('INVALID_MESH', 'from: expected one source at least');
  if (transforms !== null && transforms.length !== operands.length) {
    const given = `length ${transforms.length}, but there are ${operands.length} operands`;
    fail('INVALID_OPTION', `transforms: ${given}`);
  }
  const materials: Material[] = [];
  const source: MeshSource = {
    parts: [],
    vertices: null,
    materialIndices: Uint32Array.from([]),
    materials,
    grouped: false,
  };
  const positions: Float64Array[] = [];
  const indices: Uint32Array[] = [];
  const vertices: Uint32Array[] = [];
  const materialIndices: Uint32Array[] = [];
  const firstTriangles = [0];
  let firstVertex = 0;
  let firstTriangle = 0;
  let numbers = 0; // of materials, where there are none
  for (const [i, operand] of operands.entries()) {
    const { source: own, ...mesh } = checkSourced(operand);
    const count = mesh.positions.length / 3;
    const points = Float64Array.from(mesh.positions);
    const transform = transforms?.[i];
    if (transform) transformPoints(transform, points, points, 0);
    positions.push(points);
    indices.push(shifted(mesh.indices ?? upTo(count), firstVertex));
    vertices.push(own.vertices ?? upTo(count));
    if (own.materials.length > 0) {
      const places = own.materials.map((material) => placeOf(material, materials));
      materialIndices.push(own.materialIndices.map((number) => places[number] as number));
    } else {
      materialIndices.push(shifted(own.materialIndices, numbers));
      numbers += 1 + own.materialIndices.reduce((most, one) => Math.max(most, one), 0);
    }
    for (const part of own.parts) {
      source.parts.push({
        ...part,
        firstTriangle: firstTriangle + part.firstTriangle,
        firstVertex: firstVertex + part.firstVertex,
      });
    }
    firstVertex += count;
    firstTriangle += own.materialIndices.length;
    firstTriangles.push(firstTriangle);
  }
  if (materials.length > 0 && numbers > 0) {
    fail('INVALID_MESH', 'from: some operands are of objects, others of geometries alone');
  }
  source.vertices = together(vertices);
  source.materialIndices = together(materialIndices);
  source.grouped = Math.max(materials.length, numbers) > 1;
  const points = new Float64Array(3 * firstVertex);
  let to = 0;
  for (const part of positions) {
    points.set(part, to);
    to += part.length;
  }
  return { from: { positions: points, indices: together(indices), source }, firstTriangles };
}

/** The triangles of the joined operands behind each face of a result. Those of no operand have none. */
export function sourcesInAll(
  sourceFaces: Uint32Array,
  sourceOperands: Uint32Array | null,
  firstTriangles: number[],
): Uint32Array {
  if (sourceOperands === null) {
    return fail('INVALID_MESH', 'the mesh has no sourceOperands, which several sources need');
  }
  const operands = firstTriangles.length - 1;
  return sourceFaces.map((face, t) => {
    const operand = sourceOperands[t] as number;
    if (operand === none || face === none) return none;
    const first = firstTriangles[operand];
    const next = firstTriangles[operand + 1];
    if (first === undefined || next === undefined) {
      return fail(
        'INVALID_MESH',
        `sourceOperands[${t}] is ${operand}, but \`from\` has ${operands}`,
      );
    }
    if (face >= next - first) {
      const count = `source ${operand} of \`from\` has only ${next - first} triangles`;
      return fail('INVALID_MESH', `sourceFaces[${t}] is ${face}, but ${count}`);
    }
    return first + face;
  });
}

const none = 0xffffffff;

function fail(code: 'INVALID_MESH' | 'INVALID_OPTION', message: string): never {
  throw new KdManifoldError(code, message);
}

const upTo = (count: number): Uint32Array => Uint32Array.from({ length: count }, (_, i) => i);

const shifted = (numbers: ArrayLike<number>, by: number): Uint32Array =>
  Uint32Array.from(numbers, (number) => number + by);

function placeOf(material: Material, materials: Material[]): number {
  const known = materials.indexOf(material);
  return known >= 0 ? known : materials.push(material) - 1;
}

function together(arrays: Uint32Array[]): Uint32Array {
  const all = new Uint32Array(arrays.reduce((sum, { length }) => sum + length, 0));
  let to = 0;
  for (const array of arrays) {
    all.set(array, to);
    to += array.length;
  }
  return all;
}
