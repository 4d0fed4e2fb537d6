// SPDX-License-Identifier: MIT
// Every model of the folder, whatever state it is in, becomes a solid: closed, oriented, 2-manifold
// and, with `embedded`, without self-intersections. How far the input is from the result (what lies
// within the solid cannot be near), and back (what closes holes cannot be either); beside
// meshoptimizer's remesh at 128. Distances are fractions of the input's bounding-box diagonal.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { load } from '../../../dist/index.js';
import { output } from '../../../scripts/run.mjs';
import { meshoptimizer } from '../../bench/engines.mjs';
import { contentOf, measure, meshToMesh, nameOf, native, printTable } from '../../bench/shared.mjs';

const setting = { strategy: 'adaptive', relativeTolerance: 0.002 };
const remeshCells = 128;
const share = (number) => number.toFixed(5);

export default async function repair({ files, tools, folder, judge }) {
  const kdm = await load();
  const rows = [];
  for (const file of files) {
    const run = native(tools, folder, file, setting, { repeat: 5 });
    const mesh = kdm.parseMesh(...contentOf(file));
    const started = performance.now();
    const grid = kdm.buildGrid(mesh, setting);
    const result = grid.extract({ strict: 'embedded' });
    const seconds = (performance.now() - started) / 1000;
    const path = join(folder, 'result.obj');
    writeFileSync(path, kdm.formatMesh(result, 'obj', { exact: true }));
    const measured = measure(tools, path, file);
    const judged = judge && JSON.parse(output(judge, [path, '--json']));
    const remeshed = await meshoptimizer(mesh, remeshCells);
    const peerPath = join(folder, 'peer.obj');
    writeFileSync(peerPath, kdm.formatMesh(remeshed.mesh, 'obj'));
    const peer = measure(tools, peerPath, file);
    const { input, stats } = grid;
    grid.delete();
    const crossings = kdm.findSelfIntersections(result).pairs;
    const sound =
      measured.twoManifold &&
      crossings === 0 &&
      (judged?.two_manifold ?? true) &&
      (judged?.self_intersections ?? 0) === 0;
    rows.push({
      model: nameOf(file),
      'open edges': input.boundaryEdges,
      loops: input.boundaryLoops,
      turned: input.turnedFaces,
      doubled: input.duplicateFaces,
      parts: `${input.components} -> ${measured.components}`,
      triangles: result.indices.length / 3,
      'invented hits': stats.inventedHits,
      'invented area': share(result.report.inventedArea / kdm.describe(result).area),
      'input to result': share(measured.fromReference.max),
      'result to input': share(measured.toReference.max),
      native: meshToMesh(run.seconds).toFixed(3),
      wasm: seconds.toFixed(3),
      remesh: remeshed.seconds.toFixed(3),
      'remesh off': share(peer.fromReference.max),
      'remesh bad edges': kdm.describe(remeshed.mesh).nonManifoldEdges,
      verdict: sound ? 'ok' : `FAILS: ${crossings} crossings`,
    });
  }
  printTable(rows);
  return { rows, failures: rows.filter(({ verdict }) => verdict !== 'ok').length };
}
