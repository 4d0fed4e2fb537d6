// SPDX-License-Identifier: MIT
// `npm run bench`: sets up and hands over to tests/bench/bench.mjs, with the same arguments.
import { run, setup } from './run.mjs';

setup('wasm', 'native', 'test');
run(process.execPath, ['tests/bench/bench.mjs', ...process.argv.slice(2)]);
