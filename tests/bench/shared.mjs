// SPDX-License-Identifier: MIT
// What the benchmark scripts share: building the native tools, options, medians, tables.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, extname, join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { cmake } from '../../scripts/build.mjs';
import { output, root, setup } from '../../scripts/run.mjs';

export const extensions = ['.obj', '.stl', '.ply', '.off'];

/** Closed models that do not cross themselves: two with creases, two organic ones. */
export const closedModels = ['fandisk.obj', 'casting.off', 'horse_quad.obj', 'armadillo_86k.ply'];

/** The sizes at which they are looked at. */
export const sizes = [
  ...[0.01, 0.002, 0.0005].map((relativeTolerance) => ({
    name: `adaptive ${relativeTolerance}`,
    options: { strategy: 'adaptive', relativeTolerance },
  })),
  ...[15, 18, 21].map((depth) => ({
    name: `octree ${2 ** (depth / 3)}`,
    options: { strategy: 'octree', depth, relativeTolerance: 0 },
  })),
];

/** Builds native tools, unless others are named kdm_bench, kdm_measure and kdm_figures; returns their folder. */
export function buildTools(targets = ['kdm_bench', 'kdm_measure', 'kdm_figures']) {
  setup('native', 'test');
  cmake(
    'build/bench',
    [
      ...['CMAKE_BUILD_TYPE=Release', 'KDM_UNITY=ON'],
      ...['KDM_BUILD_BENCH=ON', 'KDM_BUILD_CLI=OFF'],
    ],
    {
      targets,
    },
  );
  return join(root, 'build/bench/tests/bench');
}

/** Files and folders of the command line (relative to where npm was called), or `fallback`. */
export function modelFiles(paths, fallback) {
  const base = process.env.INIT_CWD ?? process.cwd();
  const chosen = paths.length > 0 ? paths : fallback;
  return chosen.flatMap((path) => {
    const full = resolve(base, path);
    if (!statSync(full).isDirectory()) return [full];
    return readdirSync(full)
      .filter((name) => extensions.includes(extname(name).toLowerCase()))
      .sort()
      .map((name) => join(full, name));
  });
}

/** Command-line options; both `--models DIR` and plain arguments name models. */
export function commandLine(options) {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: { models: { type: 'string', multiple: true }, json: { type: 'string' }, ...options },
  });
  return { ...values, positionals, models: [...(values.models ?? []), ...positionals] };
}

/** The file's text or bytes and its format, as `parseMesh` takes them. */
export const contentOf = (file) => [readFileSync(file), extname(file).slice(1).toLowerCase()];

/** Numbers from 0 to 1, the same in every run (Park and Miller 1988). */
export function randomNumbers(seed) {
  let state = seed;
  return () => {
    state = (state * 48271) % 2147483647;
    return state / 2147483647;
  };
}

export function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)];
}

/** "median:19" or "octree:21:0" -> { strategy, depth, relativeTolerance } as the library has them */
export function parseSetting(text) {
  const [strategy, depth, relativeTolerance] = text.split(':');
  const setting = { strategy, depth: Number(depth) };
  return relativeTolerance === undefined
    ? setting
    : { ...setting, relativeTolerance: Number(relativeTolerance) };
}

/** The other way round; without a tolerance the default counts. */
export function settingText({ strategy, depth = 60, relativeTolerance }) {
  return [strategy, depth, relativeTolerance].filter((part) => part !== undefined).join(':');
}

/** Runs `work` with a folder that is gone afterwards. */
export async function withFolder(work) {
  const folder = mkdtempSync(join(tmpdir(), 'kdm-'));
  try {
    return await work(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/**
 * One row of kdm_bench, run in a process of its own: counts, medians of seconds by stage, peak
 * memory. The model is a file or a scene; `keep` names the file for the result.
 */
export function native(tools, folder, model, setting, { repeat = 1, subdivide = 0, keep } = {}) {
  const report = join(folder, 'native.json');
  output(join(tools, 'kdm_bench'), [
    ...['--models', model, '--settings', settingText(setting), '--json', report],
    ...['--repeat', String(repeat), '--subdivide', String(subdivide)],
    ...(keep === undefined ? [] : ['--keep', keep]),
  ]);
  const [row] = JSON.parse(readFileSync(report, 'utf8'));
  if (row.error !== undefined) throw new Error(`${model}: ${row.error}`);
  return row;
}

/**
 * Runs the native command line, which must be built: its report, or what it said instead, and the processor time of all
 * its threads, reading and writing included.
 */
export function convert(input, result, args) {
  const program = join(root, 'build/native/src/cli/kdmanifold');
  const command = [program, input, '-o', result, '--force', '--json', ...args];
  // `times` prints what this shell's children took, in its second line.
  const { stdout, stderr, status } = spawnSync(
    'sh',
    ['-c', '"$@"; status=$?; times >&2; exit $status', 'sh', ...command],
    { encoding: 'utf8', maxBuffer: 1 << 28 },
  );
  const said = stderr.trimEnd().split('\n');
  const seconds = [...said.pop().matchAll(/(\d+)m([\d.]+)s/g)].reduce(
    (sum, [, minutes, rest]) => sum + 60 * Number(minutes) + Number(rest),
    0,
  );
  said.pop();
  if (status !== 0) return { refused: said.join(' '), seconds };
  return { report: JSON.parse(stdout), seconds };
}

/** Seconds from mesh to mesh, reading left out. */
export const meshToMesh = ({ total, read = 0 }) => total - read;

/** Judges a mesh file with kdm_measure: manifoldness, and distances to the reference. */
export function measure(tools, file, reference, args = []) {
  const compared = reference === undefined ? [] : ['--reference', reference];
  return JSON.parse(output(join(tools, 'kdm_measure'), [file, ...compared, ...args]));
}

/** Both ways: the largest distance, and the larger of the two root mean squares. */
export function twoSided({ toReference, fromReference }) {
  return {
    max: Math.max(toReference.max, fromReference.max),
    rms: Math.max(toReference.rms, fromReference.rms),
  };
}

/** Prints rows of equal keys as an aligned table. */
export function printTable(rows) {
  if (rows.length === 0) return;
  const keys = Object.keys(rows[0]);
  const text = [keys, ...rows.map((row) => keys.map((key) => String(row[key] ?? '')))];
  const width = keys.map((_, i) => Math.max(...text.map((line) => line[i].length)));
  for (const line of text) {
    const cells = line.map((cell, i) =>
      i === 0 ? cell.padEnd(width[i]) : cell.padStart(width[i]),
    );
    console.log(cells.join('  '));
  }
}

export const nameOf = (file) => basename(file);
