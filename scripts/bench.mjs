// SPDX-License-Identifier: MIT
// `npm run bench`: sets up and hands over to tests/bench/bench.mjs, with the same arguments;
// `npm run bench -- --compare COMMIT` to tests/bench/compare.mjs.
import { run, setup } from './run.mjs';

setup('wasm', 'native', 'test');
const [first, ...rest] = process.argv.slice(2);
const script = first === '--compare' ? 'compare' : 'bench';
const args = first === '--compare' ? rest : process.argv.slice(2);
run(process.execPath, [`tests/bench/${script}.mjs`, ...args]);
