// SPDX-License-Identifier: MIT
// `npm run bench -- --equal MODEL... [--repeat 3] [--readme]`: few triangles, and how far they are from the model, by
// this library within 0.1 % of the diagonal, and by meshoptimizer's `remesh` with its `simplify` behind it: down to as
// many triangles, and only as far as to the same root mean square and to the same largest distance; and manifold-3d's
// `simplify`. `--readme` writes the table into README.md. Distances, judged by kdm_measure, go both ways; seconds are
// processor time in WebAssembly.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { builders } from '../../scripts/build.mjs';
import { equalCommand, equalRow, equalWays } from './peer_rows.mjs';
import { markdownTable, writeTable } from './readme_table.mjs';
import {
  buildTools,
  commandLine,
  contentOf,
  measure,
  median,
  modelFiles,
  nameOf,
  printTable,
  twoSided,
  withFolder,
} from './shared.mjs';

const resolution = 256;
const relativeTolerance = 0.001;

const options = commandLine({
  repeat: { type: 'string', default: '3' },
  readme: { type: 'boolean', default: false },
});
const files = modelFiles(options.models, []);
if (files.length === 0) {
  console.error('bench: --equal needs models');
  process.exit(2);
}
const tools = buildTools(['kdm_measure']);
builders.package();
const { close, load, makeManifold } = await import('../../dist/index.js');
const { meshoptimizer, reducers } = await import('./engines.mjs');
const kdm = await load({ threads: 1 });

/** The median of the seconds of several runs, after one that is not counted; and what the last one made. */
async function timed(work) {
  const runs = [];
  for (let i = 0; i <= Number(options.repeat); ++i) runs.push(await work());
  const seconds = median(runs.slice(1).map((one) => one?.seconds));
  return runs[0] === undefined ? undefined : { ...runs.at(-1), seconds };
}

async function own(mesh) {
  const start = process.cpuUsage();
  const { mesh: result, report } = await makeManifold(mesh, { relativeTolerance, threads: 1 });
  const { user, system } = process.cpuUsage(start);
  return { mesh: result, seconds: (user + system) / 1e6, stages: sharesOf(report.seconds) };
}

/** The worker's clock says what share of the time each stage takes. */
function sharesOf({ build, extract, reduce }) {
  const whole = build + extract + reduce;
  return { build: build / whole, extract: extract / whole, reduce: reduce / whole };
}

async function rowsOf(file, folder) {
  const { positions, indices } = kdm.parseMesh(...contentOf(file));
  const input = { positions, indices };
  const judge = (mesh) => {
    const path = join(folder, 'judged.ply');
    writeFileSync(path, kdm.formatMesh(mesh, 'ply'));
    const judged = measure(tools, path, file);
    const { max: largest, rms } = twoSided(judged);
    return { largest, rms, triangles: judged.triangles, twoManifold: judged.twoManifold };
  };
  const row = (way, made) => {
    if (made?.mesh === undefined) {
      return equalRow({ model: nameOf(file), way, refused: made?.refused ?? 'not reached' });
    }
    const { mesh, seconds, stages } = made;
    const crossings = kdm.findSelfIntersections(mesh).pairs;
    const milliseconds = Math.round(1000 * seconds);
    const found = { ...judge(mesh), crossings, milliseconds, stages };
    return equalRow({ model: nameOf(file), way, ...found });
  };

  const few = await timed(() => own(input));
  const wanted = judge(few.mesh);
  const fine = await timed(() => meshoptimizer(input, resolution, ['Solve']));
  const simplified = async (triangles) => {
    const made = await reducers.meshoptimizer(fine.mesh, triangles);
    return { ...made, seconds: fine.seconds + made.seconds };
  };
  // The fewest triangles that are as close; none if the remeshed model is further away by itself.
  const asClose = async (kind) => {
    let [low, high] = [4, fine.mesh.indices.length / 3];
    if (judge(fine.mesh)[kind] > wanted[kind]) return { refused: 'never as close' };
    while (high / low > 1.01) {
      const middle = Math.round(Math.sqrt(low * high));
      if (judge((await simplified(middle)).mesh)[kind] <= wanted[kind]) high = middle;
      else low = middle;
    }
    return timed(() => simplified(high));
  };
  const made = [
    few,
    await timed(() => simplified(wanted.triangles)),
    await asClose('rms'),
    await asClose('largest'),
    await manifold3dSimplified(input, wanted.triangles),
  ];
  return made.map((one, i) => row(equalWays[i], one));
}

async function manifold3dSimplified(mesh, triangles) {
  try {
    const input = {
      positions: Float32Array.from(mesh.positions),
      indices: Uint32Array.from(mesh.indices),
    };
    return await timed(() => reducers['manifold-3d'](input, triangles));
  } catch (error) {
    return { refused: `refused (${error.code ?? error.message})` };
  }
}

const rows = [];
for (const file of files) rows.push(...(await withFolder((folder) => rowsOf(file, folder))));
await close();
printTable(rows);
if (options.readme) writeTable(equalCommand, markdownTable(rows));
if (options.json !== undefined) writeFileSync(options.json, JSON.stringify(rows, null, 2));
