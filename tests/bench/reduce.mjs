// SPDX-License-Identifier: MIT
// `npm run bench -- --reduce [MODEL...] [--triangles 200000] [--target 20000] [--repeat 3]`: what it takes to reduce a
// mesh, in seconds of processor time in WebAssembly. A mesh of so many triangles is made of each model; `simplifyMesh`
// reduces it to the target by count, then within the error that this had. meshoptimizer's `simplify`, which tests neither
// distances nor crossings, reduces it by count for comparison.
import { writeFileSync } from 'node:fs';
import { builders } from '../../scripts/build.mjs';
import {
  closedModels,
  commandLine,
  contentOf,
  median,
  modelFiles,
  nameOf,
  printTable,
} from './shared.mjs';

const options = commandLine({
  triangles: { type: 'string', default: '200000' },
  target: { type: 'string', default: '20000' },
  repeat: { type: 'string', default: '3' },
});
const triangles = Number(options.triangles);
const target = Number(options.target);
const repeat = Number(options.repeat);
builders.package();
const { load } = await import('../../dist/index.js');
const { reducers, withinError } = await import('./engines.mjs');
const kdm = await load({ threads: 1 });

/** A mesh of as many triangles as asked for that crosses itself nowhere: a finer one, reduced. */
function fineMesh(file) {
  const input = kdm.parseMesh(...contentOf(file));
  for (let relativeTolerance = 0.001; relativeTolerance > 1e-6; relativeTolerance /= 1.5) {
    const grid = kdm.buildGrid(input, { relativeTolerance });
    const mesh = grid.extract({ strict: 'embedded' });
    grid.delete();
    if (mesh.indices.length / 3 < triangles) continue;
    return kdm.simplifyMesh(mesh, { targetTriangles: [triangles] }).mesh;
  }
  throw new Error(`${file} has no mesh of ${triangles} triangles`);
}

async function rowsOf(file) {
  const fine = fineMesh(file);
  const row = async (by, reduce) => {
    const runs = [];
    for (let i = 0; i < repeat; ++i) runs.push(await reduce());
    const { mesh } = runs[0];
    return {
      model: nameOf(file),
      from: fine.indices.length / 3,
      to: mesh.indices.length / 3,
      by,
      seconds: Number(median(runs.map(({ seconds }) => seconds)).toFixed(3)),
    };
  };
  const { error } = kdm.simplifyMesh(fine, { targetTriangles: [target] }).levels[0];
  const within = Math.max(error.toInput.largest, error.toOutput.largest);
  return [
    await row('kdmanifold, by count', () => reducers.kdmanifold(fine, target)),
    await row(`kdmanifold, within ${within.toPrecision(3)}`, () => withinError(fine, within)),
    await row('meshoptimizer, by count', () => reducers.meshoptimizer(fine, target)),
  ];
}

const files = modelFiles(options.models, []);
if (files.length === 0) {
  console.error(`bench: --reduce needs models, such as ${closedModels.join(', ')}`);
  process.exit(2);
}
const rows = [];
for (const file of files) rows.push(...(await rowsOf(file)));
printTable(rows);
if (options.json) writeFileSync(options.json, JSON.stringify(rows, null, 2));
