// SPDX-License-Identifier: MIT
// `npm run bench -- [--models DIR] [--settings median:19]... [--repeat 5] [--no-peers] [--json FILE]`
// Seconds (of processor time) by stage, natively and in WebAssembly, and the peers on the same models in the same run;
// every result is judged by the same native program. Beside each result of meshoptimizer stand the
// runs of `adaptive` that are at least as close to the input, by the largest distance and by the
// root mean square. `npm run bench -- --compare COMMIT` times against another commit: compare.mjs.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { builders } from '../../scripts/build.mjs';
import { run } from '../../scripts/run.mjs';
import { ToleranceLadder } from './equal_error.mjs';
import {
  buildTools,
  commandLine,
  contentOf,
  measure,
  median,
  meshToMesh,
  modelFiles,
  nameOf,
  native,
  parseSetting,
  printTable,
  settingText,
  twoSided,
  withFolder,
} from './shared.mjs';

const options = commandLine({
  settings: { type: 'string', multiple: true },
  repeat: { type: 'string', default: '5' },
  'no-peers': { type: 'boolean', default: false },
});
const repeat = Number(options.repeat);
// An octree at a tolerance of 0 has 128 (256) cells an axis wherever the surface is not flat.
const byDefault = 'adaptive:60:0.002 adaptive:60:0.0005 median:19 octree:21:0 octree:24:0'.split(
  ' ',
);
const settings = (options.settings ?? byDefault).map(parseSetting);
const resolutions = [64, 128, 256];

const tools = buildTools();
builders.package();
const { runWasm, meshoptimizer, manifold3d } = await import('./engines.mjs');
const { load } = await import('../../dist/index.js');
const kdm = await load({ threads: 1 });

await withFolder(async (folder) => {
  if (options.models.length === 0) run(join(tools, 'kdm_bench'), ['--export', folder]);
  const rows = [];
  for (const file of modelFiles(options.models, [folder])) {
    const own = await benchModel(file, folder);
    printTable(own.map(shown));
    console.log('');
    rows.push(...own);
  }
  if (options.json !== undefined) writeFileSync(options.json, JSON.stringify(rows, null, 1) + '\n');
});

async function benchModel(file, folder) {
  const [bytes, format] = contentOf(file);
  const model = nameOf(file);
  let input;
  try {
    input = kdm.parseMesh(bytes, format, model);
    kdm.buildGrid(input, { strategy: 'uniform', depth: 1 }).delete();
  } catch (error) {
    return [{ model, engine: error.code ?? 'error' }];
  }
  const judge = (mesh, args) => {
    const path = join(folder, 'judged.ply');
    writeFileSync(path, kdm.formatMesh(mesh, 'ply'));
    const judgement = measure(tools, path, file, args);
    return { ...judgement, ...twoSided(judgement) };
  };
  // Once without counting: engines compile their code while it runs.
  const timed = async (work) => {
    const runs = [];
    await work();
    for (let i = 0; i < repeat; ++i) runs.push(await work());
    return runs;
  };

  // Ours: two rows, of the same result.
  const own = async (setting) => {
    const runs = await timed(() => runWasm(bytes, format, setting));
    const seconds = medians(runs.map((one) => one.seconds));
    const [{ mesh, stats }] = runs;
    const { seconds: nativeSeconds } = native(tools, folder, file, setting, { repeat });
    const common = { model, judgement: judge(mesh), stats };
    const label = settingText(setting);
    return [
      { ...common, engine: `native ${label}`, seconds: nativeSeconds },
      { ...common, engine: `wasm ${label}`, seconds },
    ];
  };
  const rows = [];
  for (const setting of settings) rows.push(...(await own(setting)));
  if (options['no-peers']) return rows;

  const ladder = new ToleranceLadder((relativeTolerance) => {
    const grid = kdm.buildGrid(input, { relativeTolerance });
    try {
      return judge(grid.extract(), ['--no-check']);
    } finally {
      grid.delete();
    }
  });
  const matched = new Map();
  for (const resolution of resolutions) {
    for (const flags of [[], ['Solve']]) {
      const runs = await timed(() => meshoptimizer(input, resolution, flags));
      const judgement = judge(runs[0].mesh);
      const seconds = { total: median(runs.map((one) => one.seconds)) };
      const engine = ['meshoptimizer', resolution, ...flags].join(' ');
      rows.push({ model, engine, seconds, judgement });
      const wanted = { max: undefined, rms: undefined };
      for (const kind of Object.keys(wanted)) wanted[kind] = ladder.find(kind, judgement[kind]);
      for (const relativeTolerance of new Set(Object.values(wanted))) {
        const asClose = Object.keys(wanted).filter((kind) => wanted[kind] === relativeTolerance);
        const beside = { asClose: asClose.join(', '), peerSeconds: seconds.total };
        if (relativeTolerance === undefined) {
          rows.push({ model, engine: 'adaptive: never as close', ...beside });
          continue;
        }
        if (!matched.has(relativeTolerance)) {
          matched.set(relativeTolerance, await own({ strategy: 'adaptive', relativeTolerance }));
        }
        rows.push(...matched.get(relativeTolerance).map((one) => ({ ...one, ...beside })));
      }
    }
  }
  const peer = await manifold3d(input);
  rows.push(
    peer.refused === undefined
      ? {
          model,
          engine: 'manifold-3d',
          seconds: { total: peer.seconds },
          judgement: judge(peer.mesh),
        }
      : { model, engine: `manifold-3d: ${peer.refused}` },
  );
  return rows;
}

function medians(runs) {
  const stages = new Set(runs.flatMap(Object.keys));
  return Object.fromEntries(
    [...stages].map((stage) => [stage, median(runs.map((seconds) => seconds[stage] ?? 0))]),
  );
}

// build: prepare and build; topology: links, loops and faces. "mesh to mesh" leaves reading out,
// which peers do not do. max, rms: two-sided distances, per mille of the diagonal. "of peer": our
// time as a share of the peer's above, for a result as close by the measure named.
function shown({ model, engine, seconds, judgement, asClose, peerSeconds }) {
  const { read, prepare = 0, build = 0, vertices, total, ...topology } = seconds ?? {};
  const staged = seconds !== undefined && 'build' in seconds;
  const show = (value, digits = 3) => (value === undefined ? '' : value.toFixed(digits));
  const mille = (distance) => show(distance && distance * 1000, 3);
  return {
    model,
    engine,
    'as close by': asClose ?? '',
    read: staged ? show(read) : '',
    build: staged ? show(prepare + build) : '',
    topology: staged ? show(Object.values(topology).reduce((sum, value) => sum + value, 0)) : '',
    vertices: staged ? show(vertices) : '',
    'mesh to mesh': total === undefined ? '' : show(meshToMesh(seconds)),
    'of peer':
      total === undefined || peerSeconds === undefined
        ? ''
        : show(meshToMesh(seconds) / peerSeconds, 2),
    triangles: judgement?.triangles ?? '',
    manifold: judgement === undefined ? '' : judgement.twoManifold ? 'yes' : 'NO',
    parts: judgement?.components ?? '',
    euler: judgement?.eulerCharacteristic ?? '',
    max: mille(judgement?.max),
    rms: mille(judgement?.rms),
  };
}
