// SPDX-License-Identifier: MIT
// The work for one input, in the steps of src/cli/convert.cpp.
import { checkFolderOf, checkTarget, makeFolder, readAll, writeAll } from './files.js';
import { inputFormat, inputName, outputFormat, type FileFormat } from './formats.js';
import { readGlb, type GlbScene } from './glb-read.js';
import { writeGlb } from './glb-write.js';
import { converts, joinsSolids, withTypedNames, type Command } from './options.js';
import { levelPath, type Task } from './plan.js';
import type { ProgressLine } from './progress.js';
import type { CliReport } from './report.js';
import { makeSolids, mergeGrids, readSolids } from './solids.js';
import { KdManifoldError } from '../errors.js';
import type { Grid } from '../grid.js';
import type { RawMade } from '../kdmanifold.js';
import type { KdManifold } from '../library.js';
import type { MakeStep, StepOptions } from '../steps.js';
import type { Account, Mesh, MeshInput, ProgressCallback } from '../types.js';

// What a task's files are: nothing for grids, and where there is no output.
interface Formats {
  input?: FileFormat;
  output?: FileFormat;
}

// The files of the result: one, or one for each of several levels. Empty if none is written.
function pathsOf({ reduction }: Command, { output }: Task): string[] {
  if (output === undefined) return [];
  const levels = reduction.targetTriangles ?? [];
  return levels.length < 2 ? [output] : Array.from(levels, (_, i) => levelPath(output, i + 1));
}

// Refuses before the work what can be refused then.
function checkFiles(command: Command, task: Task): Formats {
  const { files, extract } = command;
  const { input, output, isGrid } = task;
  const formats: Formats = {};
  const force = files.force === true;
  if (!isGrid) formats.input = inputFormat(input, files.inputFormat);
  if (output !== undefined) {
    formats.output = outputFormat(output, files.format);
    if (extract.normals === true && formats.output !== 'obj' && formats.output !== 'glb') {
      throw new KdManifoldError(
        'INVALID_OPTION',
        '`normals`: of the files only .obj and .glb have them',
      );
    }
    for (const path of pathsOf(command, task)) checkTarget(path, force);
    // The folder of --out-dir was checked, and may not be there yet.
    if (files.outDir === undefined) checkFolderOf(output);
  }
  if (files.saveGrid !== undefined) {
    checkTarget(files.saveGrid, force);
    checkFolderOf(files.saveGrid);
  }
  return formats;
}

async function readMesh(library: KdManifold, path: string, format: FileFormat): Promise<GlbScene> {
  const bytes = await readAll(path);
  const name = inputName(path);
  if (format === 'glb') return readGlb(bytes, name);
  const { warnings, ...mesh } = library.parseMesh(bytes, format, name);
  return { mesh, warnings };
}

async function writeResults(
  library: KdManifold,
  { files }: Command,
  paths: string[],
  format: FileFormat | undefined,
  meshes: Mesh[],
  exact: boolean,
  grid: Grid,
): Promise<void> {
  for (const [i, path] of paths.entries()) {
    const mesh = meshes[i];
    if (mesh === undefined || format === undefined) continue;
    const bytes = format === 'glb' ? writeGlb(mesh) : library.formatMesh(mesh, format, { exact });
    if (files.outDir !== undefined) makeFolder(files.outDir);
    await writeAll(path, bytes);
  }
  if (files.saveGrid !== undefined) await writeAll(files.saveGrid, grid.save());
}

function stopwatch(): () => number {
  let last = performance.now();
  return () => {
    const now = performance.now();
    const seconds = (now - last) / 1000;
    last = now;
    return seconds;
  };
}

const doing: Record<MakeStep, string> = {
  build: 'building',
  simplify: 'simplifying',
  extract: 'extracting',
  reduce: 'reducing',
};

// Takes the time of the steps, and shows how far each is. `end` ends the one that runs.
function stepsOf(
  progress: ProgressLine,
  lap: () => number,
  seconds: CliReport['seconds'],
): Required<StepOptions> & { end(): void } {
  let shown: ProgressCallback | undefined;
  let running: MakeStep | undefined;
  const end = (): void => {
    const taken = lap();
    if (running !== undefined) seconds[running] = taken;
  };
  return {
    onProgress: (fraction, phase) => shown?.(fraction, phase),
    onStep: (step) => {
      end();
      running = step;
      shown = progress.of(doing[step]);
    },
    end,
  };
}

