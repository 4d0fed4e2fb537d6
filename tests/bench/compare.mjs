// SPDX-License-Identifier: MIT
// `npm run bench -- --compare BASE [--models DIR] [--settings median:19]... [--rounds 5]`
// Times the working tree against another commit: builds both, runs them in turn (so that a busy
// machine hurts both alike), and prints medians and their ratio; below 1 is faster than before.
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { jobs, output, tryRun } from '../../scripts/run.mjs';
import {
  buildTools,
  commandLine,
  median,
  meshToMesh,
  modelFiles,
  printTable,
  withFolder,
} from './shared.mjs';

const options = commandLine({
  settings: { type: 'string', multiple: true },
  rounds: { type: 'string', default: '5' },
});
const [base] = options.positionals;
const models = options.models.filter((path) => path !== base);
if (base === undefined) {
  console.error('compare: name the commit to compare with, e.g. HEAD~1');
  process.exit(2);
}
const commit = output('git', ['rev-parse', '--verify', `${base}^{commit}`]).trim();
await withFolder((folder) => {
  const tree = join(folder, 'tree');
  demand('git', ['worktree', 'add', '--detach', tree, commit]);
  try {
    compare(folder, buildBase(folder, tree), join(buildTools(), 'kdm_bench'));
  } finally {
    demand('git', ['worktree', 'remove', '--force', tree]);
  }
});

// Not `run`, which would end this script at once and leave the worktree behind.
function demand(command, args) {
  const { status, error } = tryRun(command, args);
  if (error || status !== 0) throw error ?? new Error(`${command} ${args[0]}: status ${status}`);
}

/** The benchmark program as that commit has it, so that no interface need have stayed the same. */
function buildBase(folder, tree) {
  if (!existsSync(join(tree, 'tests/bench/CMakeLists.txt'))) {
    throw new Error(`${base} has no benchmark to build`);
  }
  const build = join(folder, 'build');
  const set = [
    'CMAKE_BUILD_TYPE=Release',
    'KDM_UNITY=ON',
    'KDM_BUILD_BENCH=ON',
    'KDM_BUILD_CLI=OFF',
  ];
  demand('cmake', ['-S', tree, '-B', build, '-G', 'Ninja', ...set.map((one) => `-D${one}`)]);
  demand('cmake', ['--build', build, '-j', jobs, '--target', 'kdm_bench']);
  return join(build, 'tests/bench/kdm_bench');
}

function compare(folder, before, after) {
  const samples = { before: new Map(), after: new Map() };
  const clocks = new Set();
  for (let round = 0; round < Number(options.rounds); ++round) {
    const sides = Object.entries({ before, after });
    if (round % 2 === 1) sides.reverse();
    for (const [side, program] of sides) {
      for (const { key, clock, seconds } of runOnce(folder, program)) {
        clocks.add(clock);
        const all = { ...seconds, 'mesh to mesh': meshToMesh(seconds) };
        for (const [stage, value] of Object.entries(all)) {
          const name = `${key} ${stage}`;
          samples[side].set(name, [...(samples[side].get(name) ?? []), value]);
        }
      }
    }
  }
  const rows = [];
  for (const [name, values] of samples.after) {
    const earlier = samples.before.get(name);
    if (earlier === undefined) continue;
    const now = median(values);
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
  if (clocks.size > 1) console.log(`${base} measures wall-clock seconds: only idle machines tell`);
  if (options.json !== undefined) writeFileSync(options.json, JSON.stringify(rows, null, 1) + '\n');
  if (rows.length === 0) throw new Error(`${base} ran none of these models by these settings`);
}

function runOnce(folder, program) {
  const report = join(folder, 'report.json');
  const chosen = models.length > 0 ? ['--models', ...modelFiles(models, [])] : [];
  const settings = options.settings ? ['--settings', ...options.settings] : [];
  output(program, [...chosen, ...settings, '--repeat', '1', '--json', report]);
  // Earlier programs know no tolerance and ignore it in a setting: the default is what they did.
  return JSON.parse(readFileSync(report, 'utf8'))
    .filter((row) => row.error === undefined)
    .map(({ model, strategy, depth, relativeTolerance = 0.001, clock = 'wall', seconds }) => ({
      key: `${model} ${strategy}:${depth}:${relativeTolerance}`,
      clock,
      seconds,
    }));
}
