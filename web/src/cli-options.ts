// SPDX-License-Identifier: MIT
// Reads the command line's arguments by the tables in options.ts and cli-table.ts.
import { parseArgs, type ParseArgsConfig } from 'node:util';
import { KdManifoldError } from './errors.js';
import { namesAGrid } from './library.js';
import { commandOptions } from './cli-table.js';
import { isLegal, rangeText, type OptionSpec } from './option-spec.js';
import { buildOptions, extractOptions } from './options.js';
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

/** Says whether a grid is to be made. With --stats alone none is. */
export function converts({ stats, check, output, saveGrid }: Command): boolean {
  return !stats || check || output !== undefined || saveGrid !== undefined;
}

function usageError(message: string): never {
  throw new KdManifoldError('INVALID_OPTION', message);
}

type Values = Record<string, unknown>;

/** Reads the arguments; throws with one line if they are wrong. */
export function readCommand(args: string[]): Command {
  const options: NonNullable<ParseArgsConfig['options']> = {
    help: { type: 'boolean', short: 'h' },
    version: { type: 'boolean' },
    'no-strict': { type: 'boolean' },
  };
  for (const spec of Object.values({ ...buildOptions, ...extractOptions, ...commandOptions })) {
    options[spec.flag.slice(2)] = {
      type: spec.kind === 'boolean' ? 'boolean' : 'string',
      ...(spec.kind === 'text' && spec.shortName && { short: spec.shortName }),
    };
  }
  const { values, positionals } = parse(args, options);
  const command: Command = {
    input: positionals[0] ?? '',
    build: readTable(buildOptions, values),
    extract: readTable(extractOptions, values['no-strict'] ? { ...values, strict: 'off' } : values),
    json: false,
    check: false,
    stats: false,
    ...readTable(commandOptions, values),
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
  for (const name of Object.keys(command.build) as (keyof BuildOptions)[]) {
    if (namesAGrid(command.input)) {
      usageError(`${buildOptions[name].flag}: the grid in ${command.input} is built already`);
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

// Reads the options of the table that are given, by their property names.
function readTable(table: Record<string, OptionSpec>, values: Values): object {
  const read: Record<string, unknown> = {};
  for (const [name, spec] of Object.entries(table)) {
    const text = values[spec.flag.slice(2)];
    if (text !== undefined) read[name] = readValue(spec, text as string);
  }
  return read;
}

function readValue(spec: OptionSpec, text: string): string | number | boolean {
  const { flag, kind } = spec;
  switch (kind) {
    case 'text':
      return text;
    case 'boolean':
      return !spec.default;
    case 'choice':
      if (spec.words.includes(text)) return text;
      return usageError(`${flag}: '${text}' is none of ${spec.words.join(', ')}`);
    case 'integer':
    case 'number': {
      const whole = kind === 'integer';
      const value = (whole ? /^\d+$/ : /^(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i).test(text)
        ? Number(text)
        : NaN;
      if (isLegal(value, spec)) return value;
      return usageError(
        `${flag}: '${text}' is no ${whole ? 'whole ' : ''}number ${rangeText(spec)}`,
      );
    }
  }
}
