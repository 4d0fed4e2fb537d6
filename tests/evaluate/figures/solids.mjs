// SPDX-License-Identifier: MIT
// Boolean operations. Every model of the folder minus a ball, united with itself turned, and cut by
// a box: 2-manifold and without crossings. Then what must hold of random poses of closed models:
// volumes add up, a solid minus itself leaves nothing, a solid met with itself is itself, and two
// ways to say the same give the same bytes. Validity is what kdm_measure says, and the judge, if
// there is one; crossings are the judge's or else the library's.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { boolean, load } from '../../../dist/index.js';
import { output } from '../../../scripts/run.mjs';
import {
  closedModels,
  contentOf,
  measure,
  nameOf,
  printTable,
  randomNumbers,
} from '../../bench/shared.mjs';
import { cube } from '../../js/support/meshes.js';
import { verdictOf } from '../verdict.mjs';

const relativeTolerance = 0.002;
const turn = Math.PI / 18;
const poses = 40;
const models = [...closedModels, 'dragon_48k.ply'];

export default async function solids({ files, tools, folder, judge, find }) {
  const kdm = await load();
  const context = { kdm, tools, judge, path: join(folder, 'result.ply') };
  const rows = [];
  for (const file of files) rows.push(...(await operations(context, file)));
  printTable(rows);
  console.log(`${rows.filter(holds).length} of ${rows.length} hold`);
  const identities = find(models).map((file) => identitiesOf(context, file));
  printTable(identities);
  const all = [...rows, ...identities];
  return { rows: all, failures: all.filter((row) => !holds(row)).length };
}

const holds = ({ verdict }) => verdict === 'ok';

function meshOf(kdm, file) {
  const { positions, indices } = kdm.parseMesh(...contentOf(file));
  const { min, max } = kdm.describe({ positions, indices }).bounds;
  const size = Math.hypot(...max.map((x, k) => x - min[k]));
  return { mesh: { positions, indices }, min, middle: min.map((x, k) => (x + max[k]) / 2), size };
}

/** The columns of a matrix of three by three with the shift that leaves a point in place, for `transforms`. */
function about(point, columns) {
  const [x, y, z] = columns;
  const shift = point.map((at, k) => at - (x[k] * point[0] + y[k] * point[1] + z[k] * point[2]));
  return [...x, 0, ...y, 0, ...z, 0, ...shift, 1];
}

const scaledTo = (size, at) => [size, 0, 0, 0, 0, size, 0, 0, 0, 0, size, 0, ...at, 1];

/** What users get of three operations. */
async function operations(context, file) {
  const { mesh, min, middle, size } = meshOf(context.kdm, file);
  const [sine, cosine] = [Math.sin(turn), Math.cos(turn)];
  const turned = about(middle, [
    [cosine, 0, -sine],
    [0, 1, 0],
    [sine, 0, cosine],
  ]);
  const corner = mesh.positions.slice(0, 3);
  const rows = [];
  for (const [operation, expression, other, pose] of [
    ['minus a ball', 'difference', ball(), scaledTo(size / 8, corner)],
    ['united with itself turned', 'union', mesh, turned],
    ['cut by a box', 'difference', cube(), boxOver(min, middle, size)],
  ]) {
    const make = async () => {
      const options = { relativeTolerance, transforms: [null, pose] };
      return (await boolean(expression, [mesh, other], options)).mesh;
    };
    const row = { model: nameOf(file), operation, ...(await judged(context, make)) };
    console.log(`${row.model} ${operation}: ${row.verdict}`);
    rows.push(row);
  }
  return rows;
}

