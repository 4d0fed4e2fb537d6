// SPDX-License-Identifier: MIT
// One whole conversion on the calling thread. The worker runs it, and so does the calling thread where
// there are no workers.
import type { KdManifold } from './library.js';
import { pick } from './pick.js';
import { outputKeys } from './reports.js';
import type {
  BuildOptions,
  Conversion,
  ExtractOptions,
  MeshInput,
  ProgressCallback,
} from './types.js';

// The shares of the whole time that the steps take, measured on models of 10,000 to 200,000 triangles.
const buildShare = 0.7;
const extractShare = 0.2;
const describeShare = 0.02;

/** What is to be converted, and how. */
export interface Order {
  mesh: MeshInput;
  build: BuildOptions;
  extract: ExtractOptions;
  check: boolean;
}

/** Builds the grid, extracts the result, describes it and holds it against the mesh, and frees the grid. */
export function convert(
  library: KdManifold,
  { mesh, build, extract, check }: Order,
  onProgress?: ProgressCallback,
): Conversion {
  const part = (from: number, share: number): ProgressCallback | undefined =>
    onProgress && ((fraction, phase) => onProgress(from + share * fraction, phase));
  const started = performance.now();
  const grid = library.buildGrid(mesh, { ...build, onProgress: part(0, buildShare) });
  try {
    const built = performance.now();
    const { report, ...result } = grid.extract({
      ...extract,
      onProgress: part(buildShare, extractShare),
    });
    const extracted = performance.now();
    const described = library.describe(result);
    onProgress?.(buildShare + extractShare + describeShare, 'compare');
    const { lost, error, warnings } = grid.compare(mesh, result, { error: check });
    onProgress?.(1, 'done');
    return {
      mesh: result,
      report: {
        input: grid.input,
        grid: grid.stats,
        output: pick({ ...described, ...report }, outputKeys),
        lost,
        error,
        warnings: [...warnings, ...report.warnings],
        seconds: { build: (built - started) / 1000, extract: (extracted - built) / 1000 },
        peakBytes: library.memory().heapBytes,
        thread: 'main',
      },
    };
  } finally {
    grid.delete();
  }
}

/** Lists the buffers of a mesh, to be handed to another thread. */
export function buffersOf(mesh: object): ArrayBuffer[] {
  const buffers = new Set<ArrayBuffer>();
  for (const value of Object.values(mesh)) {
    if (ArrayBuffer.isView(value)) buffers.add(value.buffer as ArrayBuffer);
  }
  return [...buffers];
}
