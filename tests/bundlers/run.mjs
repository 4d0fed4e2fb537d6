// SPDX-License-Identifier: MIT
// `npm run bundlers [-- [--latest] NAME...]`: tries the package, packed, in fresh folders with every bundler of
// cases.mjs (or those whose names begin so), and prints what each needed and whether a worker did the work.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { setup } from '../../scripts/run.mjs';
import { builders } from '../../scripts/build.mjs';
import { cases } from './cases.mjs';
import { pack, tryCase } from './try.mjs';

setup('wasm', 'test');
if (!process.argv.includes('--no-build')) builders.package();
const { launch } = await import('../js/support/browser.js');
const { serve } = await import('../js/support/server.js');

const wanted = process.argv.slice(2).filter((word) => !word.startsWith('--'));
const latest = process.argv.includes('--latest');
const folder = mkdtempSync(join(tmpdir(), 'kdmanifold-packed-'));
let failed = 0;
try {
  const packed = pack(folder);
  console.log('| bundler | versions | configuration | warnings | thread | wasm from |');
  console.log('| --- | --- | --- | --- | --- | --- |');
  for (const [name, trial] of Object.entries(cases)) {
    if (wanted.length > 0 && !wanted.some((word) => name.startsWith(word))) continue;
    let result;
    try {
      result = await tryCase(trial, packed, { launch, serve, latest });
    } catch (error) {
      result = { problems: [String(error)] };
    }
    const { versions = [], warnings = [], outcomes = [], wasm = [], problems } = result;
    const good = outcomes.length > 0 && outcomes.every((o) => o.twoManifold && o.same);
    if (!good || problems.length > 0 || warnings.length > 0) ++failed;
    const threads = outcomes.map((outcome) => outcome.thread ?? outcome.error).join(', ');
    const row = [name, versions.join(', '), trial.needed ?? 'none', warnings.length, threads];
    console.log(`| ${[...row, [...new Set(wasm)].join(', ')].join(' | ')} |`);
    for (const problem of [...warnings, ...problems]) console.log(`    ${problem}`);
  }
} finally {
  rmSync(folder, { recursive: true, force: true });
}
process.exit(failed === 0 ? 0 : 1);
