// SPDX-License-Identifier: MIT
// What is to be done, one input after the other, as src/cli/plan.cpp plans it, word for word.
import { dirname } from 'node:path';
import { checkFolder, exists } from './files.js';
import { fileName, standardStream } from './formats.js';
import { expand, isPattern } from './glob.js';
import { asTyped, usageError, type Command } from './options.js';
import { namesAGrid } from '../library.js';
import { buildOptions } from '../options.js';

/** One input and its result. */
export interface Task {
  /** A path, or `-`. */
  input: string;
  /** A path, or `-`; undefined: no mesh is written. */
  output?: string;
  /** A saved grid is to be loaded. */
  isGrid: boolean;
}

const refuse = (command: Command, flag: string, text: string): never =>
  usageError(`${asTyped(command, flag)}: ${text}`);

// Every file once, in the order in which they come first. What exists is no pattern.
function expandAll(inputs: string[]): string[] {
  const paths = new Set<string>();
  for (const input of inputs) {
    if (!isPattern(input) || exists(input)) {
      paths.add(input);
      continue;
    }
    const found = expand(input);
    if (found.length === 0) usageError(`${input}: no file fits this pattern`);
    for (const path of found) paths.add(path);
  }
  return [...paths];
}

function checkNumber(command: Command, count: number): void {
  if (count === 1) return;
  if (command.files.output !== undefined) {
    refuse(
      command,
      '--output',
      `it takes the result of one input, but there are ${count}; --out-dir takes those of several`,
    );
  }
  if (command.files.saveGrid !== undefined) {
    refuse(command, '--save-grid', `it takes the grid of one input, but there are ${count}`);
  }
}

function checkGrid(command: Command, input: string): void {
  if (command.report.stats) refuse(command, '--stats', `${input} is a grid, which has no faces`);
  for (const { flag } of Object.values(buildOptions)) {
    if (command.typed.has(flag)) refuse(command, flag, `the grid in ${input} is built already`);
  }
}

// Grids are merged with grids, meshes joined with meshes.
function checkOperands({ solids }: Command, { input, isGrid }: Task): void {
  for (const { flag, typed, value } of solids) {
    if (flag === '--transform') {
      if (isGrid) usageError(`${typed}: the grid in ${input} stays where it is`);
    } else if (isGrid !== namesAGrid(value)) {
      usageError(
        isGrid
          ? `${typed}: ${value} is no grid, but ${input} is: grids are merged with grids`
          : `${typed}: ${value} is a grid, but ${input} is a mesh`,
      );
    }
  }
}

// The path of the result in --out-dir.
function pathIn(folder: string, command: Command, { input, isGrid }: Task): string {
  if (input === standardStream) {
    refuse(command, '--out-dir', 'standard input has no name that its result could have');
  }
  let name = fileName(input);
  const { format } = command.files;
  if (format !== undefined) {
    const dot = name.lastIndexOf('.');
    name = `${dot > 0 ? name.slice(0, dot) : name}.${format}`;
  } else if (isGrid) {
    refuse(command, '--out-dir', `what ${input} becomes is for --format to say`);
  }
  return `${folder}${folder.endsWith('/') ? '' : '/'}${name}`;
}

function checkNames(command: Command, tasks: Task[]): void {
  const inputs = new Map<string, string>(); // by the names of their results
  for (const { input, output = '' } of tasks) {
    const first = inputs.get(output);
    if (first !== undefined) {
      refuse(command, '--out-dir', `${first} and ${input} would both become ${output}`);
    }
    inputs.set(output, input);
  }
}

/** Returns the path of a level of the result, from 1 on: `name.1.obj` for `name.obj`. */
export function levelPath(output: string, level: number): string {
  const name = output.length - fileName(output).length;
  const dot = output.lastIndexOf('.');
  const end = dot <= name ? output.length : dot;
  return `${output.slice(0, end)}.${level}${output.slice(end)}`;
}

/**
 * Expands patterns, leaves out what is given twice and names the results. Throws if a pattern fits no file, if the
 * options do not go together with so many inputs or with grids, if two results would have one name, or if --out-dir
 * can hold no files.
 */
export function plan(command: Command): Task[] {
  const { output, outDir, inputFormat } = command.files;
  const inputs = expandAll(command.inputs);
  checkNumber(command, inputs.length);
  const tasks = inputs.map((input) => {
    const task: Task = { input, isGrid: inputFormat === undefined && namesAGrid(input) };
    if (output !== undefined) task.output = output;
    if (task.isGrid) checkGrid(command, input);
    checkOperands(command, task);
    if (outDir !== undefined) task.output = pathIn(outDir, command, task);
    return task;
  });
  if (outDir !== undefined) {
    checkNames(command, tasks);
    checkFolder(exists(outDir) ? outDir : dirname(outDir), asTyped(command, '--out-dir'));
  }
  return tasks;
}