async function work(
  library: KdManifold,
  command: Command,
  task: Task,
  progress: ProgressLine,
): Promise<CliReport> {
  const { files } = command;
  const formats = checkFiles(command, task);
  const report: CliReport = { seconds: { read: 0 }, peakBytes: 0, warnings: [] };
  const { seconds } = report;
  const lap = stopwatch();
  const steps = stepsOf(progress, lap, seconds);
  let made: RawMade & { grid: Grid };
  let input: MeshInput | undefined;
  progress.show('reading');
  if (formats.input === undefined) {
    if (joinsSolids(command)) {
      steps.onStep('build');
      const grid = await mergeGrids(library, command, task.input, steps.onProgress);
      made = grid.make(command.extract, command.reduction, steps);
    } else {
      const grid = library.loadGrid(await readAll(task.input), task.input);
      seconds.read = lap();
      made = grid.make(command.extract, command.reduction, steps);
      seconds.build = 0; // as the native program says
    }
  } else {
    const { mesh, warnings } = await readMesh(library, task.input, formats.input);
    report.warnings = warnings;
    seconds.read = lap();
    if (command.report.stats) {
      progress.show('analyzing');
      report.defects = library.analyze(mesh, { selfIntersections: true });
      seconds.analyze = lap();
    }
    if (!converts(command)) return report;
    if (joinsSolids(command)) {
      const files = readSolids(command, inputName(task.input));
      const scenes: GlbScene[] = [{ mesh, warnings: [] }];
      for (const { path } of files.slice(1)) {
        scenes.push(await readMesh(library, path, inputFormat(path, undefined)));
      }
      report.warnings.push(...scenes.flatMap((scene) => scene.warnings));
      made = makeSolids(library, command, files, scenes, steps);
    } else {
      input = mesh;
      const options = { ...command.build, ...command.extract, ...command.reduction };
      made = library.make(mesh, options, {}, steps);
    }
  }
  const { grid, levels, simplify, reduce, stats, report: account, ...mesh } = made;
  try {
    const { warnings, ...extracted } = account;
    steps.end();
    progress.show('writing');
    const paths = pathsOf(command, task);
    const meshes = paths.length > 1 ? levels : [mesh];
    const embedded = extracted.crossings !== null;
    await writeResults(library, command, paths, formats.output, meshes, embedded, grid);
    if (task.output !== undefined || files.saveGrid !== undefined) seconds.write = lap();
    progress.show('checking');
    const described = { ...library.describe(mesh), ...extracted };
    const checked = command.report.check
      ? { selfIntersections: library.findSelfIntersections(mesh).pairs }
      : {};
    const { check = false } = command.report;
    const { warnings: losses = [], ...found }: Partial<Account> = input
      ? grid.compare(input, mesh, { error: check })
      : {};
    report.warnings.push(...losses, ...warnings);
    report.result = {
      input: grid.input,
      operands: grid.operands,
      grid: stats,
      output: { ...described, ...checked },
      ...(simplify && { simplify }),
      ...(reduce && { reduce }),
      ...(levels.length > 0 && {
        levels: levels.map(({ indices, error }, i) => ({
          triangles: indices.length / 3,
          file: paths[i] ?? null,
          error,
        })),
      }),
      ...found,
    };
    return report;
  } finally {
    grid.delete();
  }
}

// Errors of files name these already, others are about the input. Options are called as they were typed.
function messageOf(error: unknown, command: Command, task: Task): string {
  let message = withTypedNames(command, error instanceof Error ? error.message : String(error));
  const code = error instanceof KdManifoldError ? error.code : undefined;
  const name = inputName(task.input);
  const names = (file: string): boolean => message.startsWith(`${file}: `);
  if (code === 'IO_ERROR' || names(name)) return message;
  if (command.solids.some(({ value }) => names(value))) return message;
  if (code === 'INVALID_OPTION') {
    const [option = ''] = /^[^ :]*/.exec(message) ?? [];
    const flag = `--${option.replace(/_/g, '-').replace(/[A-Z]/g, (c) => `-${c.toLowerCase()}`)}`;
    const typed = command.typed.get(flag);
    if (typed !== undefined) message = typed + message.slice(option.length);
  }
  return `${name}: ${message}`;
}

/**
 * Reads, analyzes, builds (or loads), extracts, writes, as far as it is asked for. What can be refused before the work
 * is. Errors begin with the name of a file.
 */
export async function convertFile(
  library: KdManifold,
  command: Command,
  task: Task,
  progress: ProgressLine,
): Promise<CliReport> {
  try {
    const report = await work(library, command, task, progress);
    return { ...report, peakBytes: process.resourceUsage().maxRSS * 1024 };
  } catch (error) {
    const code = error instanceof KdManifoldError ? error.code : 'INTERNAL';
    throw new KdManifoldError(code, messageOf(error, command, task));
  }
}
