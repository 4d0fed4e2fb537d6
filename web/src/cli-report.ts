// SPDX-License-Identifier: MIT
// The account of one run of the command line, word for word as src/cli/report.cpp writes it.
import type { Command } from './cli-options.js';
import { namesAGrid } from './library.js';
import type { ExtractReport, GridStats, InputReport, MeshReport } from './types.js';

/** What is reported. */
export interface CliReport {
  input: InputReport;
  grid: GridStats;
  output: MeshReport & ExtractReport & { selfIntersections?: number };
  seconds: { read: number; build: number; extract: number; write?: number };
  peakBytes: number;
}

/** `input`, `grid`, `output` (with --check also its `selfIntersections`), with --check `check`, then `seconds` and `peakBytes`. */
export function reportAsJson(report: CliReport, command: Command): string {
  const { output } = report;
  const json = {
    input: report.input,
    grid: report.grid,
    output: {
      vertices: output.vertices,
      triangles: output.triangles,
      quads: output.quads,
      components: output.components,
      eulerCharacteristic: output.eulerCharacteristic,
      twoManifold: output.twoManifold,
      manifold: output.manifold,
      closed: output.closed,
      boundaryLoops: output.boundaryLoops,
      volume: output.volume,
      area: output.area,
      droppedPillows: output.droppedPillows,
      insertedVertices: output.insertedVertices,
      splitVertices: output.splitVertices,
      linkVertices: output.linkVertices,
      flippedEdges: output.flippedEdges,
      refinedHits: output.refinedHits,
      crossings: output.crossings,
      selfIntersections: output.selfIntersections,
    },
    check: command.check ? checkOf(output) : undefined,
    seconds: report.seconds,
    peakBytes: report.peakBytes,
  };
  return `${JSON.stringify(json, null, 2)}\n`;
}

// What --check looked for.
function checkOf(output: MeshReport): object {
  return {
    twoManifold: output.twoManifold,
    manifold: output.manifold,
    closed: output.closed,
    boundaryEdges: output.boundaryEdges,
    nonManifoldEdges: output.nonManifoldEdges,
    misorientedEdges: output.misorientedEdges,
    nonManifoldVertices: output.nonManifoldVertices,
    degenerateFaces: output.degenerateFaces,
    duplicateFaces: output.duplicateFaces,
  };
}

/** A few lines for people. */
export function reportAsText(report: CliReport, command: Command): string {
  const { input, grid, output, seconds } = report;
  const faces =
    output.quads === 0
      ? `${output.triangles} triangles`
      : `${output.triangles} triangles and ${output.quads} quads`;
  const lines = [
    `input    ${command.input}: ${input.vertices} vertices, ${input.triangles} triangles, ` +
      `${input.components} parts${input.flipped ? ', turned inside out' : ''}`,
  ];
  if (input.degenerateFaces + input.cancelledFaces > 0) {
    lines.push(
      `         ${input.degenerateFaces} faces without area and ${input.cancelledFaces} ` +
        'back to back take no part',
    );
  }
  lines.push(
    `grid     ${namesAGrid(command.input) ? 'loaded' : (command.build.strategy ?? 'adaptive')}, depth ${grid.depth}: ${grid.cells} cells, ` +
      `${grid.hits} hits, ${(grid.bytes / 1e6).toFixed(1)} MB${topologyText(grid)}`,
    `output   ${command.output === undefined ? '' : `${command.output}: `}` +
      `${output.vertices} vertices, ${faces}, ${output.components} parts, ` +
      `Euler characteristic ${output.eulerCharacteristic}, ` +
      kindText(output, command),
  );
  if (command.check) {
    lines.push(
      passesCheck(output, command)
        ? `check    passed: 2-manifold${output.twoManifold ? '' : ' with boundary'}; ` +
            `${output.selfIntersections || 'no'} pairs of triangles cross`
        : `check    FAILED: ${output.boundaryEdges} boundary, ${output.nonManifoldEdges} ` +
            `non-manifold, ${output.misorientedEdges} misoriented edges, ` +
            `${output.nonManifoldVertices} non-manifold vertices, ${output.degenerateFaces} ` +
            `degenerate, ${output.duplicateFaces} duplicate faces`,
    );
  }
  const time = (value: number): string => value.toFixed(3);
  lines.push(
    `seconds  read ${time(seconds.read)}, build ${time(seconds.build)}, ` +
      `extract ${time(seconds.extract)}` +
      (seconds.write === undefined ? '' : `, write ${time(seconds.write)}`),
  );
  return `${lines.join('\n')}\n`;
}

function kindText(output: CliReport['output'], command: Command): string {
  if (output.twoManifold) return 'closed 2-manifold';
  if (!passesCheck(output, command)) return 'not 2-manifold';
  return `manifold with ${output.boundaryLoops} boundary loops`;
}

/** What --check asks: closed and 2-manifold; of a sheet, a manifold that may have a boundary. */
export function passesCheck(output: MeshReport, command: Command): boolean {
  return command.build.inside === 'sheet' ? output.manifold : output.twoManifold;
}

function topologyText(grid: GridStats): string {
  if (grid.topologyResolved) return ', topology resolved';
  if (grid.unresolvedLeaves === 0) return ''; // the other strategies do not look
  return `, topology given up in ${grid.unresolvedLeaves} leaves`;
}
