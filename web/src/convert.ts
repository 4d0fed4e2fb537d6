// SPDX-License-Identifier: MIT
// One whole conversion on the calling thread. The worker runs it, and so does the calling thread where
// there are no workers.
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

/** What can be asked of a worker. */
export type Order = ConvertOrder | SimplifyOrder;

/** What it gives. */
export type Outcome = Conversion | Simplification;

/** Does what is ordered. */
export function fulfil(library: KdManifold, order: Order, onProgress?: ProgressCallback): Outcome {
  return order.type === 'convert'
    ? convert(library, order, onProgress)
    : simplify(library, order, onProgress);
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

// Makes the mesh, describes it and holds it against the input.
function convert(
  library: KdManifold,
  order: ConvertOrder,
  onProgress?: ProgressCallback,
): Conversion {
  const { subject, check } = order;
  const laps = new Laps();
  const { grid, levels, simplify, reduce, stats, report, ...result } = make(library, order, {
    ...(onProgress && {
      onProgress: (fraction, phase) => onProgress(makeShare * fraction, phase),
    }),
    onStep: (step) => laps.begin(step),
  });
  laps.begin();
  try {
    const described = library.describe(result);
    onProgress?.(makeShare + describeShare, 'compare');
    const { warnings = [], ...account }: Partial<Account> =
      'mesh' in subject ? grid.compare(subject.mesh, result, { error: check }) : {};
    onProgress?.(1, 'done');
    return {
      mesh: result,
      levels,
      report: {
        input: grid.input,
        ...('mesh' in subject ? {} : { operands: grid.operands }),
        grid: stats,
        output: pick({ ...described, ...report }, outputKeys),
        simplify,
        reduce,
        ...account,
        warnings: [...warnings, ...report.warnings],
        seconds: laps.seconds,
        peakBytes: library.memory().heapBytes,
        thread: 'main',
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