/** A ball of radius 1: rings of points about the x axis, and the ends of that. */
function ball(rings = 15, sides = 32) {
  const positions = [-1, 0, 0];
  const indices = [];
  for (let ring = 1; ring <= rings; ++ring) {
    const [x, radius] = [
      -Math.cos((Math.PI * ring) / (rings + 1)),
      Math.sin((Math.PI * ring) / (rings + 1)),
    ];
    for (let side = 0; side < sides; ++side) {
      const angle = (2 * Math.PI * side) / sides;
      positions.push(x, radius * Math.cos(angle), radius * Math.sin(angle));
    }
  }
  const last = positions.push(1, 0, 0) / 3 - 1;
  const point = (ring, side) => {
    if (ring === 0 || ring > rings) return ring === 0 ? 0 : last;
    return 1 + (ring - 1) * sides + (side % sides);
  };
  for (let ring = 0; ring <= rings; ++ring) {
    for (let side = 0; side < sides; ++side) {
      const [a, b] = [point(ring, side), point(ring, side + 1)];
      const [c, d] = [point(ring + 1, side), point(ring + 1, side + 1)];
      if (ring > 0) indices.push(a, d, b);
      if (ring < rings) indices.push(a, c, d);
    }
  }
  return { positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
}

/** Where a cube of side 2 about the origin goes that holds the corner of the least coordinates, up to the middle. */
function boxOver(min, middle, size) {
  const halves = middle.map((x, k) => (x - min[k] + size / 10) / 2);
  const at = middle.map((x, k) => x - halves[k]);
  return [halves[0], 0, 0, 0, 0, halves[1], 0, 0, 0, 0, halves[2], 0, ...at, 1];
}

/** The grid's own surface. */
function made({ kdm }, expression, operands, transforms, tolerance = relativeTolerance) {
  const grid = kdm.buildBooleanGrid(expression, operands, {
    relativeTolerance: tolerance,
    transforms,
  });
  try {
    return grid.extract({ strict: 'embedded' });
  } finally {
    grid.delete();
  }
}

async function judged(context, make) {
  const { kdm, tools, judge, path } = context;
  let result;
  try {
    result = await make();
  } catch (error) {
    return { verdict: `FAILS: ${error.code ?? error.message}` };
  }
  // As text, coordinates would be read as other numbers than the 32 bits for which it holds.
  writeFileSync(path, kdm.formatMesh(result, 'ply'));
  const { twoManifold, components, eulerCharacteristic } = measure(tools, path);
  const other = judge === undefined ? undefined : JSON.parse(output(judge, [path, '--json']));
  const crossings = other?.self_intersections ?? kdm.findSelfIntersections(result).pairs;
  const faults = [];
  if (!twoManifold || other?.two_manifold === false) faults.push('not 2-manifold');
  if (crossings > 0) faults.push(`${crossings} pairs cross`);
  return {
    triangles: result.indices.length / 3,
    parts: components,
    euler: eulerCharacteristic,
    verdict: verdictOf(faults),
  };
}

/** A rotation by a random quaternion, about the middle, and a shift by up to a fortieth of the size an axis. */
function randomPose(random, middle, size) {
  let q;
  do q = Array.from({ length: 4 }, () => 2 * random() - 1);
  while (Math.hypot(...q) > 1 || Math.hypot(...q) < 0.1);
  const [x, y, z, w] = q.map((c) => c / Math.hypot(...q));
  const pose = about(middle, [
    [1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
    [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)],
    [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)],
  ]);
  for (let k = 0; k < 3; ++k) pose[12 + k] += (size * (random() - 0.5)) / 20;
  return pose;
}

function areaOf({ positions, indices }) {
  let sum = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) =>
      positions.subarray(3 * indices[i + k], 3 * indices[i + k] + 3),
    );
    const [u, v] = [b, c].map((p) => [0, 1, 2].map((k) => p[k] - a[k]));
    const normal = [0, 1, 2].map(
      (k) => u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3],
    );
    sum += Math.hypot(...normal) / 2;
  }
  return sum;
}

const sameBytes = (a, b) =>
  Buffer.compare(Buffer.from(a.positions.buffer), Buffer.from(b.positions.buffer)) === 0 &&
  Buffer.compare(Buffer.from(a.indices.buffer), Buffer.from(b.indices.buffer)) === 0;

function identitiesOf(context, file) {
  const { kdm } = context;
  const tolerance = 0.005;
  const { mesh, middle, size } = meshOf(kdm, file);
  const random = randomNumbers(17);
  const { volume } = kdm.describe(mesh);
  const area = areaOf(mesh);
  let worst = 0;
  const faults = new Map();
  const fault = (what) => faults.set(what, (faults.get(what) ?? 0) + 1);
  for (let i = 0; i < poses; ++i) {
    const transforms = [randomPose(random, middle, size), randomPose(random, middle, size)];
    const of = (expression, operands = [mesh, mesh], at = transforms) =>
      made(context, expression, operands, at, tolerance);
    const volumeOf = (expression) => kdm.describe(of(expression)).volume;
    const off = volumeOf('union') + volumeOf('intersection') - 2 * volume;
    worst = Math.max(worst, Math.abs(off) / (tolerance * size * 2 * area));
    if (!sameBytes(of('difference'), of(['intersection', 0, ['complement', 1]]))) {
      fault('a - b is not a and not b');
    }
    const twice = [transforms[0], transforms[0]];
    if (!sameBytes(of('intersection', [mesh, mesh], twice), of('union', [mesh], [twice[0]]))) {
      fault('a and a is not a');
    }
    try {
      of('difference', [mesh, mesh], twice);
      fault('a - a is something');
    } catch (error) {
      if (error.code !== 'EMPTY_RESULT') fault(error.code);
    }
  }
  if (worst > 1) fault('volumes do not add up');
  return {
    model: nameOf(file),
    poses,
    'volumes off, by tolerance x area': worst.toFixed(4),
    verdict:
      faults.size === 0 ? 'ok' : `FAILS: ${[...faults].map(([what, n]) => `${what} (${n})`)}`,
  };
}
