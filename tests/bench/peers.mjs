// SPDX-License-Identifier: MIT
// `npm run bench -- --peers [--repeat 5] [--readme]`: the first table of README.md; `--readme` writes it there. One
// shape, damaged in the ways of the trade, goes through this library, meshoptimizer's remesher and manifold-3d; the
// results are judged by the tests' own checker, their volumes against the volume of the shape before it was damaged.
import { parseArgs } from 'node:util';
import { builders } from '../../scripts/build.mjs';
import { damageCell, damageCommand, damageEngines, damages } from './peer_rows.mjs';
import { markdownTable, writeTable } from './readme_table.mjs';
import { median, randomNumbers } from './shared.mjs';

const { values } = parseArgs({
  options: {
    repeat: { type: 'string', default: '5' },
    readme: { type: 'boolean', default: false },
  },
});
const repeat = Number(values.repeat);
builders.package();
const { load } = await import('../../dist/index.js');
const { manifold3d, meshoptimizer } = await import('./engines.mjs');
const { cube, faults, together, torus, volume } = await import('../js/support/meshes.js');
const kdm = await load({ threads: 1 });

const whole = torus(128, 64);
const random = randomNumbers(7);
const cornersOf = ({ indices }) =>
  Array.from({ length: indices.length / 3 }, (_, i) => indices.subarray(3 * i, 3 * i + 3));

/** Leaves out the faces that `keep` refuses. */
const without = (mesh, keep) => ({
  positions: mesh.positions,
  indices: Uint32Array.from(cornersOf(mesh).flatMap((face, i) => (keep(face, i) ? [...face] : []))),
});

/** Five holes, each as wide as half of the tube. */
function holed() {
  const centres = [0, 1, 2, 3, 4].map((i) => [
    3 * Math.cos(i * 1.256) + Math.cos(i * 1.256) * Math.cos(i),
    3 * Math.sin(i * 1.256) + Math.sin(i * 1.256) * Math.cos(i),
    Math.sin(i),
  ]);
  const near = (vertex) =>
    centres.some((c) => Math.hypot(...c.map((x, k) => x - whole.positions[3 * vertex + k])) < 0.5);
  return without(whole, (face) => ![...face].some(near));
}

const turned = () => ({
  positions: whole.positions,
  indices: Uint32Array.from(
    cornersOf(whole).flatMap(([a, b, c]) => (random() < 0.3 ? [a, c, b] : [a, b, c])),
  ),
});

/** No two faces share a vertex, and none lies quite where its neighbour does. */
function torn() {
  const corners = cornersOf(whole).flatMap((face) => [...face]);
  const positions = new Float32Array(corners.length * 3);
  corners.forEach((vertex, i) => {
    for (let k = 0; k < 3; ++k) {
      positions[3 * i + k] = whole.positions[3 * vertex + k] + 1e-4 * (random() - 0.5);
    }
  });
  return { positions, indices: Uint32Array.from(corners.keys()) };
}

const doubled = () => ({
  positions: whole.positions,
  indices: Uint32Array.from([
    ...whole.indices,
    ...cornersOf(whole).flatMap(([a, b, c], i) => (i % 9 === 0 ? [a, b, c] : [])),
  ]),
});

const boxes = together(...[0, 1, 2, 3, 4].map((i) => cube(2, [i, 0.3 * i, 0.2 * i])));
// The union of the five boxes: each next one adds itself but for what it shares with the one before.
const unionOfBoxes = 8 + 4 * (8 - 1 * 1.7 * 1.8);

const inputs = [
  { mesh: whole, wanted: volume(whole) },
  { mesh: boxes, wanted: unionOfBoxes },
  { mesh: holed(), wanted: volume(whole) },
  { mesh: turned(), wanted: volume(whole) },
  { mesh: torn(), wanted: volume(whole) },
  { mesh: doubled(), wanted: volume(whole) },
];

async function own(mesh) {
  const { user, system } = process.cpuUsage();
  const grid = kdm.buildGrid(mesh, { relativeTolerance: 0.002 });
  const result = grid.extract();
  grid.delete();
  const spent = process.cpuUsage({ user, system });
  return { mesh: result, seconds: (spent.user + spent.system) / 1e6 };
}

const engines = [
  own,
  (mesh) => meshoptimizer(mesh, 128),
  (mesh) => manifold3d(mesh, { union: true }),
];

async function cell(engine, { mesh, wanted }) {
  const runs = [];
  for (let i = 0; i <= repeat; ++i) runs.push(await engine(mesh));
  const [{ mesh: result, refused }] = runs;
  if (refused !== undefined) return damageCell({ refused });
  return damageCell({
    twoManifold: faults(result).length === 0,
    off: (volume(result) / wanted - 1) * 100,
    triangles: result.indices.length / 3,
    milliseconds: Math.round(1000 * median(runs.slice(1).map(({ seconds }) => seconds))),
  });
}

const rows = [];
for (const [i, input] of damages.entries()) {
  const row = { input };
  for (const [k, engine] of engines.entries()) {
    row[damageEngines[k]] = await cell(engine, inputs[i]);
  }
  rows.push(row);
}
const table = markdownTable(rows);
console.log(table);
if (values.readme) writeTable(damageCommand, table);
