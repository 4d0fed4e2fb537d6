// SPDX-License-Identifier: MIT
// The work for one input, in the steps of src/cli/convert.cpp.
import { checkFolderOf, checkTarget, makeFolder, readAll, writeAll } from './files.js';
import { inputFormat, inputName, outputFormat, type FileFormat } from './formats.js';
import { readGlb, type GlbScene } from './glb-read.js';
import { writeGlb } from './glb-write.js';
import { converts, withTypedNames, type Command } from './options.js';
import type { Task } from './plan.js';
import type { ProgressLine } from './progress.js';
import type { CliReport } from './report.js';
import { KdManifoldError } from '../errors.js';
import type { Grid } from '../grid.js';
import type { KdManifold } from '../library.js';
import type { Account, Mesh, MeshInput } from '../types.js';

// What a task's files are: nothing for grids, and where there is no output.
interface Formats {
  input?: FileFormat;
  output?: FileFormat;
}

// Refuses before the work what can be refused then.
function checkFiles({ files, extract }: Command, { input, output, isGrid }: Task): Formats {
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
    checkTarget(output, force);
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
  { files, extract }: Command,
  { output }: Task,
  format: FileFormat | undefined,
  mesh: Mesh,
  grid: Grid,
): Promise<void> {
  if (output !== undefined && format !== undefined) {
    const exact = extract.strict === 'embedded';
    const bytes = format === 'glb' ? writeGlb(mesh) : library.formatMesh(mesh, format, { exact });
    if (files.outDir !== undefined) makeFolder(files.outDir);
    await writeAll(output, bytes);
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
  let grid: Grid;
  let input: MeshInput | undefined;
  progress.show('reading');
  if (formats.input === undefined) {
    grid = library.loadGrid(await readAll(task.input), task.input);
    seconds.read = lap();
    seconds.build = 0;
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
    input = mesh;
    grid = library.buildGrid(mesh, { ...command.build, onProgress: progress.of('building') });
    seconds.build = lap();
  }
  try {
    const onProgress = progress.of('extracting');
    const extraction = grid.extract({ ...command.extract, onProgress });
    const {
      report: { warnings, ...extracted },
      ...mesh
    } = extraction;
    seconds.extract = lap();
    progress.show('writing');
    await writeResults(library, command, task, formats.output, mesh, grid);
    if (task.output !== undefined || files.saveGrid !== undefined) seconds.write = lap();
    progress.show('checking');
    const described = { ...library.describe(mesh), ...extracted };
    const checked = command.report.check
      ? { selfIntersections: library.findSelfIntersections(mesh).pairs }
      : {};
    const { check = false } = command.report;
    const { warnings: losses = [], ...account }: Partial<Account> = input
      ? grid.compare(input, mesh, { error: check })
      : {};
    report.warnings.push(...losses, ...warnings);
    report.result = {
      input: grid.input,
      grid: grid.stats,
      output: { ...described, ...checked },
      ...account,
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
  if (code === 'IO_ERROR' || message.startsWith(`${name}: `)) return message;
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
