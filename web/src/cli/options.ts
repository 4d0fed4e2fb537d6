// SPDX-License-Identifier: MIT
// Reads the command line's arguments by the tables in ../options.ts and table.ts, as
// src/cli/options.cpp does, word for word.
import { standardStream, type FileFormat } from './formats.js';
import { didYouMean, nearest } from './suggest.js';
import { readSolids } from './solids.js';
import { fileOptions, reportOptions, solidOptions } from './table.js';
import {
  uselessOfBuild,
  uselessOfExtract,
  uselessOfReduction,
  uselessReduction,
} from '../check-combination.js';
import type { CheckedReduction } from '../check-input.js';
import { KdManifoldError } from '../errors.js';
import { namesAGrid } from '../library.js';
import { isBox, isLegal, rangeText, signedNumber, type OptionSpec } from '../option-spec.js';
import { buildOptions, extractOptions, reductionOptions } from '../options.js';
import type { BuildOptions, ExtractOptions } from '../types.js';

/** Where results go, and what files are. */
export interface FileOptions {
  output?: string;
  outDir?: string;
  format?: FileFormat;
  inputFormat?: FileFormat;
  saveGrid?: string;
  force?: boolean;
}

/** What is looked at and said. */
export interface ReportOptions {
  check?: boolean;
  stats?: boolean;
  json?: boolean;
  quiet?: boolean;
  threads?: number;
}

/** An option that may be given several times, as it was given. */
export interface RepeatedArgument {
  flag: string;
  /** The flag as the user has typed it. */
  typed: string;
  value: string;
}

/** What the command line asks for. */
export interface Command {
  /** Paths of meshes or of saved grids, `-`, and patterns. */
  inputs: string[];
  files: FileOptions;
  report: ReportOptions;
  build: BuildOptions;
  extract: ExtractOptions;
  reduction: CheckedReduction;
  /** Operands of a Boolean operation beside INPUT, and where they go. */
  solids: RepeatedArgument[];
  /** Options that are given: how, by their flags. */
  typed: Map<string, string>;
  /** Print this instead of working. */
  answer?: 'help' | 'version';
}

/** Says whether INPUT is an operand of a Boolean operation. */
export const joinsSolids = ({ solids }: Command): boolean => solids.length > 0;

/** Says whether something is to be written. */
export const writes = ({ output, outDir, saveGrid }: FileOptions): boolean =>
  output !== undefined || outDir !== undefined || saveGrid !== undefined;

/** Says whether a grid is to be made. With --stats alone none is. */
export const converts = ({ report, files }: Command): boolean =>
  report.stats !== true || report.check === true || writes(files);

/** Returns the flag as the user has typed it: `-o`, `--splitError`. */
export const asTyped = (command: Command, flag: string): string => command.typed.get(flag) ?? flag;

