// SPDX-License-Identifier: MIT
// `npm run fresh [-- package unpacked]`: the first run on a bare Debian 12, once with Node as a Debian
// package, once with Node unpacked. What is committed is cloned there; `npm start` must serve the
// page, and `npm test -- javascript` must pass. Needs root; logs are kept in build/fresh.
import { closeSync, mkdirSync, openSync, readFileSync } from 'node:fs';
import { Machine } from './fresh/machine.mjs';
import { waysOfNode } from './fresh/node.mjs';
import { checkout, secondsOfStart, secondsOfTest } from './fresh/runs.mjs';
import { output, root, setup } from './run.mjs';
import { printTable } from '../tests/bench/shared.mjs';

const interrupted = new AbortController();

async function tryOut(way) {
  const row = { node: way, 'nodejs there': '', start: '', test: '', verdict: 'ok' };
  const path = `${root}/build/fresh/${way}.log`;
  const log = openSync(path, 'w');
  const machine = new Machine(way);
  try {
    machine.create();
    machine.copyNpmSettings(waysOfNode[way](machine));
    output('git', ['clone', '--quiet', '--no-hardlinks', root, `${machine.root}${checkout}`]);
    const options = { log, signal: interrupted.signal };
    row.start = `${(await secondsOfStart(machine, options)).toFixed(0)} s`;
    row.test = `${(await secondsOfTest(machine, options)).toFixed(0)} s`;
  } catch (error) {
    row.verdict = `FAILS: ${error.message}`;
    console.error(`${readFileSync(path, 'utf8').split('\n').slice(-30).join('\n')}\n(${path})`);
  } finally {
    row['nodejs there'] = machine.versionOf('nodejs');
    machine.remove();
    closeSync(log);
  }
  return row;
}

const ways = process.argv.length > 2 ? process.argv.slice(2) : Object.keys(waysOfNode);
const unknown = ways.find((way) => !(way in waysOfNode));
if (unknown !== undefined || process.getuid() !== 0) {
  console.error(
    unknown === undefined
      ? 'fresh: only root can make a bare machine'
      : `fresh: unknown way '${unknown}' (${Object.keys(waysOfNode).join(', ')})`,
  );
  process.exit(2);
}
for (const signal of ['SIGINT', 'SIGTERM']) process.on(signal, () => interrupted.abort());
setup('fresh');
mkdirSync(`${root}/build/fresh`, { recursive: true });
if (output('git', ['status', '--porcelain']) !== '') {
  console.log('fresh: only what is committed is tried out');
}
const rows = [];
for (const way of ways) {
  if (!interrupted.signal.aborted) rows.push(await tryOut(way));
}
printTable(rows);
process.exitCode =
  rows.every(({ verdict }) => verdict === 'ok') && !interrupted.signal.aborted ? 0 : 1;
