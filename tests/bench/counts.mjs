// SPDX-License-Identifier: MIT
// `npm run bench -- --counts [MODEL...] [--fine 0.0005] [--shares 0.5,0.1,0.02] [--repeat 3]`: fewer triangles by count. The
// fine mesh of each model goes through this library's `simplifyMesh`, meshoptimizer's `simplify` and manifold-3d's
// `simplify` down to the same numbers of triangles. Distances, judged by kdm_measure, are between the reduced and the
// fine mesh, both ways, in per cent of the diagonal; seconds are processor time in WebAssembly.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { builders } from '../../scripts/build.mjs';
import {
  buildTools,
  closedModels,
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

const options = commandLine({
  fine: { type: 'string', default: '0.0005' },
  shares: { type: 'string', default: '0.5,0.1,0.02' },
  repeat: { type: 'string', default: '3' },
});
const repeat = Number(options.repeat);
const tools = buildTools(['kdm_measure']);
builders.package();
const { load } = await import('../../dist/index.js');
const { reducers } = await import('./engines.mjs');
const kdm = await load({ threads: 1 });

const text = (number) => (number === undefined ? '' : Number(number.toPrecision(3)));

async function rowsOf(file, folder) {
  const grid = kdm.buildGrid(kdm.parseMesh(...contentOf(file)), {
    relativeTolerance: Number(options.fine),
  });
  const fine = grid.extract({ strict: 'embedded' });
  grid.delete();
  const write = (name, mesh) => {
    const path = join(folder, name);
    writeFileSync(path, kdm.formatMesh(mesh, 'ply', true));
    return path;
  };
  const reference = write('fine.ply', fine);
  const all = fine.indices.length / 3;
  const rows = [];
  for (const share of options.shares.split(',').map(Number)) {
    const target = Math.round(share * all);
    for (const [name, reduce] of Object.entries(reducers)) {
      const runs = [];
      for (let i = 0; i < repeat; ++i) runs.push(await reduce(fine, target));
      if (runs[0] === undefined) {
        rows.push({ model: nameOf(file), from: all, to: 'not reached', by: name });
        continue;
      }
      const { mesh } = runs[0];
      const judged = measure(tools, write('few.ply', mesh), reference);
      const { max, rms } = twoSided(judged);
      rows.push({
        model: nameOf(file),
        from: all,
        to: mesh.indices.length / 3,
        by: name,
        'largest %': text(100 * max),
        'rms %': text(100 * rms),
        seconds: text(median(runs.map(({ seconds }) => seconds))),
        '2-manifold': judged.twoManifold ? 'yes' : 'no',
        crossings: kdm.findSelfIntersections(mesh).pairs,
      });
    }
  }
  return rows;
}

const files = modelFiles(options.models, []);
if (files.length === 0) {
  console.error(`bench: --counts needs models, such as ${closedModels.join(', ')}`);
  process.exit(2);
}
const rows = [];
for (const file of files) rows.push(...(await withFolder((folder) => rowsOf(file, folder))));
printTable(rows);
if (options.json) writeFileSync(options.json, JSON.stringify(rows, null, 2));
