// SPDX-License-Identifier: MIT
// `kdmanifold/three`: makes meshes of three.js objects, and three.js objects of meshes.
export { findLost, type LostTriangles } from './three/find-lost.js';
export { fromBufferGeometry, type GeometryMesh } from './three/from-geometry.js';
export { fromObject3D, type FromObject3DOptions, type ObjectMesh } from './three/from-object.js';
export type { Skipped } from './three/collect.js';
export type { MeshSource, SourcedMesh, SourcePart } from './three/source.js';
export { toBufferGeometry, type ToBufferGeometryOptions } from './three/to-geometry.js';
export { toMesh, type ToMeshOptions } from './three/to-mesh.js';
