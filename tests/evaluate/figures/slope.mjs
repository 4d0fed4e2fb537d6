// SPDX-License-Identifier: MIT
// Seconds against input triangles: the Fandisk with its triangles cut in four, again and again, no
// point moved. The line through median-of-five seconds on log-log axes must rise by at most 1.1.
import { meshToMesh, native, printTable } from '../../bench/shared.mjs';

const settings = [
  { strategy: 'adaptive', relativeTolerance: 0.002 },
  { strategy: 'adaptive', relativeTolerance: 0.0005 },
  { strategy: 'octree', depth: 21, relativeTolerance: 0 },
];
const limit = 1.1;

export default async function slope({ tools, folder, find }) {
  const rows = [];
  let failures = 0;
  for (const file of find(['fandisk.obj'])) {
    for (const setting of settings) {
      const points = [0, 1, 2, 3].map((subdivide) => {
        const run = native(tools, folder, file, setting, { repeat: 5, subdivide });
        return {
          strategy: setting.strategy,
          tolerance: setting.relativeTolerance,
          input: run.input.triangles,
          output: run.output.triangles,
          seconds: meshToMesh(run.seconds),
        };
      });
      const rise = fittedSlope(points.map(({ input, seconds }) => [input, seconds]));
      failures += rise <= limit ? 0 : 1;
      rows.push(
        ...points.map((point, i) => ({
          ...point,
          seconds: point.seconds.toFixed(4),
          slope: i < points.length - 1 ? '' : rise.toFixed(2),
          verdict: i < points.length - 1 ? '' : rise <= limit ? 'ok' : `FAILS: over ${limit}`,
        })),
      );
    }
  }
  printTable(rows);
  return { rows, failures };
}

// Least squares over the logarithms.
function fittedSlope(points) {
  const logs = points.map((point) => point.map(Math.log));
  const mean = (axis) => logs.reduce((sum, point) => sum + point[axis], 0) / logs.length;
  const [x0, y0] = [mean(0), mean(1)];
  const xy = logs.reduce((sum, [x, y]) => sum + (x - x0) * (y - y0), 0);
  const xx = logs.reduce((sum, [x]) => sum + (x - x0) ** 2, 0);
  return xy / xx;
}
