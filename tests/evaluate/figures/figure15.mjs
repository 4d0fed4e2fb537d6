// SPDX-License-Identifier: MIT
// The paper's figure 15: a battlement with more triangles than it needs, turned about one axis and about all, by several
// split rules: as they stand, and simplified at almost no error. The paper's own are `feature` (its second heuristic) to
// depth 6 and the standard octree to depth 12, which is `uniform` here: `octree` stops where all is met. Beside these
// stand more depth, and rules that stop at a tolerance.
// Results must be 2-manifold without crossings, and simplifying must not move the surface further than one and a half
// tolerances. Whether trees with planes of their own choice are smaller than the octree is told, not asked for.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { load } from '../../../dist/index.js';
import { measure, printTable, twoSided } from '../../bench/shared.mjs';
import { battlement, turnedBy } from '../paper_shapes.mjs';
import { drawBeside } from '../picture.mjs';
import { verdictOf } from '../verdict.mjs';

const almostNothing = 1e-6; // of the diagonal, as all errors here
const tolerance = 0.001;

const cases = [
  { strategy: 'feature', depth: 6, relativeTolerance: 0 },
  { strategy: 'feature', depth: 12, relativeTolerance: 0 },
  { strategy: 'feature', relativeTolerance: tolerance },
  { strategy: 'adaptive', depth: 12, relativeTolerance: 0 },
  { strategy: 'adaptive', relativeTolerance: tolerance },
  { strategy: 'uniform', depth: 12 },
  { strategy: 'uniform', depth: 18 },
  { strategy: 'octree', depth: 12, relativeTolerance: 0 },
  { strategy: 'octree', relativeTolerance: tolerance },
];

const nameOfCase = ({ strategy, depth, relativeTolerance }) =>
  `${strategy} ${depth === undefined ? `to ${100 * relativeTolerance} %` : `depth ${depth}`}`;

const poses = {
  'one axis': battlement(3, turnedBy([Math.cos(0.2), 0, Math.sin(0.2), 0])),
  'all axes': battlement(3),
};

export default async function figure15({ tools, folder, out }) {
  const kdm = await load();
  const rows = [];
  for (const [pose, input] of Object.entries(poses)) {
    const stem = join(out ?? folder, `figure15_${pose.replace(' ', '_')}`);
    const made = makeMeshes(kdm, tools, stem, input);
    console.log(`turned about ${pose}, ${input.indices.length / 3} triangles; % of the diagonal`);
    const own = made.map((one) => ({ pose, ...rowOf(one) }));
    printTable(own);
    const octree = made.find(
      ({ options: { strategy, depth } }) => strategy === 'uniform' && depth === 12,
    );
    console.log('against the standard octree to depth 12, both simplified:');
    for (const one of made.filter((it) => it !== octree)) console.log(comparison(one, octree));
    if (out !== undefined) await show(`${stem}.png`, input, made);
    rows.push(...own);
  }
  return { rows, failures: rows.filter(({ verdict }) => verdict !== 'ok').length };
}

/** Every case as it is built, and simplified. */
function makeMeshes(kdm, tools, stem, input) {
  const write = (name, mesh) => {
    const path = `${stem}_${name.replace(/\W+/g, '_')}.ply`;
    writeFileSync(path, kdm.formatMesh(mesh, 'ply'));
    return path;
  };
  const reference = write('input', input);
  const { min, max } = kdm.describe(input).bounds;
  const size = Math.hypot(...max.map((x, k) => x - min[k]));
  return cases.map((options) => {
    const grid = kdm.buildGrid(input, options);
    const step = (name) => {
      const mesh = grid.extract({ strict: 'embedded' });
      const path = write(`${nameOfCase(options)} ${name}`, mesh);
      const judged = measure(tools, path, reference);
      const { leaves } = grid.stats;
      const crossings = kdm.findSelfIntersections(mesh).pairs;
      return { mesh, path, leaves, judged, crossings, away: twoSided(judged).max };
    };
    const before = step('built');
    grid.simplify({ surfaceError: almostNothing * size });
    const after = step('simplified');
    grid.delete();
    const moved = twoSided(measure(tools, after.path, before.path, ['--no-check'])).max;
    return { options, before, after, moved };
  });
}

const percent = (part) => (100 * part).toFixed(3);

function rowOf({ options, before, after, moved }) {
  const faults = [];
  for (const { judged, crossings } of [before, after]) {
    if (!judged.twoManifold) faults.push('not 2-manifold');
    if (crossings > 0) faults.push(`${crossings} pairs cross`);
  }
  if (moved > 1.5 * (tolerance + almostNothing)) faults.push('simplifying moved the surface');
  return {
    rule: nameOfCase(options),
    leaves: before.leaves,
    triangles: before.judged.triangles,
    volume: before.judged.volume.toFixed(4),
    'away %': percent(before.away),
    'simplified: leaves': after.leaves,
    'triangles ': after.judged.triangles,
    'volume ': after.judged.volume.toFixed(4),
    'away % ': percent(after.away),
    'moved %': percent(moved),
    verdict: verdictOf(faults),
  };
}

function comparison({ options, after }, octree) {
  const times = (part, whole) => (part / whole).toFixed(2);
  const leaves = times(after.leaves, octree.after.leaves);
  const triangles = times(after.judged.triangles, octree.after.judged.triangles);
  const away = times(after.away, octree.after.away);
  return `  ${nameOfCase(options)}: ${leaves} of the leaves, ${triangles} of the triangles, ${away} of the distance`;
}

const shownCases = [
  'feature depth 6',
  'feature depth 12',
  'adaptive to 0.1 %',
  'uniform depth 12',
  'octree depth 12',
];

async function show(path, input, made) {
  const shown = [{ title: `input: ${input.indices.length / 3} triangles`, mesh: input }];
  for (const { options, before, after } of made) {
    if (!shownCases.includes(nameOfCase(options))) continue;
    for (const [what, { mesh, leaves, judged }] of [
      ['', before],
      [', simplified', after],
    ]) {
      const counts = `${leaves} leaves, ${judged.triangles} triangles`;
      shown.push({ title: `${nameOfCase(options)}${what}: ${counts}`, mesh });
    }
  }
  await drawBeside(path, shown, { from: [0.5, -1.2, 0.9], lines: true });
}
