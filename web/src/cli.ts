#!/usr/bin/env node
// SPDX-License-Identifier: MIT
// The command line in Node: the same options, report, files and exit statuses as the native one.
// 0: done; 1: --check found an output not 2-manifold; 2: bad input or option, one line of error each.
import { realpathSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { convertFile } from './cli/convert.js';
import { standardStream } from './cli/formats.js';
import { converts, readCommand, writes, type Command } from './cli/options.js';
import { plan, type Task } from './cli/plan.js';
import { ProgressLine } from './cli/progress.js';
import { passesCheck, reportAsJson, reportAsText, type CliReport } from './cli/report.js';
import { helpText } from './cli/table.js';
import type { KdManifold } from './library.js';
import { load } from './load.js';

const notManifold = 1;
const badInput = 2;

const textOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));

// Prints one line on standard error. Messages may quote file names, which may hold any character.
function say(message: string): void {
  const line = Array.from(message, (c) => (c < ' ' ? ' ' : c)).join('');
  process.stderr.write(`kdmanifold: ${line}\n`);
}

// Does the tasks one after the other, and remembers how they ended.
class Run {
  readonly #library: KdManifold;
  readonly #command: Command;
  readonly #tasks: Task[];
  readonly #progress: ProgressLine;
  readonly #list: object[] = []; // the reports of several inputs
  #printed = 0; // reports for people
  #failed = false;
  #notManifold = false;

  constructor(library: KdManifold, command: Command) {
    this.#library = library;
    this.#command = command;
    this.#tasks = plan(command);
    this.#progress = new ProgressLine(!command.report.quiet && process.stderr.isTTY);
  }

  async finish(): Promise<number> {
    const { report, files } = this.#command;
    for (const [i, task] of this.#tasks.entries()) await this.#perform(task, i);
    if (this.#several && report.json) this.#print(`${JSON.stringify(this.#list, null, 2)}\n`);
    if (this.#printed > 0 && converts(this.#command) && !writes(files)) {
      this.#print(
        this.#several
          ? '\nnothing was written: --out-dir DIR keeps the results\n'
          : 'nothing was written: -o FILE keeps the result\n',
      );
    }
    if (this.#failed) return badInput;
    return this.#notManifold ? notManifold : 0;
  }

  get #several(): boolean {
    return this.#tasks.length > 1;
  }

  #print(text: string): void {
    const { report, files } = this.#command;
    if (report.quiet) return;
    (files.output === standardStream ? process.stderr : process.stdout).write(text);
  }

  async #perform(task: Task, index: number): Promise<void> {
    if (this.#several) this.#progress.begin(`${index + 1} of ${this.#tasks.length}: `);
    try {
      const report = await convertFile(this.#library, this.#command, task, this.#progress);
      this.#progress.clear();
      this.#tell(report, task);
    } catch (error) {
      this.#progress.clear();
      say(textOf(error));
      this.#failed = true;
      this.#list.push({ file: task.input, error: textOf(error) });
    }
  }

  #tell(report: CliReport, task: Task): void {
    const options = this.#command.report;
    if (!options.json) {
      this.#print(`${this.#printed++ > 0 ? '\n' : ''}${reportAsText(report, this.#command, task)}`);
    } else if (this.#several) {
      this.#list.push({ file: task.input, ...reportAsJson(report, this.#command) });
    } else {
      this.#print(`${JSON.stringify(reportAsJson(report, this.#command), null, 2)}\n`);
    }
    const { output, grid } = report.result ?? {};
    if (options.check && output && grid && !passesCheck(output, grid.sheet)) {
      this.#notManifold = true;
    }
  }
}

/** Runs the command line with these arguments; returns the exit status. */
export async function runCli(args: string[]): Promise<number> {
  // Who does not read what is printed any more need not be told.
  process.stdout.on('error', () => {});
  process.stderr.on('error', () => {});
  try {
    const command = readCommand(args);
    if (command.answer === 'help') {
      process.stdout.write(helpText);
      return 0;
    }
    const library = await load({ threads: command.answer ? 1 : command.report.threads });
    if (command.answer === 'version') {
      process.stdout.write(`kdmanifold ${library.version}\n`);
      return 0;
    }
    return await new Run(library, command).finish();
  } catch (error) {
    say(textOf(error));
    return badInput;
  }
}

if (
  process.argv[1] !== undefined &&
  realpathSync(process.argv[1]) === fileURLToPath(import.meta.url)
) {
  process.exitCode = await runCli(process.argv.slice(2));
}
