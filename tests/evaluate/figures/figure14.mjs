// SPDX-License-Identifier: MIT
// The paper's figure 14: a vase with a thin wall stays, or goes if thin material may go. Beside it stands a block with
// a tunnel and a flat cavity, which must stay as they are; a cavity as thin as the wall goes if material may be added.
// Once where the grid is built (`minimumThickness`, `minimumGap`), once with the paper's removal of splits
// (`removedMaterial`, `addedMaterial`); limits are below and above the wall's thickness.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { load } from '../../../dist/index.js';
import { measure, printTable } from '../../bench/shared.mjs';
import { together } from '../../js/support/meshes.js';
import { box, cubes, inwards, vase } from '../paper_shapes.mjs';
import { drawBeside } from '../picture.mjs';
import { verdictOf } from '../verdict.mjs';

const wall = 0.04;
const [below, above] = [0.75 * wall, 1.5 * wall];
const relativeTolerance = 0.001;
const surfaceError = 0.001;

// What there is to be of each: bodies, cavities, handles.
const all = { bodies: 2, cavities: 1, handles: 1 };
const withoutVase = { ...all, bodies: 1 };
const withoutCavity = { ...all, cavities: 0 };
const cases = [
  { title: 'as it is', expected: all },
  { title: 'thickness below', build: { minimumThickness: below }, expected: all },
  { title: 'thickness above', build: { minimumThickness: above }, expected: withoutVase },
  { title: 'gap below', build: { minimumGap: below }, expected: all },
  { title: 'gap above', build: { minimumGap: above }, expected: withoutCavity },
  { title: 'surface only', simplify: {}, expected: all },
  { title: 'removed below', simplify: { removedMaterial: below }, expected: all },
  { title: 'removed above', simplify: { removedMaterial: above }, expected: withoutVase },
  { title: 'added below', simplify: { addedMaterial: below }, expected: all },
  { title: 'added above', simplify: { addedMaterial: above }, expected: withoutCavity },
];

/** A ring of blocks, one of which has a cavity, and a vase above it that does not touch it. */
function scene() {
  const cells = [0, 1, 2].flatMap((x) => [0, 1, 2].map((y) => [x, y, 0]));
  const ring = cells.filter(([x, y]) => x !== 1 || y !== 1);
  const block = cubes(ring, ([x, y, z]) => [(x - 1.5) * 0.6, (y - 1.5) * 0.6, 0.6 * z - 0.8]);
  const cavity = inwards(box([-0.8, -0.8, -0.5], [-0.4, -0.4, -0.5 + wall]));
  return together(vase(wall), block, cavity);
}

export default async function figure14({ tools, folder, out }) {
  const kdm = await load();
  const path = join(folder, 'result.ply');
  const whole = scene();
  const rows = [];
  const meshes = new Map();

  const make = (mesh, { build, simplify }) => {
    const grid = kdm.buildGrid(mesh, { relativeTolerance, ...build });
    try {
      if (simplify !== undefined) grid.simplify({ surfaceError, ...simplify });
      return { mesh: grid.extract({ strict: 'embedded' }), leaves: grid.stats.leaves };
    } finally {
      grid.delete();
    }
  };
  const count = (mesh) => {
    const { parts } = kdm.analyze(mesh);
    const cavities = parts.filter(({ cavity }) => cavity).length;
    const handles = parts.reduce((sum, { genus }) => sum + genus, 0);
    return { bodies: parts.length - cavities, cavities, handles };
  };

  for (const { title, expected, ...options } of cases) {
    const { mesh, leaves } = make(whole, options);
    meshes.set(title, mesh);
    writeFileSync(path, kdm.formatMesh(mesh, 'ply'));
    const found = count(mesh);
    const { twoManifold, eulerCharacteristic, volume } = measure(tools, path);
    const crossings = kdm.findSelfIntersections(mesh).pairs;
    const faults = Object.keys(expected).filter((name) => found[name] !== expected[name]);
    if (!twoManifold) faults.push('not 2-manifold');
    if (crossings > 0) faults.push(`${crossings} pairs cross`);
    rows.push({
      case: title,
      limit: Object.values({ ...options.build, ...options.simplify })[0]?.toFixed(3) ?? '',
      ...found,
      euler: eulerCharacteristic,
      volume: volume.toFixed(4),
      leaves,
      triangles: mesh.indices.length / 3,
      verdict: verdictOf(faults),
    });
  }
  // By itself the vase leaves nothing.
  for (const [title, options] of [
    ['vase alone, thickness above', { build: { minimumThickness: above } }],
    ['vase alone, removed above', { simplify: { removedMaterial: above } }],
  ]) {
    rows.push({ case: title, limit: above.toFixed(3), verdict: verdictOfNothing(options) });
  }
  console.log(`a vase with a wall of ${wall}, a block with a tunnel and a cavity ${wall} high`);
  printTable(rows);
  if (out !== undefined) await show();
  return { rows, failures: rows.filter(({ verdict }) => verdict !== 'ok').length };

  function verdictOfNothing(options) {
    try {
      make(vase(wall), options);
      return 'FAILS: something is left';
    } catch (error) {
      return error.code === 'EMPTY_RESULT' ? 'ok' : `FAILS: ${error.code}`;
    }
  }

  async function show() {
    const shown = [
      ['input', whole],
      ...['surface only', 'removed above', 'thickness above', 'added above'].map((title) => [
        title,
        meshes.get(title),
      ]),
    ].map(([title, mesh]) => ({ title, mesh }));
    for (const { title, mesh } of shown) {
      const name = `figure14_${title.replace(' ', '_')}.ply`;
      writeFileSync(join(out, name), kdm.formatMesh(mesh, 'ply'));
    }
    const view = { from: [-0.9, -1.5, 0.7], lines: true };
    await drawBeside(join(out, 'figure14.png'), shown, view);
    const halved = { ...view, from: [1, -1, 0.3], cut: [1, -1, 0] };
    await drawBeside(join(out, 'figure14_cut.png'), shown, halved);
  }
}
