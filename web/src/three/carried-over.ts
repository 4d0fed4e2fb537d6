// SPDX-License-Identifier: MIT
// A geometry with the attributes and the groups of what its mesh was made of.
import { BufferAttribute } from 'three';
import type { BufferGeometry } from 'three';
import { KdManifoldError } from '../errors.js';
import { tabulate, type Column } from './columns.js';
import { hasSource, withoutInvented } from './invented.js';
import { cornersOf, geometryOf, sameNormal } from './own-vertices.js';
import { joinOperands, sourcesInAll, type Transforms } from './operands.js';
import type { Triangles } from './polygons.js';
import { checkSourced, type SourcedMesh } from './source.js';
import { splitVertices } from './split.js';
import { Transfer } from './transfer.js';

/**
 * Makes the geometry of a result of one mesh or, as an array, of the operands of a Boolean operation; `attributes`
 * null: all that can be carried over.
 */
export function carriedOver(
  triangles: Triangles,
  given: SourcedMesh | readonly SourcedMesh[],
  transforms: Transforms,
  attributes: string[] | null,
  seamTolerance: number,
): BufferGeometry {
  const { positions, normals } = triangles;
  const corners = cornersOf(triangles);
  const { from, known } = sourcesOf(triangles, corners.length / 3, given, transforms);
  const sources = withoutInvented(known, corners);
  const table = tabulate(from.source, from.positions.length / 3, attributes);
  const transfer =
    table.width > 0
      ? new Transfer(from, table, { positions, corners, sources }, seamTolerance)
      : null;
  const { made, index } = splitVertices(
    corners,
    positions.length / 3,
    (a, b) =>
      (normals === null || sameNormal(normals, a, b)) && (transfer === null || transfer.same(a, b)),
  );
  const geometry = geometryOf(triangles, corners, made, index);
  for (const column of table.columns) {
    geometry.setAttribute(
      column.name,
      attributeOf(column, transfer?.rows ?? new Float64Array(0), table.width, made),
    );
  }
  if (from.source.grouped) groupByMaterial(geometry, index, sources, from.source.materialIndices);
  return geometry;
}

/** What the triangles were made of, and which of its triangles each of them stands for. */
function sourcesOf(
  { sourceFaces, sourceOperands }: Triangles,
  triangles: number,
  given: SourcedMesh | readonly SourcedMesh[],
  transforms: Transforms,
): { from: SourcedMesh; known: Uint32Array } {
  const fail = (message: string): never => {
    throw new KdManifoldError('INVALID_MESH', message);
  };
  if (sourceFaces === null) return fail('the mesh has no sourceFaces, which `from` needs');
  for (const [name, { length }] of Object.entries({
    sourceFaces,
    ...(sourceOperands && { sourceOperands }),
  })) {
    if (length !== triangles) {
      fail(`${name}: length ${length}, but there are ${triangles} triangles`);
    }
  }
  if (isList(given)) {
    const { from, firstTriangles } = joinOperands(given, transforms);
    return { from, known: sourcesInAll(sourceFaces, sourceOperands, firstTriangles) };
  }
  const from = checkSourced(given);
  const count = from.source.materialIndices.length;
  for (let t = 0; t < triangles; ++t) {
    const source = sourceFaces[t] as number;
    if (source >= count && source !== 0xffffffff) {
      fail(`sourceFaces[${t}] is ${source}, but \`from\` has only ${count} triangles`);
    }
  }
  return { from, known: sourceFaces };
}

const isList = (given: SourcedMesh | readonly SourcedMesh[]): given is readonly SourcedMesh[] =>
  Array.isArray(given);

const wholeArrays = {
  Int8Array,
  Uint8Array,
  Uint8ClampedArray,
  Int16Array,
  Uint16Array,
  Int32Array,
  Uint32Array,
};

/** Takes one column of the rows of some corners. */
function attributeOf(
  { offset, itemSize, whole, gpuType }: Column,
  rows: Float64Array,
  width: number,
  corners: Uint32Array,
): BufferAttribute {
  const Numbers = wholeArrays[whole as keyof typeof wholeArrays] ?? Float32Array;
  const values = new Numbers(itemSize * corners.length);
  for (let i = 0; i < corners.length; ++i) {
    const from = width * (corners[i] as number) + offset;
    for (let c = 0; c < itemSize; ++c) values[itemSize * i + c] = rows[from + c] as number;
  }
  const attribute = new BufferAttribute(values, itemSize);
  // Newer three.js only: how shaders see it.
  if (gpuType !== undefined) Object.assign(attribute, { gpuType });
  return attribute;
}

/** Orders the triangles of an index by their materials, and makes a group of each. */
function groupByMaterial(
  geometry: BufferGeometry,
  index: Uint32Array,
  sources: Uint32Array,
  materialIndices: Uint32Array,
): void {
  const materialOf = (t: number): number => {
    const source = sources[t] as number;
    return hasSource(source) ? (materialIndices[source] as number) : 0;
  };
  const counts = new Map<number, number>();
  for (let t = 0; t < sources.length; ++t) {
    const material = materialOf(t);
    counts.set(material, (counts.get(material) ?? 0) + 3);
  }
  const ends = new Map<number, number>();
  let end = 0;
  for (const [material, count] of [...counts].sort(([a], [b]) => a - b)) {
    geometry.addGroup(end, count, material);
    ends.set(material, end);
    end += count;
  }
  const ordered = new Uint32Array(index.length);
  for (let t = 0; t < sources.length; ++t) {
    const material = materialOf(t);
    const to = ends.get(material) as number;
    for (let k = 0; k < 3; ++k) ordered[to + k] = index[3 * t + k] as number;
    ends.set(material, to + 3);
  }
  index.set(ordered);
}
