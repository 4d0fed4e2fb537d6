// SPDX-License-Identifier: MIT
// What `adaptive` promises: the input's parts and Euler characteristic, and a result within 1.5
// times the tolerance, both ways, sharp edges within the tolerance. Measured by kdm_measure and,
// if there is one, by the judge. Distances are fractions of the input's bounding-box diagonal.
import { join } from 'node:path';
import { output } from '../../../scripts/run.mjs';
import { measure, meshToMesh, nameOf, native, printTable, twoSided } from '../../bench/shared.mjs';
import { verdictOf } from '../verdict.mjs';

const models = ['fandisk.obj', 'armadillo_86k.ply', 'casting.off', 'horse_quad.obj'];
const scenes = ['thin_box', 'nested_spheres', 'torus_chain'];
const tolerances = [0.01, 0.002, 0.0005];
const sharpDegrees = 30;
const sharpModels = ['fandisk.obj'];

export default async function quality({ tools, folder, judge, find }) {
  output(join(tools, 'kdm_bench'), [
    ...['--export', folder, '--models', ...scenes.map((name) => `scene:${name}`)],
  ]);
  const files = [...find(models), ...scenes.map((name) => join(folder, `${name}.ply`))];
  const rows = [];
  const edges = [];
  for (const file of files) {
    const input = measure(tools, file);
    const judgedInput = judge && judgeMesh(judge, [file]);
    for (const relativeTolerance of tolerances) {
      const setting = { strategy: 'adaptive', relativeTolerance };
      const result = join(folder, 'result.obj');
      const run = native(tools, folder, file, setting, { repeat: 5, keep: result });
      const sharp = sharpModels.includes(nameOf(file));
      const measured = measure(tools, result, file, [
        ...['--samples', '100000', ...(sharp ? ['--sharp-edges', String(sharpDegrees)] : [])],
      ]);
      const judged = judge && judgeMesh(judge, [result, '--ref', file, '--samples', '100000']);
      rows.push(row(file, relativeTolerance, run, { input, measured, judgedInput, judged }));
      if (sharp) edges.push(edgeRow(file, relativeTolerance, measured.sharpEdges));
    }
  }
  console.log('parts, Euler: input -> result; off: two-sided Hausdorff distance / diagonal');
  printTable(rows);
  console.log(`\nedges sharper than ${sharpDegrees} degrees: largest distance / diagonal`);
  printTable(edges);
  const failures = [...rows, ...edges].filter(({ verdict }) => verdict !== 'ok').length;
  return { rows: [...rows, ...edges], failures };
}

function judgeMesh(judge, args) {
  return JSON.parse(output(judge, [...args, '--json', '--no-self', '--inout-points', '1000']));
}

function row(file, tolerance, run, { input, measured, judgedInput, judged }) {
  const off = twoSided(measured);
  const faults = [];
  if (!measured.twoManifold || judged?.two_manifold === false) faults.push('not 2-manifold');
  if (measured.components !== input.components) faults.push('parts');
  if (measured.eulerCharacteristic !== input.eulerCharacteristic) faults.push('Euler');
  if (judged !== undefined) {
    if (judged.components !== judgedInput.components) faults.push("judge's parts");
    if (judged.euler !== judgedInput.euler) faults.push("judge's Euler");
    if (judged.distance.queries_skipped_by_time_limit > 0) faults.push('judge out of time');
  }
  const worst = Math.max(off.max, judged?.distance.hausdorff_rel ?? 0);
  if (!(worst <= 1.5 * tolerance)) faults.push('distance');
  return {
    model: nameOf(file),
    tolerance,
    triangles: measured.triangles,
    seconds: meshToMesh(run.seconds).toFixed(3),
    parts: `${input.components} -> ${measured.components}`,
    euler: `${input.eulerCharacteristic} -> ${measured.eulerCharacteristic}`,
    off: off.max.toFixed(5),
    judged: judged?.distance.hausdorff_rel.toFixed(5) ?? '',
    'off/tolerance': (worst / tolerance).toFixed(2),
    rms: off.rms.toFixed(6),
    resolved: run.grid.topologyResolved ? 'yes' : `no: ${run.grid.unresolvedLeaves}`,
    verdict: verdictOf(faults),
  };
}

// The output's edges that count as sharp turn by at least two thirds of the angle; see edges.h.
function edgeRow(file, tolerance, { toSurface, toEdges, length, referenceLength }) {
  return {
    model: nameOf(file),
    tolerance,
    'to surface': toSurface.max.toFixed(5),
    'to sharp edges': toEdges.max.toFixed(5),
    'rms of these': toEdges.rms.toFixed(6),
    'length kept': (length / referenceLength).toFixed(3),
    verdict: toSurface.max <= tolerance ? 'ok' : 'FAILS: edges',
  };
}
