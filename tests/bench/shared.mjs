// SPDX-License-Identifier: MIT
// What the benchmark scripts share: building the native tools, options, medians, tables.
import { readdirSync, statSync } from 'node:fs';
import { basename, extname, join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { cmake } from '../../scripts/build.mjs';
import { output, root } from '../../scripts/run.mjs';

export const extensions = ['.obj', '.stl', '.ply', '.off'];

/** Builds kdm_bench, kdm_measure and kdm_figures and returns their folder. */
export function buildTools() {
  cmake('build/bench', ['CMAKE_BUILD_TYPE=Release', 'KDM_BUILD_BENCH=ON', 'KDM_BUILD_CLI=OFF'], {
    targets: ['kdm_bench', 'kdm_measure', 'kdm_figures'],
  });
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
  return { ...values, models: [...(values.models ?? []), ...positionals] };
}

export function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)];
}

/** "median:19" -> { strategy: 'median', depth: 19 } */
export function parseSetting(text) {
  const [strategy, depth] = text.split(':');
  return { strategy, depth: Number(depth) };
}

/** Judges a mesh file with kdm_measure: manifoldness, and distances to the reference. */
export function measure(tools, file, reference) {
  const args = reference === undefined ? [file] : [file, '--reference', reference];
  return JSON.parse(output(join(tools, 'kdm_measure'), args));
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
