// SPDX-License-Identifier: MIT
// What the package exports, and nothing else.
export { boolean, type BooleanOptions } from './boolean.js';
export type { BooleanScene, SceneMesh } from './boolean-scene.js';
export { KdManifoldError, type ErrorCode } from './errors.js';
export type { BooleanExpression, BooleanOperation } from './expression.js';
export { Grid } from './grid.js';
export { formatFromPath, KdManifold } from './library.js';
export { close, preload, type PreloadOptions } from './life-cycle.js';
export { load } from './load.js';
export type { LoadOptions, WorkerOptions } from './load-options.js';
export type { JobOptions } from './job.js';
export { makeManifold, type MakeManifoldOptions } from './make-manifold.js';
export {
  openBooleanScene,
  type OpenBooleanScene,
  type SceneJobOptions,
} from './open-boolean-scene.js';
export type * from './outside-types.js';
export { simplifyMesh, type SimplifyMeshOptions } from './simplify-mesh.js';
export type { SolidOptions } from './solids.js';
export type * from './types.js';
