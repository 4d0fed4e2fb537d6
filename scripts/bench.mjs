// SPDX-License-Identifier: MIT
// `npm run bench`: sets up and hands over to tests/bench/bench.mjs, with the same arguments;
// `npm run bench -- --compare COMMIT` to compare.mjs, `--cold-start` to cold_start.mjs, `--peers` to peers.mjs,
// `--solids` to solids.mjs, `--counts` to counts.mjs, `--reduce` to reduce.mjs,
// `--drag` to drag.mjs, `--whole` to whole.mjs, `--threads` to threads.mjs, `--equal` to equal.mjs.
import { run, setup } from './run.mjs';

setup('wasm', 'native', 'test');
const [first, ...rest] = process.argv.slice(2);
const others = {
  '--compare': 'compare',
  '--cold-start': 'cold_start',
  '--peers': 'peers',
  '--solids': 'solids',
  '--counts': 'counts',
  '--reduce': 'reduce',
  '--drag': 'drag',
  '--whole': 'whole',
  '--threads': 'threads',
  '--equal': 'equal',
};
const script = others[first] ?? 'bench';
const args = first in others ? rest : process.argv.slice(2);
run(process.execPath, [`tests/bench/${script}.mjs`, ...args]);
