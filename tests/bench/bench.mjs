// SPDX-License-Identifier: MIT
// `npm run bench -- [--models DIR] [--settings median:19]... [--repeat 5] [--no-peers] [--json FILE]`
// Seconds by stage, natively and in WebAssembly, and the peers on the same models; every result
// is judged by the same native program. Distances are per mille of the diagonal, both ways.
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { extname, join } from 'node:path';
import { builders } from '../../scripts/build.mjs';
import { output, run } from '../../scripts/run.mjs';
import {
  buildTools,
  commandLine,
  measure,
  median,
  modelFiles,
  nameOf,
  parseSetting,
  printTable,
} from './shared.mjs';

const options = commandLine({
  settings: { type: 'string', multiple: true },
  repeat: { type: 'string', default: '5' },
  'no-peers': { type: 'boolean', default: false },
});
const repeat = Number(options.repeat);
const settings = options.settings ?? ['adaptive:60', 'median:19', 'octree:21', 'uniform:21'];

const tools = buildTools();
builders.wasm();
builders.package();
const { runWasm, meshoptimizer, manifold3d } = await import('./engines.mjs');
const { load } = await import('../../dist/index.js');
const kdm = await load();

const folder = mkdtempSync(join(tmpdir(), 'kdm-bench-'));
try {
  if (options.models.length === 0) run(join(tools, 'kdm_bench'), ['--export', folder]);
  const rows = [];
  for (const file of modelFiles(options.models, [folder])) {
    rows.push(...(await benchModel(file)));
  }
  printTable(rows);
  if (options.json !== undefined) writeFileSync(options.json, JSON.stringify(rows, null, 1) + '\n');
} finally {
  rmSync(folder, { recursive: true });
}

async function benchModel(file) {
  const bytes = readFileSync(file);
  const format = extname(file).slice(1).toLowerCase();
  const rows = [];
  let input;
  try {
    input = kdm.parseMesh(bytes, format, nameOf(file));
    kdm.buildGrid(input, { strategy: 'uniform', depth: 1 }).delete();
  } catch (error) {
    return [row(nameOf(file), error.code ?? 'error', {}, {})];
  }
  const judge = (mesh) => {
    const path = join(folder, 'result.ply');
    writeFileSync(path, kdm.formatMesh(mesh, 'ply'));
    return measure(tools, path, file);
  };
  for (const setting of settings.map(parseSetting)) {
    const label = `${setting.strategy} ${setting.depth}`;
    const runs = [];
    for (let i = 0; i < repeat; ++i) runs.push(await runWasm(bytes, format, setting));
    const seconds = medians(runs.map((one) => one.seconds));
    const judgement = judge(runs[0].mesh);
    rows.push(row(nameOf(file), `native ${label}`, native(file, setting), judgement));
    rows.push(row(nameOf(file), `wasm ${label}`, seconds, judgement));
  }
  if (options['no-peers']) return rows;
  for (const resolution of [64, 128, 256]) {
    const runs = [];
    for (let i = 0; i < repeat; ++i) runs.push(await meshoptimizer(input, resolution));
    const total = median(runs.map((one) => one.seconds));
    rows.push(row(nameOf(file), `meshoptimizer ${resolution}`, { total }, judge(runs[0].mesh)));
  }
  const peer = await manifold3d(input);
  rows.push(
    peer.refused === undefined
      ? row(nameOf(file), 'manifold-3d', { total: peer.seconds }, judge(peer.mesh))
      : row(nameOf(file), `manifold-3d: ${peer.refused}`, {}, {}),
  );
  return rows;
}

/** Stage medians of the native program, in its own process. */
function native(file, { strategy, depth }) {
  const report = join(folder, 'native.json');
  output(join(tools, 'kdm_bench'), [
    ...['--models', file, '--settings', `${strategy}:${depth}`],
    ...['--repeat', String(repeat), '--json', report],
  ]);
  return JSON.parse(readFileSync(report, 'utf8'))[0].seconds;
}

function medians(runs) {
  const stages = new Set(runs.flatMap(Object.keys));
  return Object.fromEntries(
    [...stages].map((stage) => [stage, median(runs.map((seconds) => seconds[stage] ?? 0))]),
  );
}

// build: prepare and build; topology: links, loops and faces.
function row(model, engine, seconds, judgement) {
  const { read = 0, prepare = 0, build = 0, vertices = 0, total } = seconds;
  const staged = 'build' in seconds;
  const show = (value, digits = 3) => (value === undefined ? '' : value.toFixed(digits));
  const mille = (distance) => show(distance && distance.max * 1000, 2);
  return {
    model,
    engine,
    build: staged ? show(prepare + build) : '',
    topology: staged ? show(total - read - prepare - build - vertices) : '',
    vertices: staged ? show(vertices) : '',
    total: show(total),
    triangles: judgement.triangles ?? '',
    manifold: judgement.twoManifold === undefined ? '' : judgement.twoManifold ? 'yes' : 'NO',
    parts: judgement.components ?? '',
    euler: judgement.eulerCharacteristic ?? '',
    out: mille(judgement.toReference),
    missed: mille(judgement.fromReference),
  };
}