/** Returns the text with the names of options in backticks as the user has typed them. */
export const withTypedNames = (command: Command, text: string): string =>
  text.replace(/`([^`]*)`/g, (_, name: string) => asTyped(command, `--${dashed(name)}`));

/** Refuses the arguments. */
export function usageError(message: string): never {
  throw new KdManifoldError('INVALID_OPTION', message);
}

const seeHelp = ' (--help lists the options)';

// What can be typed, and what it sets.
interface Entry {
  flag: string;
  short?: string;
  spec: OptionSpec;
  set: (value: string | number | boolean | number[]) => void;
}

function entriesOf(command: Command): Entry[] {
  const of = (table: Record<string, OptionSpec>, target: object): Entry[] =>
    Object.entries(table).map(([name, spec]) => ({
      flag: spec.flag,
      ...(spec.kind === 'text' && spec.shortName && { short: `-${spec.shortName}` }),
      spec,
      set: (value) => Object.assign(target, { [name]: value }),
    }));
  return [
    ...of(fileOptions, command.files),
    ...of(reportOptions, command.report),
    ...Object.values(solidOptions).map((spec) => ({ flag: spec.flag, spec, set: () => {} })),
    ...of(buildOptions, command.build),
    ...of(extractOptions, command.extract),
    ...of(reductionOptions, command.reduction),
    {
      flag: '--no-strict',
      spec: { flag: '--no-strict', kind: 'boolean', default: false },
      set: () => (command.extract.strict = 'off'),
    },
  ];
}

// `--splitError` -> `--split-error`.
const dashed = (name: string): string => name.replace(/[A-Z]/g, (c) => `-${c.toLowerCase()}`);

function refuseUnknown(name: string, entries: Entry[]): never {
  const flags = ['help', 'version', ...entries.map(({ flag }) => flag.slice(2))];
  const word = nearest(dashed(name.replace(/^-+/, '')), flags);
  let near = word === undefined ? undefined : `--${word}`;
  if (near === undefined && !name.startsWith('--')) {
    // The value may stand right behind the letter.
    const short = entries.find((entry) => entry.short && name.startsWith(entry.short))?.short;
    if (short !== undefined) near = `${short} ${name.slice(short.length)}`;
  }
  return usageError(
    `${name}: there is no such option${near === undefined ? seeHelp : `; did you mean ${near}?`}`,
  );
}

// Goes through the arguments one by one.
function scan(args: string[], command: Command): void {
  const entries = entriesOf(command);
  for (let at = 0; at < args.length;) {
    const argument = args[at++] ?? '';
    if (argument === '--') {
      command.inputs.push(...args.slice(at));
      return;
    }
    if (argument.length < 2 || !argument.startsWith('-')) {
      command.inputs.push(argument);
      continue;
    }
    const equals = argument.indexOf('=');
    const name = equals < 0 ? argument : argument.slice(0, equals);
    const flag = name.startsWith('--') ? dashed(name) : name;
    const entry =
      entries.find((known) => known.flag === flag || known.short === flag) ??
      refuseUnknown(name, entries);
    const first = !command.typed.has(entry.flag);
    if (first) command.typed.set(entry.flag, name);
    if (entry.spec.kind === 'boolean') {
      if (equals >= 0) usageError(`${name}: takes no value`);
      if (first) entry.set(!entry.spec.default);
      continue;
    }
    const repeats = entry.spec.kind === 'text' && entry.spec.repeats === true;
    if (!first && !repeats) usageError(`${name}: is given twice`);
    // What looks like an option is none's value: that one was forgotten.
    if (equals < 0 && (at === args.length || args[at]?.startsWith('--'))) {
      usageError(`${name}: the value is missing`);
    }
    const text = equals < 0 ? (args[at++] ?? '') : argument.slice(equals + 1);
    const value = readValue(name, entry.spec, text);
    if (repeats) command.solids.push({ flag: entry.flag, typed: name, value: text });
    else entry.set(value);
  }
}

function readValue(name: string, spec: OptionSpec, text: string): string | number | number[] {
  switch (spec.kind) {
    case 'text':
      if (text === '') usageError(`${name}: the value is empty`);
      return text;
    case 'choice':
      if (spec.words.includes(text)) return text;
      return usageError(
        `${name}: '${text}' is none of ${spec.words.join(', ')}${didYouMean(text, spec.words)}`,
      );
    case 'integer':
    case 'number': {
      const whole = spec.kind === 'integer';
      const value = (whole ? /^\d+$/ : /^(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i).test(text)
        ? Number(text)
        : NaN;
      if (isLegal(value, spec)) return value;
      return usageError(
        `${name}: '${text}' is no ${whole ? 'whole ' : ''}number ${rangeText(spec)}`,
      );
    }
    case 'numbers':
      return readNumbers(name, spec.least, text);
    case 'box':
      return readBox(name, text);
    case 'boolean':
      return usageError(`${name}: takes no value`);
  }
}

function readBox(name: string, text: string): number[] {
  const box = text.split(',').map(signedNumber);
  if (isBox(box)) return box;
  return usageError(
    `${name}: '${text}' is no box: 6 numbers with commas between them, the lowest corner before the highest`,
  );
}

// Reads whole numbers of which each is smaller than the one before. What is too large for 32 bits limits nothing.
function readNumbers(name: string, least: number, text: string): number[] {
  const numbers: number[] = [];
  for (const part of text.split(',')) {
    const number = /^\d+$/.test(part) ? Number(part) : NaN;
    if (!(number >= least)) usageError(`${name}: '${part}' is no whole number from ${least} on`);
    const index = Math.min(number, 0xffffffff);
    if (index >= (numbers.at(-1) ?? Infinity)) {
      usageError(`${name}: '${part}' must be smaller than the number before`);
    }
    numbers.push(index);
  }
  return numbers;
}

// Refuses options of building, extracting and reducing that have no effect or exclude each other.
function checkEffects(command: Command): void {
  const isGiven = (name: string): boolean => command.typed.has(`--${dashed(name)}`);
  const useless =
    uselessOfBuild(command.build, isGiven) ??
    uselessOfExtract(command.extract, isGiven) ??
    uselessOfReduction(command.reduction, isGiven) ??
    uselessReduction(command.reduction, command.build, command.extract);
  if (useless) usageError(withTypedNames(command, `\`${useless.name}\`: ${useless.when}`));
}

