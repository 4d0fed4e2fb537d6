// SPDX-License-Identifier: MIT
// Bytes of the grid, and the most that the whole process ever holds (input and result included),
// for each triangle of the result. The aim is a grid of at most 150.
import { nameOf, native, printTable } from '../../bench/shared.mjs';

const models = [
  'fandisk.obj',
  'armadillo_86k.ply',
  'casting.off',
  'horse_quad.obj',
  'dragon_48k.ply',
  'dragon_202k.ply',
  'scene:thin_box',
  'scene:nested_spheres',
  'scene:torus_chain',
  'scene:street_apart_88k',
];
const settings = [
  { strategy: 'adaptive', relativeTolerance: 0.002 },
  { strategy: 'adaptive', relativeTolerance: 0.0005 },
  { strategy: 'octree', depth: 21, relativeTolerance: 0 },
];
const aim = 150;

export default async function memory({ tools, folder, find }) {
  const rows = [];
  for (const model of find(models)) {
    for (const setting of settings) {
      const run = native(tools, folder, model, setting);
      const triangles = run.output.triangles;
      const perTriangle = run.grid.bytes / triangles;
      rows.push({
        model: nameOf(model),
        strategy: setting.strategy,
        tolerance: setting.relativeTolerance,
        input: run.input.triangles,
        output: triangles,
        'grid bytes': run.grid.bytes,
        'per triangle': perTriangle.toFixed(1),
        [`within ${aim}`]: perTriangle <= aim ? 'yes' : 'no',
        'peak MB': (run.peakBytes / 1e6).toFixed(1),
        'peak per triangle': (run.peakBytes / triangles).toFixed(0),
      });
    }
  }
  printTable(rows);
  return { rows, failures: 0 };
}
