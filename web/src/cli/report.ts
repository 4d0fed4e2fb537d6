// SPDX-License-Identifier: MIT
// The account of one run of the command line, word for word as the native one (src/cli) writes it.
import { inputName, standardStream } from './formats.js';
import type { Command } from './options.js';
import type { Task } from './plan.js';
import { pick } from '../pick.js';
import { checkKeys, defectKeys, outputKeys } from '../reports.js';
import type {
  Deviation,
  ExtractReport,
  GridStats,
  InputReport,
  LostArea,
  MeshDefects,
  MeshError,
  MeshReport,
  ReduceReport,
  SimplifyReport,
  Warning,
} from '../types.js';

/** One level of detail; null: no file was written. */
export interface Level {
  triangles: number;
  file: string | null;
  error: MeshError;
}

/** What is known at the end of a run. */
export interface CliReport {
  /** The defects of the input; with --stats only. */
  defects?: MeshDefects;
  /** What was made; not if --stats is all that is asked for. */
  result?: {
    input: InputReport;
    operands: InputReport[];
    grid: GridStats;
    output: MeshReport & ExtractReport & { selfIntersections?: number };
    /** Unless the grid was not simplified. */
    simplify?: SimplifyReport;
    /** Unless nothing was reduced. */
    reduce?: ReduceReport;
    /** With --target-triangles. */
    levels?: Level[];
    /** Only of one mesh that was the input; the error with --check only. */
    lost?: LostArea;
    error?: MeshError | null;
  };
  seconds: { read: number } & Partial<
    Record<'analyze' | 'build' | 'simplify' | 'extract' | 'reduce' | 'write', number>
  >;
  peakBytes: number;
  /** Of the file, then of the result. */
  warnings: Warning[];
}

/**
 * Returns `input`, with --stats `defects`, then `grid`, `output` (with --check also its `selfIntersections`), with
 * --simplify `simplify`, if anything was reduced `reduce`, with --target-triangles `levels`, `warnings`, with --check `check`, then `seconds` and `peakBytes`. With --stats alone there is neither `grid` nor `output`.
 */
export function reportAsJson(report: CliReport, command: Command): object {
  const { defects, result, seconds } = report;
  return {
    input: result?.input ?? (defects && inputOf(defects)),
    defects: defects && pick(countsOf(defects), defectKeys),
    operands: result?.operands.length ? result.operands : undefined,
    grid: result && {
      ...result.grid,
      unresolvedPositions: triples(result.grid.unresolvedPositions),
    },
    output: result && {
      ...pick(result.output, outputKeys),
      selfIntersections: result.output.selfIntersections,
    },
    simplify: result?.simplify,
    reduce: result?.reduce,
    levels: result?.levels,
    lost: result?.lost && { ...result.lost, faces: result.lost.faces.length },
    error: result?.error ?? undefined,
    warnings: report.warnings,
    check: command.report.check && result ? pick(result.output, checkKeys) : undefined,
    seconds: {
      read: seconds.read,
      analyze: seconds.analyze,
      build: seconds.build,
      simplify: seconds.simplify,
      extract: seconds.extract,
      reduce: seconds.reduce,
      write: seconds.write,
    },
    peakBytes: report.peakBytes,
  };
}

const triples = (numbers: Float64Array): number[][] =>
  Array.from({ length: numbers.length / 3 }, (_, i) => [...numbers.subarray(3 * i, 3 * i + 3)]);

// The keys of an InputReport that need no grid.
function inputOf(input: MeshDefects): object {
  return {
    vertices: input.report.vertices,
    triangles: input.report.triangles,
    closed: input.balanced,
    boundaryEdges: input.report.boundaryEdges,
    nonManifoldEdges: input.report.nonManifoldEdges,
    degenerateFaces: input.degenerateFaces.length + input.zeroAreaFaces.length,
    components: input.parts.length,
  };
}

type PartSums = Record<
  'openParts' | 'insideOutParts' | 'cavities' | 'genus' | 'area' | 'volume',
  number
>;
type Counts = Record<Exclude<(typeof defectKeys)[number], 'nestingKnown'>, number> & {
  nestingKnown: boolean;
};

