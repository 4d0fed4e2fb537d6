// SPDX-License-Identifier: MIT
// The command line's options, made from the table in options.ts: names with dashes, flags that are
// on by default as --no-..., and a few of the command line's own.
import { parseArgs, type ParseArgsConfig } from 'node:util';
import { KdManifoldError } from './errors.js';
import { namesAGrid } from './library.js';
import { buildOptions, extractOptions, type OptionSpec } from './options.js';
import type { BuildOptions, ExtractOptions } from './types.js';

/** What the command line asks for. */
export interface Command {
  input: string;
  output?: string;
  saveGrid?: string;
  build: BuildOptions;
  extract: ExtractOptions;
  json: boolean;
  check: boolean;
  stats: boolean;
  help: boolean;
  version: boolean;
}

/** Is there a grid to be made? Not with --stats alone. */
export function converts({ stats, check, output, saveGrid }: Command): boolean {
  return !stats || check || output !== undefined || saveGrid !== undefined;
}

const dashed = (name: string): string => name.replace(/[A-Z]/g, (c) => `-${c.toLowerCase()}`);

/** The option's name on the command line, without the leading dashes. */
const flagName = (name: string, spec: OptionSpec): string =>
  spec.kind === 'flag' && spec.default ? `no-${dashed(name)}` : dashed(name);

const ownFlags = {
  json: 'print one JSON report on standard output, nothing else',
  check: 'verify the output; exit status 1 if it is not 2-manifold',
  stats: "describe the input's defects; alone, nothing else is done",
  version: 'print the version',
  help: 'print this',
  'no-strict': 'keep double edges and parts without volume, as --strict off',
};

function usageError(message: string): never {
  throw new KdManifoldError('INVALID_OPTION', message);
}

type Values = Record<string, unknown>;

/** Reads the arguments; throws with one line if they are wrong. */
export function readCommand(args: string[]): Command {
  const options: NonNullable<ParseArgsConfig['options']> = {
    output: { type: 'string', short: 'o' },
    'save-grid': { type: 'string' },
    help: { type: 'boolean', short: 'h' },
  };
  for (const name of Object.keys(ownFlags)) options[name] ??= { type: 'boolean' };
  for (const [name, spec] of Object.entries({ ...buildOptions, ...extractOptions })) {
    options[flagName(name, spec)] = { type: spec.kind === 'flag' ? 'boolean' : 'string' };
  }
  const { values, positionals } = parse(args, options);
  const command: Command = {
    input: positionals[0] ?? '',
    output: values.output as string | undefined,
    saveGrid: values['save-grid'] as string | undefined,
    build: readTable(buildOptions, values),
    extract: readTable(extractOptions, values['no-strict'] ? { ...values, strict: 'off' } : values),
    json: values.json === true,
    check: values.check === true,
    stats: values.stats === true,
    help: values.help === true,
    version: values.version === true,
  };
  if (command.help || command.version) return command;
  if (positionals.length === 0) usageError('INPUT is required (--help lists the options)');
  if (positionals.length > 1) {
    usageError(`'${positionals[1]}': only one input is expected (--help lists the options)`);
  }
  if (command.saveGrid !== undefined && !namesAGrid(command.saveGrid)) {
    usageError(`--save-grid: '${command.saveGrid}' does not end in .kdgrid`);
  }
  if (command.stats && namesAGrid(command.input)) {
    usageError(`--stats: ${command.input} is a grid, which has no faces`);
  }
  for (const name of Object.keys(command.build)) {
    if (namesAGrid(command.input)) {
      usageError(`--${dashed(name)}: the grid in ${command.input} is built already`);
    }
  }
  return command;
}

function parse(
  args: string[],
  options: NonNullable<ParseArgsConfig['options']>,
): { values: Values; positionals: string[] } {
  try {
    return parseArgs({ args, options, allowPositionals: true });
  } catch (error) {
    return usageError(`${(error as Error).message} (--help lists the options)`);
  }
}

function readTable(table: Record<string, OptionSpec>, values: Values): object {
  const read: Record<string, unknown> = {};
  for (const [name, spec] of Object.entries(table)) {
    const text = values[flagName(name, spec)];
    if (text === undefined) continue;
    read[name] =
      spec.kind === 'flag' ? !spec.default : readValue(dashed(name), spec, text as string);
  }
  return read;
}

function readValue(name: string, spec: OptionSpec, text: string): string | number {
  const value = Number(text);
  switch (spec.kind) {
    case 'choice':
      if (spec.values.includes(text)) return text;
      return usageError(`--${name}: '${text}' is none of ${spec.values.join(', ')}`);
    case 'integer':
      if (/^\d+$/.test(text) && value >= spec.min && value <= spec.max) return value;
      return usageError(`--${name}: '${text}' is no whole number from ${spec.min} to ${spec.max}`);
    case 'number':
      if (/^(\d|\.\d)/.test(text) && value <= (spec.max ?? Number.MAX_VALUE)) return value;
      return usageError(
        `--${name}: '${text}' is no number from 0 ${spec.max === undefined ? 'on' : `to ${spec.max}`}`,
      );
    case 'flag':
      return usageError(`--${name} takes no value`);
  }
}

/** What --help prints. */
export function helpText(): string {
  const lines: [string, string][] = [
    ['-o, --output FILE', 'where the result goes'],
    ['--save-grid FILE', 'where the grid goes, to be INPUT another time (.kdgrid)'],
  ];
  for (const [name, spec] of Object.entries({ ...buildOptions, ...extractOptions })) {
    const standard = spec.default === undefined ? '' : ` (${String(spec.default)})`;
    if (spec.kind === 'choice') {
      lines.push([`--${dashed(name)} ${spec.values.join('|')}`, spec.help + standard]);
    } else if (spec.kind === 'integer') {
      lines.push([`--${dashed(name)} N`, `${spec.help}, ${spec.min} to ${spec.max}${standard}`]);
    } else if (spec.kind === 'number') {
      lines.push([`--${dashed(name)} X`, spec.help + standard]);
    } else {
      lines.push([`--${flagName(name, spec)}`, spec.default ? `do not ${spec.help}` : spec.help]);
    }
  }
  for (const [name, help] of Object.entries(ownFlags)) {
    lines.push([name === 'help' ? '-h, --help' : `--${name}`, help]);
  }
  return [
    'Makes a closed, oriented 2-manifold mesh of any mesh.',
    'Formats by extension: OBJ, STL, PLY, OFF; saved grids: .kdgrid.',
    '',
    'Usage: kdmanifold [OPTIONS] INPUT',
    '',
    'Options:',
    ...lines.map(([left, right]) => `  ${left.padEnd(40)} ${right}`),
    '',
    'Exit status: 0 done, 1 --check found the output not 2-manifold, 2 bad input or option.',
    '',
  ].join('\n');
}
