// SPDX-License-Identifier: MIT
// What `strict: embedded` costs and gives on closed models, against `manifold`: crossings, faces
// without area, thin triangles, further triangles, time of extraction. Holds where nothing crosses
// on models that do not cross themselves and no triangle is without area. Crossings, areas and angles
// are the judge's, if there is one.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { load } from '../../../dist/index.js';
import { output } from '../../../scripts/run.mjs';
import { closedModels, contentOf, median, nameOf, printTable, sizes } from '../../bench/shared.mjs';
import { verdictOf } from '../verdict.mjs';

const repeat = 5;

export default async function embedded({ folder, judge, find }) {
  const kdm = await load({ threads: 1 });
  const rows = [];
  for (const file of find(closedModels)) {
    const input = kdm.parseMesh(...contentOf(file));
    for (const { name, options } of sizes) {
      const grid = kdm.buildGrid(input, options);
      const plain = extracted(kdm, grid, 'manifold', join(folder, 'plain.obj'), judge);
      const clear = extracted(kdm, grid, 'embedded', join(folder, 'clear.obj'), judge);
      grid.delete();
      rows.push(row(nameOf(file), name, plain, clear));
    }
  }
  console.log(
    'each pair: manifold -> embedded; thin: share of triangles with an angle below 1 degree',
  );
  printTable(rows);
  return { rows, failures: rows.filter(({ verdict }) => verdict !== 'ok').length };
}

function extracted(kdm, grid, strict, path, judge) {
  const seconds = [];
  let mesh;
  for (let i = 0; i < repeat; ++i) {
    const start = process.cpuUsage();
    mesh = grid.extract({ strict });
    const { user, system } = process.cpuUsage(start);
    seconds.push((user + system) / 1e6);
  }
  const result = { mesh, seconds: median(seconds) };
  if (judge === undefined) return result;
  writeFileSync(path, kdm.formatMesh(mesh, 'obj'));
  return { ...result, judged: JSON.parse(output(judge, [path, '--json'])) };
}

function row(model, setting, plain, clear) {
  const both = (what) => `${what(plain)} -> ${what(clear)}`;
  const judged = (what) => (clear.judged === undefined ? '' : both((one) => what(one.judged)));
  const triangles = (one) => one.mesh.indices.length / 3;
  const faults = [];
  if (clear.mesh.report.crossings !== 0) faults.push('crossings');
  if (clear.judged !== undefined) {
    if (clear.judged.self_intersections !== 0) faults.push("judge's crossings");
    if (plain.judged.zero_area_faces + clear.judged.zero_area_faces !== 0) {
      faults.push('faces without area');
    }
    if (!clear.judged.two_manifold) faults.push('not 2-manifold');
  }
  return {
    model,
    setting,
    triangles: both(triangles),
    'more triangles': percent(triangles(clear) / triangles(plain) - 1),
    'refined hits': clear.mesh.report.refinedHits,
    crossings: judged((one) => one.self_intersections),
    'without area': judged((one) => one.zero_area_faces),
    thin: judged((one) => percent(one.min_angle_below_1deg)),
    seconds: both((one) => one.seconds.toFixed(4)),
    'more time': percent(clear.seconds / plain.seconds - 1),
    verdict: verdictOf(faults),
  };
}

const percent = (part) => `${(100 * part).toFixed(2)} %`;
