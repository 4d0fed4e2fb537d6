// SPDX-License-Identifier: MIT
// kd-tree against octree (paper Fig. 10 and 15): `adaptive` and `feature` against `octree`, which
// stops by the same rule but splits at midpoints. At equal error: each runs at a ladder of
// tolerances, and sizes are read off between the runs on log-log axes. At equal depth: both get
// the same limit. Errors are fractions of the diagonal, both ways.
import { join } from 'node:path';
import { output } from '../../../scripts/run.mjs';
import { measure, meshToMesh, nameOf, native, printTable, twoSided } from '../../bench/shared.mjs';

const models = ['fandisk.obj', 'casting.off', 'dragon_48k.ply'];
const scene = 'street_apart_88k';
const kdTrees = ['adaptive', 'feature'];
const strategies = [...kdTrees, 'octree'];
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
    const { max, rms } = twoSided(measure(tools, result, file, ['--no-check']));
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
    const runs = strategies.flatMap((strategy) =>
      ladder.map((relativeTolerance) => runOne(file, { strategy, relativeTolerance })),
    );
    const equalError = ['hausdorff', 'rms'].flatMap((kind) =>
      atEqualError(nameOf(file), runs, kind),
    );
    const equalDepth = depths.flatMap((depth) =>
      strategies.map((strategy) =>
        runOne(file, { strategy, depth, relativeTolerance: depthTolerance }),
      ),
    );
    console.log(`\n${nameOf(file)} at equal error; "x ...": how many times the octree takes`);
    printTable(equalError);
    console.log(`\n${nameOf(file)} at equal depth, tolerance ${depthTolerance}`);
    printTable(equalDepth.map(shown));
    rows.runs.push(...runs);
    rows.equalError.push(...equalError);
    rows.equalDepth.push(...equalDepth);
  }
  return { rows, failures: 0 };
}

// Three errors that all strategies reach: a quarter, a half, three quarters of the common range.
function atEqualError(model, runs, kind) {
  const curves = strategies.map((name) => runs.filter(({ strategy }) => strategy === name));
  const errors = curves.map((curve) => curve.map((run) => run[kind]));
  const least = Math.max(...errors.map((one) => Math.min(...one)));
  const most = Math.min(...errors.map((one) => Math.max(...one)));
  if (!(least < most)) return [];
  return [0.75, 0.5, 0.25].flatMap((share) => {
    const error = least * (most / least) ** share;
    const at = Object.fromEntries(
      strategies.map((name, i) => [name, sizesAt(curves[i], kind, error)]),
    );
    return kdTrees.map((rule) => ({
      model,
      'at equal': `${kind} ${error.toFixed(6)}`,
      rule,
      cells: Math.round(at[rule].cells),
      triangles: Math.round(at[rule].triangles),
      ...Object.fromEntries(
        sizes.map((size) => [`x ${size}`, (at.octree[size] / at[rule][size]).toFixed(2)]),
      ),
    }));
  });
}

/**
 * The sizes at which a curve gets down to an error. The error need not fall with every step, so the
 * first run that reaches it counts, interpolated from the best one before.
 */
function sizesAt(curve, kind, error) {
  const reached = curve.findIndex((run) => run[kind] <= error);
  const run = curve[reached];
  if (reached === 0) return run;
  const before = curve
    .slice(0, reached)
    .reduce((best, one) => (one[kind] <= best[kind] ? one : best));
  const share = Math.log(before[kind] / error) / Math.log(before[kind] / run[kind]);
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