// Counts what the lists hold (edges are two numbers each) and adds up the parts.
function countsOf(defects: MeshDefects): Counts {
  const sum = (of: (part: MeshDefects['parts'][number]) => number): number =>
    defects.parts.reduce((total, part) => total + of(part), 0);
  const sums: PartSums = {
    openParts: sum((part) => Number(!part.closed)),
    insideOutParts: sum((part) => Number(part.insideOut)),
    cavities: sum((part) => Number(part.cavity)),
    genus: sum((part) => part.genus ?? 0),
    area: sum((part) => part.area),
    volume: sum((part) => part.volume),
  };
  const entries = Object.entries(defects) as [string, ArrayLike<unknown> | object | number][];
  const counts = entries.map(([name, value]) => {
    const isList = typeof value === 'object' && 'length' in value;
    return [name, isList ? value.length / (name.endsWith('Edges') ? 2 : 1) : value] as const;
  });
  return { ...Object.fromEntries(counts), ...sums } as Counts;
}

/** Writes a few lines for people. */
export function reportAsText(report: CliReport, command: Command, task: Task): string {
  const { defects, result } = report;
  const lines = report.warnings.map(({ message }) => `warning  ${message}`);
  if (result) lines.push(...inputLines(result.input, result.operands.length, task));
  else if (defects) lines.push(inputLine(defects.report, task));
  if (defects) lines.push(...defectLines(defects));
  if (result) lines.push(...resultLines(result, command, task));
  lines.push(secondsLine(report.seconds));
  return `${lines.join('\n')}\n`;
}

type Sizes = { vertices: number; triangles: number; components: number };

const inputLine = (input: Sizes, task: Task): string =>
  `input    ${inputName(task.input)}: ${input.vertices} vertices, ${input.triangles} triangles, ` +
  `${input.components} parts`;

function inputLines(input: InputReport, operands: number, task: Task): string[] {
  const lines = [
    `${inputLine(input, task)}${operands > 0 ? `, ${operands} operands` : ''}` +
      (input.flipped ? ', turned inside out' : ''),
  ];
  if (input.degenerateFaces + input.cancelledFaces > 0) {
    lines.push(
      `         ${input.degenerateFaces} faces without area and ${input.cancelledFaces} ` +
        'back to back take no part',
    );
  }
  return lines;
}

// Says what had to be done to a surface that is not closed and consistently oriented.
function repairLines({ input, grid, output }: NonNullable<CliReport['result']>): string[] {
  const { sewnEdges, turnedFaces, duplicateFaces } = input;
  const cut = input.closed && grid.thinArea + grid.narrowArea > 0;
  if (sewnEdges + turnedFaces + duplicateFaces === 0 && (cut || grid.inventedHits === 0)) return [];
  const share = output.area > 0 ? (100 * output.inventedArea) / output.area : 0;
  const lines = [
    `repair   ${sewnEdges} pairs of edges sewn, ${turnedFaces} faces turned, ` +
      `${duplicateFaces} doubled ones left out; ${share.toFixed(1)} % of the area closes holes, ` +
      `${output.droppedCrumbs} crumbs dropped`,
  ];
  if (grid.windingThreshold > 0) {
    lines.push(`         winding numbers above ${grid.windingThreshold} are inside`);
  }
  return lines;
}

// Says how many triangles there were, and how many there are in each level.
function reductionLines({
  simplify,
  reduce,
  levels = [],
}: NonNullable<CliReport['result']>): string[] {
  const lines = levels.map(
    ({ file, triangles, error }) =>
      `level    ${file === null ? '' : `${file}: `}${triangles} triangles, ${errorText(error)}`,
  );
  if (reduce) {
    lines.unshift(`reduced  from ${reduce.trianglesBefore} triangles to ${reduce.triangles}`);
  }
  if (simplify) {
    const { removedParts, filledCavities, removedSurfaces } = simplify;
    if (removedSurfaces > 0) {
      lines.unshift(
        `         ${removedParts} thin parts removed, ${filledCavities} thin cavities filled`,
      );
    }
    lines.unshift(`simpler  grid from ${simplify.cellsBefore} cells to ${simplify.cells}`);
  }
  return lines;
}

// Writes a number in full with three digits that count. The native program gets the same.
function threeDigits(value: number): string {
  let decimals = 0;
  for (let scaled = value; scaled < 100 && decimals < 20; scaled *= 10) ++decimals;
  return value.toFixed(value > 0 ? decimals : 0);
}

function errorText(error: MeshError): string {
  const numbers = ({ largest, rms }: Deviation): string =>
    `at most ${threeDigits(largest)} (rms ${threeDigits(rms)})`;
  return `result to input ${numbers(error.toInput)}, input to result ${numbers(error.toOutput)}`;
}

