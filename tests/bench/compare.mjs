// SPDX-License-Identifier: MIT
// `node tests/bench/compare.mjs BASE [--models DIR] [--settings median:19]... [--rounds 5]`
// Times the working tree against another commit: builds both, runs them in turn (so that a busy
// machine hurts both alike), and prints medians and their ratio; below 1 is faster than before.
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { output, run } from '../../scripts/run.mjs';
import { buildTools, commandLine, median, modelFiles, printTable } from './shared.mjs';

const options = commandLine({
  settings: { type: 'string', multiple: true },
  rounds: { type: 'string', default: '5' },
});
const [base, ...models] = options.models;
if (base === undefined) {
  console.error('compare: name the commit to compare with, e.g. HEAD~1');
  process.exit(2);
}
const commit = output('git', ['rev-parse', '--verify', `${base}^{commit}`]).trim();
const folder = mkdtempSync(join(tmpdir(), 'kdm-compare-'));
const tree = join(folder, 'tree');
try {
  run('git', ['worktree', 'add', '--detach', tree, commit]);
  if (!existsSync(join(tree, 'tests/bench/CMakeLists.txt'))) {
    throw new Error(`${base} has no benchmark to build`);
  }
  const settings = ['CMAKE_BUILD_TYPE=Release', 'KDM_BUILD_BENCH=ON', 'KDM_BUILD_CLI=OFF'];
  const build = join(folder, 'build');
  run('cmake', ['-S', tree, '-B', build, '-G', 'Ninja', ...settings.map((one) => `-D${one}`)]);
  run('cmake', ['--build', build, '-j', '2', '--target', 'kdm_bench']);
  compare(join(build, 'tests/bench/kdm_bench'), join(buildTools(), 'kdm_bench'));
} finally {
  run('git', ['worktree', 'remove', '--force', tree]);
  rmSync(folder, { recursive: true });
}

function compare(before, after) {
  const samples = { before: new Map(), after: new Map() };
  for (let round = 0; round < Number(options.rounds); ++round) {
    for (const [side, program] of Object.entries({ before, after })) {
      for (const { key, seconds } of runOnce(program)) {
        for (const [stage, value] of Object.entries(seconds)) {
          const name = `${key} ${stage}`;
          samples[side].set(name, [...(samples[side].get(name) ?? []), value]);
        }
      }
    }
  }
  const rows = [];
  for (const [name, values] of samples.after) {
    const earlier = samples.before.get(name);
    const now = median(values);
    if (earlier === undefined) continue;
    const then = median(earlier);
    if (then < 0.001 && now < 0.001) continue;
    rows.push({
      stage: name,
      before: then.toFixed(4),
      after: now.toFixed(4),
      ratio: (now / then).toFixed(2),
    });
  }
  printTable(rows);
}

function runOnce(program) {
  const report = join(folder, 'report.json');
  const chosen = models.length > 0 ? ['--models', ...modelFiles(models, [])] : [];
  const settings = options.settings ? ['--settings', ...options.settings] : [];
  output(program, [...chosen, ...settings, '--repeat', '1', '--json', report]);
  return JSON.parse(readFileSync(report, 'utf8'))
    .filter((row) => row.error === undefined)
    .map((row) => ({ key: `${row.model} ${row.strategy}:${row.depth}`, seconds: row.seconds }));
}
