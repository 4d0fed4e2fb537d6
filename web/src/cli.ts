#!/usr/bin/env node
// SPDX-License-Identifier: MIT
// The command line in Node: the same options, report, files and exit statuses as the native one.
// 0: done; 1: --check found the output not 2-manifold; 2: bad input or option, one line of error.
import { readFileSync, realpathSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { converts, readCommand, type Command } from './cli-options.js';
import { passesCheck, reportAsJson, reportAsText, type CliReport } from './cli-report.js';
import { helpText } from './cli-table.js';
import { KdManifoldError } from './errors.js';
import type { Grid } from './grid.js';
import { formatFromPath, namesAGrid } from './library.js';
import { load } from './load.js';

const notManifold = 1;
const badInput = 2;

/** What the process printed and how it ended. */
export interface Outcome {
  status: number;
  out: string;
  err: string;
}

/** Runs the command line with these arguments. */
export async function runCli(args: string[]): Promise<Outcome> {
  let command: Command | undefined;
  try {
    command = readCommand(args);
    const library = await load();
    if (command.help) return { status: 0, out: helpText, err: '' };
    if (command.version) return { status: 0, out: `kdmanifold ${library.version}\n`, err: '' };
    const report = convertFile(library, command);
    const { output, grid } = report.result ?? {};
    const failed = command.check && output && grid && !passesCheck(output, grid.sheet);
    return {
      status: failed ? notManifold : 0,
      out: command.json ? reportAsJson(report, command) : reportAsText(report, command),
      err: '',
    };
  } catch (error) {
    return {
      status: badInput,
      out: '',
      err: `kdmanifold: ${oneLine(messageOf(error, command))}\n`,
    };
  }
}

function convertFile(library: Awaited<ReturnType<typeof load>>, command: Command): CliReport {
  const { input, output } = command;
  // Refuses an unknown output format before the work rather than after it.
  const outputFormat = output === undefined ? undefined : formatFromPath(output);
  const report: CliReport = { seconds: { read: 0 }, peakBytes: 0 };
  const { seconds } = report;
  const lap = stopwatch();
  let grid: Grid;
  if (namesAGrid(input)) {
    grid = library.loadGrid(readInput(input), input);
    seconds.read = lap();
    seconds.build = 0;
  } else {
    const inputFormat = formatFromPath(input);
    const mesh = library.parseMesh(readInput(input), inputFormat, input);
    seconds.read = lap();
    if (command.stats) {
      report.defects = library.analyze(mesh, { selfIntersections: true });
      seconds.analyze = lap();
    }
    if (!converts(command)) return { ...report, peakBytes: peakBytes() };
    grid = library.buildGrid(mesh, command.build);
    seconds.build = lap();
  }
  const { report: extracted, ...mesh } = grid.extract(command.extract);
  seconds.extract = lap();
  if (output !== undefined && outputFormat !== undefined) {
    const exact = command.extract.strict === 'embedded';
    writeWhole(output, library.formatMesh(mesh, outputFormat, { exact }));
  }
  if (command.saveGrid !== undefined) writeWhole(command.saveGrid, grid.save());
  if (output !== undefined || command.saveGrid !== undefined) seconds.write = lap();
  const described = { ...library.describe(mesh), ...extracted };
  const checked = command.check
    ? { selfIntersections: library.findSelfIntersections(mesh).pairs }
    : {};
  report.result = {
    input: grid.input,
    grid: grid.stats,
    output: { ...described, ...checked },
  };
  return { ...report, peakBytes: peakBytes() };
}

const peakBytes = (): number => process.resourceUsage().maxRSS * 1024;

function stopwatch(): () => number {
  let last = performance.now();
  return () => {
    const now = performance.now();
    const seconds = (now - last) / 1000;
    last = now;
    return seconds;
  };
}

function readInput(path: string): Uint8Array {
  try {
    return readFileSync(path);
  } catch (error) {
    throw new KdManifoldError('IO_ERROR', `${path}: cannot be read: ${reasonOf(error)}`);
  }
}

// Writes under another name first, so that the file appears complete or not at all.
function writeWhole(path: string, content: Uint8Array): void {
  const temporary = `${path}.${process.pid}.part`;
  try {
    writeFileSync(temporary, content);
    renameSync(temporary, path);
  } catch (error) {
    rmSync(temporary, { force: true });
    throw new KdManifoldError('IO_ERROR', `${path}: cannot be written: ${reasonOf(error)}`);
  }
}

const reasonOf = (error: unknown): string =>
  (error as NodeJS.ErrnoException).code ?? (error as Error).message;

// Errors of reading and writing name the file already, and errors in the arguments name the argument.
function messageOf(error: unknown, command: Command | undefined): string {
  const message = error instanceof Error ? error.message : String(error);
  const named =
    command === undefined ||
    message.startsWith(command.input) ||
    (error as KdManifoldError).code === 'IO_ERROR';
  return named ? message : `${command.input}: ${message}`;
}

const oneLine = (text: string): string =>
  Array.from(text, (c) => (c < ' ' ? ' ' : c))
    .join('')
    .trim();

if (
  process.argv[1] !== undefined &&
  realpathSync(process.argv[1]) === fileURLToPath(import.meta.url)
) {
  const { status, out, err } = await runCli(process.argv.slice(2));
  process.stdout.write(out);
  process.stderr.write(err);
  process.exitCode = status;
}
