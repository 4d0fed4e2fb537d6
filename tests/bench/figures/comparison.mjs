// SPDX-License-Identifier: MIT
// kd-tree against octree (paper Fig. 10 and 15): `adaptive` and `feature` against `octree`, which
// stops by the same rule but splits at midpoints. At equal error: each runs at a ladder of
// tolerances, and sizes are read off between the runs on log-log axes. At equal depth: both get
// the same limit. Errors are fractions of the diagonal, both ways.
import { join } from 'node:path';
import { output } from '../../../scripts/run.mjs';
import { measure, meshToMesh, nameOf, native, printTable, twoSided } from '../shared.mjs';

const models = ['fandisk.obj', 'casting.off', 'dragon_48k.ply'];
const scene = 'street_apart_88k';
const strategies = ['adaptive', 'feature', 'octree'];
const ladder = [0.016, 0.008, 0.004, 0.002, 0.001, 0.0005, 0.00025];
const depths = [15, 18, 21];
const depthTolerance = 0.0005;
const sizes = ['cells', 'bytes', 'triangles', 'seconds'];

export default async function comparison({ tools, folder, find }) {
  output(join(tools, 'kdm_bench'), ['--export', folder, '--models', `scene:${scene}`]);
  const rows = { runs: [], equalError: [], equalDepth: [] };
  const runOne = (file, setting) => {
    const result = join(folder, 'result.ply');
    const run = native(tools, folder, file, setting, { keep: result });
    const { max, rms } = twoSided(measure(tools, result, file));
    return {
      model: nameOf(file),
      ...setting,
      cells: run.grid.cells,
      bytes: run.grid.bytes,
      triangles: run.output.triangles,
      seconds: meshToMesh(run.seconds),
      hausdorff: max,
      rms,
    };
  };
  for (const file of [...find(models), join(folder, `${scene}.ply`)]) {
    for (const strategy of strategies) {
      for (const relativeTolerance of ladder) {
        rows.runs.push(runOne(file, { strategy, relativeTolerance }));
      }
      for (const depth of depths) {
        const setting = { strategy, depth, relativeTolerance: depthTolerance };
        rows.equalDepth.push(runOne(file, setting));
      }
    }
    const own = rows.runs.filter(({ model }) => model === nameOf(file));
    for (const measureName of ['hausdorff', 'rms']) {
      rows.equalError.push(...atEqualError(nameOf(file), own, measureName));
    }
  }
  console.log('at equal error (how many times the octree takes of each):');
  printTable(rows.equalError);
  console.log(`\nat equal depth (tolerance ${depthTolerance}):`);
  printTable(rows.equalDepth.map(shown));
  return { rows, failures: 0 };
}

// Three errors that all strategies reach: a quarter, a half, three quarters of the common range.
function atEqualError(model, runs, measureName) {
  const curves = Object.fromEntries(
    strategies.map((name) => [name, runs.filter(({ strategy }) => strategy === name)]),
  );
  const errors = (curve) => curve.map((run) => run[measureName]);
  const least = Math.max(...strategies.map((name) => Math.min(...errors(curves[name]))));
  const most = Math.min(...strategies.map((name) => Math.max(...errors(curves[name]))));
  if (!(least < most)) return [];
  return [0.75, 0.5, 0.25].map((share) => {
    const error = least * (most / least) ** share;
    const row = { model, error: `${measureName} ${error.toFixed(6)}` };
    const octree = sizesAt(curves.octree, measureName, error);
    for (const name of ['adaptive', 'feature']) {
      const own = sizesAt(curves[name], measureName, error);
      row[`${name}'s triangles`] = Math.round(own.triangles);
      for (const size of sizes) row[`${name} ${size}`] = (octree[size] / own[size]).toFixed(2);
    }
    return row;
  });
}

/**
 * The sizes at which a curve gets down to an error. The error need not fall with every step, so the
 * first run that reaches it counts, interpolated from the best one before.
 */
function sizesAt(curve, measureName, error) {
  const reached = curve.findIndex((run) => run[measureName] <= error);
  const run = curve[reached];
  if (reached === 0) return run;
  const before = curve
    .slice(0, reached)
    .reduce((best, one) => (one[measureName] <= best[measureName] ? one : best));
  const share =
    Math.log(before[measureName] / error) / Math.log(before[measureName] / run[measureName]);
  return Object.fromEntries(
    sizes.map((size) => [size, before[size] * (run[size] / before[size]) ** share]),
  );
}

function shown({ model, strategy, depth, cells, bytes, triangles, hausdorff, rms }) {
  return {
    ...{ model, strategy, depth, cells, bytes, triangles },
    hausdorff: hausdorff.toFixed(5),
    rms: rms.toFixed(6),
  };
}
