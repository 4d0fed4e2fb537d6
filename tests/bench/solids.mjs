// SPDX-License-Identifier: MIT
// `npm run bench -- --solids [MODEL] [--turn 10] [--repeat 3]`: what the paper shows in its figure 16. Two copies of a
// model (OBJ, STL, PLY or OFF; without one a torus), one turned about the vertical axis through its middle, are
// united, and a cylinder is cut out. Processor time and validity, at three tolerances, beside manifold-3d.
import { readFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { builders } from '../../scripts/build.mjs';
import { median } from './shared.mjs';

const { values, positionals } = parseArgs({
  options: {
    turn: { type: 'string', default: '10' },
    repeat: { type: 'string', default: '3' },
  },
  allowPositionals: true,
});
builders.package();
const { formatFromPath, load } = await import('../../dist/index.js');
const { manifold3dBoolean, ownBoolean } = await import('./engines.mjs');
const { turnedTwice } = await import('./turned_twice.mjs');
const { faults, torus, volume } = await import('../js/support/meshes.js');
const kdm = await load({ threads: 1 });

const [path] = positionals;
const model = path
  ? kdm.parseMesh(readFileSync(path), formatFromPath(path), path)
  : torus(512, 256);
const operands = turnedTwice(model, kdm.describe(model).bounds, Number(values.turn));
const expression = ['difference', ['union', 0, 1], 2];

async function row(name, work) {
  const runs = [];
  for (let i = 0; i < Number(values.repeat); ++i) runs.push(await work());
  const [{ mesh, refused }] = runs;
  if (refused !== undefined) return { name, result: `refused: ${refused}` };
  const found = faults(mesh);
  return {
    name,
    seconds: median(runs.map(({ seconds }) => seconds)).toFixed(2),
    triangles: mesh.indices.length / 3,
    volume: volume(mesh).toPrecision(6),
    'crossing pairs': kdm.findSelfIntersections(mesh).pairs,
    result: found.length === 0 ? '2-manifold' : found.join(', '),
  };
}

const own = (relativeTolerance) => () => ownBoolean(operands, expression, { relativeTolerance });
const peer = () =>
  manifold3dBoolean(operands, ([a, b, c], keep) => keep(keep(a.add(b)).subtract(c)));

const triangles = operands.reduce((sum, { indices }) => sum + indices.length / 3, 0);
console.log(`${path ?? 'a torus'}, twice, and a cylinder: ${triangles} triangles`);
const rows = [];
for (const share of [0.002, 0.001, 0.0005]) {
  rows.push(await row(`kdmanifold, ${share}`, own(share)));
}
rows.push(await row('manifold-3d', peer));
console.log(rows);
