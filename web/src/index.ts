// SPDX-License-Identifier: MIT
// What the package exports, and nothing else.
export { KdManifoldError, type ErrorCode } from './errors.js';
export { Grid } from './grid.js';
export { formatFromPath, KdManifold } from './library.js';
export { load, type LoadOptions } from './load.js';
export { makeManifold, type MakeManifoldOptions } from './make-manifold.js';
export type * from './types.js';