// What the result lacks, and how far it is from the input.
function accountLines({ lost, error }: NonNullable<CliReport['result']>): string[] {
  const lines: string[] = [];
  if (lost && lost.area > 0) {
    lines.push(
      `lost     ${threeDigits(100 * lost.share)} % of the input's area, in ${lost.parts} pieces`,
    );
  }
  if (error) lines.push(`error    ${errorText(error)}`);
  return lines;
}

const names: [keyof Counts, string][] = [
  ['boundaryEdges', 'open edges'],
  ['boundaryLoops', 'boundary loops'],
  ['nonManifoldEdges', 'edges with three or more faces'],
  ['misorientedEdges', 'edges whose faces disagree'],
  ['nonManifoldVertices', 'vertices that are not manifold'],
  ['degenerateFaces', 'faces with a repeated vertex'],
  ['zeroAreaFaces', 'faces without area'],
  ['duplicateFaces', 'doubled faces'],
  ['flippedFaces', 'faces turned the wrong way'],
  ['selfIntersections', 'pairs of triangles cross'],
  ['insideOutParts', 'parts inside out'],
];

function defectLines(defects: MeshDefects): string[] {
  const counts = countsOf(defects);
  const found = names.filter(([key]) => counts[key]).map(([key, name]) => `${counts[key]} ${name}`);
  const { openParts, cavities, genus } = counts;
  const nesting = defects.nestingKnown ? '' : ' (too many overlap to look for them)';
  return [
    `defects  ${found.join(', ') || 'none'}`,
    `parts    ${openParts} open, ${defects.parts.length - openParts} closed, ` +
      `${cavities} of these cavities${nesting}, genus ${genus}`,
  ];
}

function resultLines(
  result: NonNullable<CliReport['result']>,
  command: Command,
  task: Task,
): string[] {
  const { grid, output, levels = [] } = result;
  const file = levels.length > 1 ? (levels.at(-1)?.file ?? undefined) : task.output;
  const path = file === standardStream ? 'standard output' : file;
  const faces =
    output.quads === 0
      ? `${output.triangles} triangles`
      : `${output.triangles} triangles and ${output.quads} quads`;
  const lines = [
    `grid     ${task.isGrid ? 'loaded' : (command.build.strategy ?? 'adaptive')}, depth ${grid.depth}: ${grid.cells} cells, ` +
      `${grid.hits} hits, ${(grid.bytes / 1e6).toFixed(1)} MB${topologyText(grid)}`,
    `output   ${path === undefined ? '' : `${path}: `}` +
      `${output.vertices} vertices, ${faces}, ${output.components} parts, ` +
      `Euler characteristic ${output.eulerCharacteristic}, ` +
      kindText(output, grid.sheet),
  ];
  lines.push(...reductionLines(result), ...repairLines(result), ...accountLines(result));
  if (command.report.check) {
    lines.push(
      passesCheck(output, grid.sheet)
        ? `check    passed: 2-manifold${output.twoManifold ? '' : ' with boundary'}; ` +
            `${output.selfIntersections || 'no'} pairs of triangles cross`
        : `check    FAILED: ${output.boundaryEdges} boundary, ${output.nonManifoldEdges} ` +
            `non-manifold, ${output.misorientedEdges} misoriented edges, ` +
            `${output.nonManifoldVertices} non-manifold vertices, ${output.degenerateFaces} ` +
            `degenerate, ${output.duplicateFaces} duplicate faces`,
    );
  }
  return lines;
}

function secondsLine(seconds: CliReport['seconds']): string {
  const steps = ['read', 'analyze', 'build', 'simplify', 'extract', 'reduce', 'write'] as const;
  const taken = steps
    .filter((step) => seconds[step] !== undefined)
    .map((step) => `${step} ${seconds[step]?.toFixed(3)}`);
  return `seconds  ${taken.join(', ')}`;
}

function kindText(output: MeshReport, sheet: boolean): string {
  if (output.twoManifold) return 'closed 2-manifold';
  if (!passesCheck(output, sheet)) return 'not 2-manifold';
  return `manifold with ${output.boundaryLoops} boundary loops`;
}

/** Says whether the output is closed and 2-manifold; of a sheet, a manifold that may have a boundary. */
export function passesCheck(output: MeshReport, sheet: boolean): boolean {
  return sheet ? output.manifold : output.twoManifold;
}

function topologyText(grid: GridStats): string {
  if (grid.topologyResolved) return ', topology resolved';
  if (grid.unresolvedLeaves === 0) return ''; // the other strategies do not look
  return `, topology given up in ${grid.unresolvedLeaves} leaves`;
}
