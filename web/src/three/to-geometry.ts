// SPDX-License-Identifier: MIT
// Geometries of meshes, with the attributes and materials of what the meshes were made of.
import { BufferAttribute, BufferGeometry } from 'three';
import { KdManifoldError } from '../errors.js';
import type { PolygonMeshInput } from '../types.js';
import { carriedOver } from './carried-over.js';
import { checkKeys, kindOf } from './kinds.js';
import { cornersOf, geometryOf, sameNormal } from './own-vertices.js';
import { triangulate, type Triangles } from './polygons.js';
import type { SourcedMesh } from './source.js';
import { splitVertices } from './split.js';

/** What `toBufferGeometry` can be told. */
export interface ToBufferGeometryOptions {
  /**
   * What the mesh was made of: its attributes and groups are carried over. Of a Boolean operation an array, with the
   * operands as they were given.
   */
  from?: SourcedMesh | readonly SourcedMesh[];
  /** The option `transforms` that the Boolean operation had, if it had any. Only with an array. */
  transforms?: readonly (ArrayLike<number> | null | undefined)[] | null;
  /** Which attributes are carried over (default: all that mean something on another surface). */
  attributes?: string[];
  /**
   * How different an attribute of two triangles may be at one place without there being a seam, in
   * fractions of the range of all its values (default: 0.0001).
   */
  seamTolerance?: number;
}

/**
 * Makes a geometry of a mesh. Without `cornerNormals` it has no normals: use a material with
 * `flatShading`, or call `computeVertexNormals()`. With them it has the attribute "normal", and for that
 * vertices of its own: one for every different normal at a vertex, so that creases are sharp and all
 * else is smooth. Quads become two triangles each. Without `cornerNormals` and `from` it has the mesh's
 * own arrays, not copies of them.
 *
 * With `from` it has the groups of what the mesh was made of, one a material, and its attributes: at
 * each corner the value at the nearest point of the source triangle, or of those that continue it
 * without seam and with the same material. Where values differ, at seams, the geometry has several
 * vertices at one place. Triangles that close holes take material and attributes of their neighbours.
 *
 * - Numbers are 32-bit floats in the geometry, also if they were normalised integers. Plain integers
 *   other than "uv..." and "color..." (numbers of things) are not interpolated and keep their type: the
 *   nearest corner's counts.
 * - What only some of the parts have is 1 for the others in "color" (white, opaque), else 0.
 * - Colours of instances are multiplied into "color".
 * - Not carried over is what belongs to the old surface: "normal" (ask for the mesh's own, with the
 *   option `normals`), "tangent" (call `computeTangents()`), "skinIndex" and "skinWeight" (the pose is
 *   applied) and morph targets.
 *
 * With an array, the parts of a Boolean operation's result have the attributes and materials of the operands that they
 * are of, cut faces too: those of the operand that cuts. Materials that several operands have are one. Where operands
 * are geometries alone, the numbers of materials of each come after those of the operands before it, which counts as
 * one if it has no groups.
 *
 * Borders between materials and seams run along the edges of the mesh: where its triangles are larger
 * than those of the source, they are as coarse as these.
 *
 * @param mesh - A result, or any mesh; with `from` one with `sourceFaces`, with an array one with `sourceOperands` too.
 * @param options - Where attributes and groups are to come from, and which.
 * @returns A new geometry. With groups, its triangles are in the order of their materials.
 * @throws KdManifoldError `INVALID_MESH` if the mesh was not made of `from`, or an attribute cannot be
 * read; `INVALID_OPTION` for options out of range and attributes unknown.
 * @example
 * ```ts
 * const from = fromObject3D(scene);
 * const { mesh } = await makeManifold(from, { normals: true });
 * scene.add(new Mesh(toBufferGeometry(mesh, { from }), from.source.materials));
 * ```
 */
export function toBufferGeometry(
  mesh: PolygonMeshInput,
  options: ToBufferGeometryOptions = {},
): BufferGeometry {
  checkKeys(options, ['from', 'transforms', 'attributes', 'seamTolerance']);
  const { from, transforms = null, attributes = null, seamTolerance = 1e-4 } = options;
  checkAttributes(attributes);
  checkTolerance(seamTolerance);
  if (!ArrayBuffer.isView((mesh as PolygonMeshInput | null)?.positions)) {
    throw new KdManifoldError('INVALID_MESH', `mesh: it has no positions, got ${kindOf(mesh)}`);
  }
  if (transforms !== null && !Array.isArray(from)) {
    throw new KdManifoldError('INVALID_OPTION', 'transforms: only with an array of operands');
  }
  const triangles = triangulate(mesh);
  if (from !== undefined) {
    return carriedOver(triangles, from, transforms, attributes, seamTolerance);
  }
  if (triangles.normals !== null) return withNormals(triangles, triangles.normals);
  const { positions, index } = triangles;
  const geometry = new BufferGeometry();
  // WebGL knows no 64-bit numbers.
  const array = positions instanceof Float64Array ? Float32Array.from(positions) : positions;
  geometry.setAttribute('position', new BufferAttribute(array, 3));
  if (index !== null) geometry.setIndex(new BufferAttribute(index, 1));
  return geometry;
}

function checkAttributes(attributes: string[] | null): void {
  if (attributes !== null && !(Array.isArray(attributes) && attributes.every(isText))) {
    throw new KdManifoldError('INVALID_OPTION', 'attributes: expected an array of names');
  }
}

const isText = (value: unknown): boolean => typeof value === 'string';

function checkTolerance(tolerance: number): void {
  if (!(tolerance >= 0 && tolerance <= 1)) {
    throw new KdManifoldError('INVALID_OPTION', 'seamTolerance: expected a number from 0 to 1');
  }
}

function withNormals(triangles: Triangles, normals: Float32Array): BufferGeometry {
  const corners = cornersOf(triangles);
  const { made, index } = splitVertices(corners, triangles.positions.length / 3, (a, b) =>
    sameNormal(normals, a, b),
  );
  return geometryOf(triangles, corners, made, index);
}
