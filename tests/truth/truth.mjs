// SPDX-License-Identifier: MIT
// `npm run truth -- [MINUTES] [--kind KIND] [--seed SEED] [--count N] [--write FILE.obj]`
// Random solids against an exact account of their own: a table by kind, and the smallest solids that
// fail. With --kind and --seed alone: that solid in words, and its input as a file for the command
// line. Exit status 1 if anything is not as it must be.
import { resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { tryRun } from '../../scripts/run.mjs';
import { buildTools } from '../bench/shared.mjs';

const text = { type: 'string' };
const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: { kind: text, seed: text, count: text, write: text },
});
if (positionals.length > 1 || positionals.some((minutes) => !(Number(minutes) > 0))) {
  console.error(`truth: '${positionals.join(' ')}' is no number of minutes`);
  process.exit(2);
}
if (values.write !== undefined) {
  values.write = resolve(process.env.INIT_CWD ?? process.cwd(), values.write);
}
if (positionals.length === 1) values.minutes = positionals[0];
const args = Object.entries(values).flatMap(([name, value]) => [`--${name}`, value]);
const { status } = tryRun(`${buildTools(['kdm_truth'])}/kdm_truth`, args);
process.exitCode = status ?? 2;
