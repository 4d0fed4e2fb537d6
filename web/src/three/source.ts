// SPDX-License-Identifier: MIT
// Where the triangles of a mesh come from: kept beside the mesh until its result comes back.
import type { BufferGeometry, Material, Object3D } from 'three';
import { KdManifoldError } from '../errors.js';
import type { MeshInput } from '../types.js';

/** A geometry as one object, or one instance of it, shows it. */
export interface SourcePart {
  /** The object; null if a geometry alone was given. */
  object: Object3D | null;
  geometry: BufferGeometry;
  /** Of an `InstancedMesh`; else 0. */
  instance: number;
  /** Its first triangle and its first vertex in the mesh; the next part's are behind its last. */
  firstTriangle: number;
  firstVertex: number;
  /** What the morph targets count, if they do. */
  influences: ArrayLike<number> | null;
  /** The instance's colour; null: none. */
  tint: ArrayLike<number> | null;
  /** Whether the vertex colours of the geometry are shown: with a tint they may not be. */
  coloured: boolean;
}

/** What is remembered of the objects that a mesh was made of. They are referred to, not copied. */
export interface MeshSource {
  /** In the order of their triangles. */
  parts: SourcePart[];
  /** The vertex of the part's geometry behind each vertex of the mesh; null: the same number. */
  vertices: Uint32Array | null;
  /** Per triangle the number of its material. */
  materialIndices: Uint32Array;
  /** What these numbers mean; empty if a geometry alone was given. */
  materials: Material[];
  /** Whether a result needs groups, so that every triangle keeps its material. */
  grouped: boolean;
}

/** A mesh that remembers where it comes from, ready for `makeManifold` and the like. */
export interface SourcedMesh extends MeshInput {
  source: MeshSource;
}

/** Checks that a mesh still has what it was made with. */
export function checkSourced(mesh: SourcedMesh): SourcedMesh {
  const fail = (message: string): never => {
    throw new KdManifoldError('INVALID_MESH', `from: ${message}`);
  };
  if (typeof mesh !== 'object' || mesh === null || !Array.isArray(mesh.source?.parts)) {
    fail('expected what fromObject3D or fromBufferGeometry returned');
  }
  const { positions, indices, source } = mesh;
  const triangles = (indices?.length ?? positions.length / 3) / 3;
  if (triangles !== source.materialIndices.length) {
    fail(
      `it has ${triangles} triangles, but was made with ${source.materialIndices.length}; ` +
        'with the option `transfer` its arrays are gone',
    );
  }
  return mesh;
}
