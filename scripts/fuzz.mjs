// SPDX-License-Identifier: MIT
// `npm run fuzz -- [MINUTES]` (20): libFuzzer on all targets under sanitizers, one after the other,
// each a share of the time; ends with executions and coverage, or at the first input that breaks a
// rule, which is kept in build/fuzz. The corpus is kept there as well.
import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { cmake } from './build.mjs';
import { files, root, run, setup } from './run.mjs';
import { printTable } from '../tests/bench/shared.mjs';

// With the most bytes an input has: construction takes long where many triangles cross.
const targets = { parsers: 4096, build: 600, grid: 16384 };
const minutes = Number(process.argv[2] ?? 20);
if (!(minutes > 0)) {
  console.error(`fuzz: '${process.argv[2]}' is no number of minutes`);
  process.exit(2);
}

// The target's first byte says which format follows.
const formats = ['obj', 'stl', 'ply', 'off'];
function seedParsers(corpus) {
  for (const file of files('tests/data/*')) {
    const format = formats.indexOf(file.split('.').pop());
    if (format < 0) continue;
    const bytes = readFileSync(`${root}/${file}`);
    writeFileSync(
      `${corpus}/${file.split('/').pop()}`,
      Buffer.concat([Buffer.from([format]), bytes]),
    );
  }
}

setup('native', 'test');
const folder = 'build/fuzz';
cmake(
  folder,
  [
    'CMAKE_BUILD_TYPE=Debug',
    'CMAKE_CXX_COMPILER=clang++',
    'CMAKE_CXX_FLAGS=-O1',
    'KDM_SANITIZE=ON',
    'KDM_UNITY=ON',
    'KDM_BUILD_FUZZ=ON',
  ],
  { targets: [...Object.keys(targets), 'seeds'].map((target) => `kdm_fuzz_${target}`) },
);

const rows = [];
let failed = false;
const program = (name) => `${root}/${folder}/tests/fuzz/kdm_fuzz_${name}`;
for (const [target, longest] of Object.entries(targets)) {
  const corpus = `${root}/${folder}/corpus/${target}`;
  mkdirSync(corpus, { recursive: true });
  if (target === 'parsers') seedParsers(corpus);
  if (target === 'grid') run(program('seeds'), [corpus]);
  const seconds = Math.ceil((60 * minutes) / Object.keys(targets).length);
  const { status, stderr } = spawnSync(
    program(target),
    [
      corpus,
      `-max_total_time=${seconds}`,
      `-max_len=${longest}`,
      '-timeout=60',
      '-rss_limit_mb=4096',
      '-print_final_stats=1',
      `-artifact_prefix=${root}/${folder}/${target}-`,
    ],
    { encoding: 'utf8', maxBuffer: 1 << 28 },
  );
  const number = (pattern) => Number([...stderr.matchAll(pattern)].pop()?.[1] ?? 0);
  rows.push({
    target,
    seconds,
    executions: number(/number_of_executed_units:\s+(\d+)/g),
    edges: number(/cov: (\d+)/g),
    features: number(/ft: (\d+)/g),
    inputs: number(/corp: (\d+)/g),
    slowest: `${number(/slowest_unit_time_sec:\s+(\d+)/g)} s`,
    'peak memory': `${number(/peak_rss_mb:\s+(\d+)/g)} MB`,
    verdict: status === 0 ? 'ok' : 'FAILS',
  });
  if (status !== 0) {
    failed = true;
    console.error(stderr.split('\n').slice(-60).join('\n'));
  }
}
printTable(rows);
process.exit(failed ? 1 : 0);
