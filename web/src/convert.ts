// SPDX-License-Identifier: MIT
// One whole conversion on the calling thread. The worker runs it, and so does the calling thread where
// there are no workers.
import type { BooleanScene } from './boolean-scene.js';
import { isReduced } from './check-combination.js';
import type { CheckedReduce, CheckedReduction } from './check-input.js';
import type { Grid } from './grid.js';
import type { RawMade } from './kdmanifold.js';
import type { KdManifold } from './library.js';
import { pick } from './pick.js';
import { outputKeys } from './reports.js';
import type { Solids } from './solids.js';
import { plainShares, reducedShares, type MakeStep, type StepOptions } from './steps.js';
import type {
  Account,
  BuildOptions,
  Conversion,
  ExtractOptions,
  Mesh,
  MeshInput,
  ProgressCallback,
  Simplification,
} from './types.js';

// The shares of the whole time that making the mesh and describing it take, measured on models of 10,000 to 200,000
// triangles.
const makeShare = 0.9;
const describeShare = 0.02;

/** What is converted: a mesh, or several solids that are joined. Both have been checked. */
export type Subject = { mesh: MeshInput } | Solids;

/** What is to be made a manifold of, and how. Solids that are joined are not compared. */
export interface ConvertOrder {
  type: 'convert';
  subject: Subject;
  build: BuildOptions;
  extract: ExtractOptions;
  reduction: CheckedReduction;
  check: boolean;
}

/** What is to be reduced, and how far. */
export interface SimplifyOrder {
  type: 'simplify';
  mesh: MeshInput;
  reduce: CheckedReduce;
}

/** Solids that are kept from order to order, and where they go before the result is made. */
export interface SceneOrder {
  type: 'scene';
  /** The solids, if there are none yet or others. */
  setup: (Pick<ConvertOrder, 'build' | 'extract' | 'reduction'> & { subject: Solids }) | null;
  places: readonly (readonly [operand: number, transform: Float64Array | null])[];
}

/** What can be asked of a worker. */
export type Order = ConvertOrder | SimplifyOrder | SceneOrder;

/** What is kept from order to order. */
export interface Kept {
  scene?: BooleanScene;
}

/** What it gives. */
export type Outcome = Conversion | Simplification;

/** Does what is ordered. */
export function fulfil(
  library: KdManifold,
  order: Order,
  onProgress?: ProgressCallback,
  kept: Kept = {},
): Outcome {
  if (order.type === 'simplify') return simplify(library, order, onProgress);
  if (order.type === 'scene') return convertScene(library, order, kept, onProgress);
  const { subject, check } = order;
  return convert(library, (steps) => make(library, order, steps), onProgress, {
    solids: !('mesh' in subject),
    account: (grid, result) =>
      'mesh' in subject ? grid.compare(subject.mesh, result, { error: check }) : {},
  });
}

// Measures the steps one after the other, in seconds.
class Laps {
  readonly seconds: Record<MakeStep, number> = { build: 0, simplify: 0, extract: 0, reduce: 0 };
  #step: MakeStep | undefined;
  #since = performance.now();

  begin(step?: MakeStep): void {
    const now = performance.now();
    if (this.#step !== undefined) this.seconds[this.#step] += (now - this.#since) / 1000;
    [this.#step, this.#since] = [step, now];
  }
}

// How a result is held against what it was made of.
interface Compared {
  solids: boolean;
  account: (grid: Grid, result: Mesh) => Partial<Account>;
}

// Makes the mesh, and the grid that must be freed.
function make(
  library: KdManifold,
  { subject, build, extract, reduction }: ConvertOrder,
  { onProgress, onStep }: StepOptions,
): RawMade & { grid: Grid } {
  const shares = isReduced(reduction, build, extract) ? reducedShares : plainShares;
  const options = { ...build, ...extract, ...reduction };
  return 'mesh' in subject
    ? library.make(subject.mesh, options, shares, { onProgress, onStep })
    : library.makeSolids(subject, options, shares, { onProgress, onStep });
}

// Makes the result of solids that are kept.
function convertScene(
  library: KdManifold,
  { setup, places }: SceneOrder,
  kept: Kept,
  onProgress?: ProgressCallback,
): Conversion {
  if (setup !== null) {
    kept.scene?.delete();
    delete kept.scene;
    kept.scene = library.makeScene(setup.subject, setup);
  }
  const scene = kept.scene as BooleanScene;
  for (const [operand, transform] of places) scene.place(operand, transform);
  return convert(library, (steps) => scene.makeAll(steps), onProgress, {
    solids: true,
    account: () => ({}),
  });
}

// Makes the mesh, describes it and, unless it is of several solids, holds it against the input.
function convert(
  library: KdManifold,
  makeAll: (steps: StepOptions) => RawMade & { grid: Grid },
  onProgress: ProgressCallback | undefined,
  { solids, account: compare }: Compared,
): Conversion {
  const laps = new Laps();
  const { grid, levels, simplify, reduce, stats, report, ...result } = makeAll({
    ...(onProgress && {
      onProgress: (fraction, phase) => onProgress(makeShare * fraction, phase),
    }),
    onStep: (step) => laps.begin(step),
  });
  laps.begin();
  try {
    const described = library.describe(result);
    onProgress?.(makeShare + describeShare, 'compare');
    const { warnings = [], ...account } = compare(grid, result);
    onProgress?.(1, 'done');
    return {
      mesh: result,
      levels,
      report: {
        input: grid.input,
        ...(solids ? { operands: grid.operands } : {}),
        grid: stats,
        output: pick({ ...described, ...report }, outputKeys),
        simplify,
        reduce,
        ...account,
        warnings: [...warnings, ...report.warnings],
        seconds: laps.seconds,
        peakBytes: library.memory().heapBytes,
        thread: 'main',
        threads: library.threads,
      },
    };
  } finally {
    grid.delete();
  }
}

function simplify(
  library: KdManifold,
  { mesh, reduce }: SimplifyOrder,
  onProgress?: ProgressCallback,
): Simplification {
  const started = performance.now();
  const { report, ...made } = library.simplifyMesh(mesh, { ...reduce, onProgress });
  onProgress?.(1, 'done');
  return {
    ...made,
    report: {
      ...report,
      seconds: (performance.now() - started) / 1000,
      peakBytes: library.memory().heapBytes,
      thread: 'main',
      threads: library.threads,
    },
  };
}

/** Lists the buffers of meshes, to be handed to another thread. */
export function buffersOf(...meshes: object[]): ArrayBuffer[] {
  const buffers = new Set<ArrayBuffer>();
  for (const value of meshes.flatMap((mesh) => Object.values(mesh) as unknown[])) {
    if (ArrayBuffer.isView(value)) buffers.add(value.buffer as ArrayBuffer);
  }
  return [...buffers];
}