// What the values alone cannot tell.
function checkCombination(command: Command): void {
  const { inputs, files, report } = command;
  const refuse = (flag: string, text: string): never =>
    usageError(`${asTyped(command, flag)}: ${text}`);
  if (inputs.length === 0) usageError(`INPUT is required${seeHelp}`);
  if (inputs.includes('')) usageError(`INPUT is empty${seeHelp}`);
  if (files.saveGrid !== undefined && !namesAGrid(files.saveGrid)) {
    refuse('--save-grid', `'${files.saveGrid}' does not end in .kdgrid`);
  }
  if (files.outDir !== undefined && files.output !== undefined) {
    refuse('--out-dir', `not together with ${asTyped(command, '--output')}`);
  }
  if (files.outDir !== undefined && files.saveGrid !== undefined) {
    refuse('--out-dir', `not together with ${asTyped(command, '--save-grid')}`);
  }
  readSolids(command);
  if (command.typed.has('--no-strict') && command.typed.has('--strict')) {
    refuse('--no-strict', `not together with ${asTyped(command, '--strict')}`);
  }
  if (files.format !== undefined && files.output === undefined && files.outDir === undefined) {
    refuse('--format', 'only with -o or --out-dir');
  }
  const { reduce, targetTriangles } = command.reduction;
  if (targetTriangles && reduce === false) {
    refuse('--target-triangles', `not together with ${asTyped(command, '--no-reduce')}`);
  }
  checkEffects(command);
  if (targetTriangles && targetTriangles.length > 1 && files.output === standardStream) {
    refuse('--target-triangles', 'standard output takes one level, not several');
  }
  if (report.quiet && report.json) {
    refuse('--quiet', 'not together with --json, which prints a report');
  }
}

/**
 * Reads the arguments. Options are `--name VALUE`, `--name=VALUE`, `-o VALUE`; names may be written in camel case. All
 * that follows `--` are inputs. Throws with one line if something is wrong; looks at no file.
 */
export function readCommand(args: string[]): Command {
  const command: Command = {
    inputs: [],
    files: {},
    report: {},
    build: {},
    extract: {},
    reduction: {},
    solids: [],
    typed: new Map(),
  };
  // Whatever else is wrong: who asks for help gets it.
  const end = args.includes('--') ? args.indexOf('--') : args.length;
  const asked = args.slice(0, end);
  if (asked.includes('--help') || asked.includes('-h')) return { ...command, answer: 'help' };
  if (asked.includes('--version')) return { ...command, answer: 'version' };
  scan(args, command);
  checkCombination(command);
  return command;
}
