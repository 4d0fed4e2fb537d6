// SPDX-License-Identifier: MIT
// The options as a table: the checks, the defaults and the command line all read it. A new option
// is one line here, one in the interface in types.ts (the compiler sees to that) and one in
// wasm/module.h.
import type { AnalyzeOptions, BuildOptions, ExtractOptions } from './types.js';

/** @internal What is legal for one option. `help` completes the line of the command line's help. */
export type OptionSpec =
  | { kind: 'choice'; values: readonly string[]; default: string; help: string }
  | { kind: 'integer'; min: number; max: number; default: number | undefined; help: string }
  | { kind: 'number'; min: number; max?: number; default: number; help: string }
  | { kind: 'flag'; default: boolean; help: string };

type Table<T> = { readonly [K in keyof Required<T>]: OptionSpec };

/** @internal */
export const buildOptions: Table<BuildOptions> = {
  strategy: {
    kind: 'choice',
    values: ['adaptive', 'octree', 'feature', 'median', 'uniform'],
    default: 'adaptive',
    help: 'how cells are split',
  },
  tolerance: {
    kind: 'number',
    min: 0,
    default: 0,
    help: 'distance from the input in model units; 0: the relative one counts',
  },
  relativeTolerance: {
    kind: 'number',
    min: 0,
    default: 0.001,
    help: "the same as a fraction of the bounding box's diagonal",
  },
  depth: {
    kind: 'integer',
    min: 1,
    max: 60,
    default: undefined,
    help: "limit of the tree's depth",
  },
  inside: {
    kind: 'choice',
    values: ['repair', 'positive', 'odd', 'nonzero', 'sheet'],
    default: 'repair',
    help: 'which winding numbers are inside; sheet: none, open surfaces stay open',
  },
  windingThreshold: {
    kind: 'number',
    min: 0,
    max: 1,
    default: 0,
    help: 'repair: winding numbers above this are inside, below 1; 0: what keeps most faces',
  },
  largestHole: {
    kind: 'number',
    min: 0,
    default: 0,
    help: 'repair: wider holes are refused, in model units; 0: all are closed',
  },
  pairing: {
    kind: 'choice',
    values: ['trace', 'hermite', 'inside', 'outside'],
    default: 'trace',
    help: 'how hits are linked on crowded faces',
  },
  thicken: {
    kind: 'number',
    min: 0,
    default: 0,
    help: 'build a shell of this thickness around the surface, in model units; 0: the input itself',
  },
};

/** @internal */
export const extractOptions: Table<ExtractOptions> = {
  splitError: {
    kind: 'number',
    min: 0,
    default: 0,
    help: 'split vertices further than this from a plane, in model units; 0: features',
  },
  position: {
    kind: 'choice',
    values: ['constrained', 'projection'],
    default: 'constrained',
    help: 'how vertices are kept within their cells',
  },
  quads: { kind: 'flag', default: false, help: 'write quads where four leaves meet' },
  unfold: {
    kind: 'flag',
    default: true,
    help: 'flip edges of triangles that are folded over or thin',
  },
  linkError: {
    kind: 'number',
    min: 0,
    default: 0,
    help: 'vertices where edges pass between leaves further from the surface than this, in model units; 0: the tolerance',
  },
  parts: {
    kind: 'choice',
    values: ['all', 'outer', 'largest'],
    default: 'all',
    help: 'which parts are kept; outer: no cavities, nothing within others',
  },
  strict: {
    kind: 'choice',
    values: ['off', 'manifold', 'embedded'],
    default: 'manifold',
    help: 'what the index mesh must be; embedded: nothing crosses',
  },
  normals: { kind: 'flag', default: false, help: 'write normals at the corners of faces (OBJ)' },
  creaseAngle: {
    kind: 'number',
    min: 0,
    max: 180,
    default: 30,
    help: 'normals differ where faces turn by more, 0 to 180 degrees',
  },
};

/** @internal Not on the command line, whose --stats looks for everything. */
export const analyzeOptions: Table<AnalyzeOptions> = {
  selfIntersections: { kind: 'flag', default: false, help: 'look for self-intersections' },
};
