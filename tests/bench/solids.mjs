// SPDX-License-Identifier: MIT
// `npm run bench -- --solids [MODEL] [--turn 10] [--repeat 3]`: what the paper shows in its figure 16. Two copies of a
// model (OBJ, STL, PLY or OFF; without one a torus), one turned about the vertical axis through its middle, are
// united, and a cylinder is cut out. Processor time and validity, at three tolerances, beside manifold-3d.
import { readFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { builders } from '../../scripts/build.mjs';
import { median } from './shared.mjs';

const { values, positionals } = parseArgs({
  options: {
    turn: { type: 'string', default: '10' },
    repeat: { type: 'string', default: '3' },
  },
  allowPositionals: true,
});
builders.package();
const { formatFromPath, load } = await import('../../dist/index.js');
const { manifoldModule } = await import('./engines.mjs');
const { faults, torus, volume } = await import('../js/support/meshes.js');
const kdm = await load();

const [path] = positionals;
const model = path
  ? kdm.parseMesh(readFileSync(path), formatFromPath(path), path)
  : torus(512, 256);
const { min, max } = kdm.describe(model).bounds;
const middle = min.map((x, k) => (x + max[k]) / 2);
const size = Math.hypot(...max.map((x, k) => x - min[k]));

/** The mesh with every point taken to another place, in 32 bits, as both sides see it. */
function mapped(mesh, map) {
  const positions = new Float32Array(mesh.positions.length);
  for (let i = 0; i < positions.length; i += 3) {
    positions.set(map([...mesh.positions.subarray(i, i + 3)]), i);
  }
  return { positions, indices: Uint32Array.from(mesh.indices) };
}

const angle = (Number(values.turn) * Math.PI) / 180;
const [sine, cosine] = [Math.sin(angle), Math.cos(angle)];
const turned = mapped(model, (p) => {
  const [x, , z] = p.map((value, k) => value - middle[k]);
  return [middle[0] + cosine * x + sine * z, p[1], middle[2] - sine * x + cosine * z];
});

/** A cylinder along z through the middle. */
function drill(radius, length, sides = 64) {
  const ring = Array.from({ length: 2 * sides }, (_, i) => {
    const turn = (2 * Math.PI * (i >> 1)) / sides;
    return [radius * Math.cos(turn), radius * Math.sin(turn), (i % 2 ? 1 : -1) * (length / 2)];
  });
  const ends = [-1, 1].map((end) => [0, 0, (end * length) / 2]);
  const indices = [];
  for (let i = 0; i < sides; ++i) {
    const [a, b, c, d] = [0, 1, 2, 3].map((k) => (2 * i + k) % (2 * sides));
    indices.push(a, c, b, b, c, d, 2 * sides, c, a, 2 * sides + 1, b, d);
  }
  return { positions: Float32Array.from([...ring, ...ends].flat()), indices };
}
const cylinder = mapped(drill(size / 12, 2 * size), (p) => p.map((x, k) => x + middle[k]));
const operands = [mapped(model, (p) => p), turned, cylinder];
const expression = ['difference', ['union', 0, 1], 2];

/** Processor time of this process, in seconds. */
function timed(work) {
  const start = process.cpuUsage();
  const result = work();
  const { user, system } = process.cpuUsage(start);
  return { result, seconds: (user + system) / 1e6 };
}

function row(name, work) {
  const runs = Array.from({ length: Number(values.repeat) }, () => timed(work));
  const { result } = runs[0];
  if (result.refused !== undefined) return { name, result: `refused: ${result.refused}` };
  const found = faults(result);
  return {
    name,
    seconds: median(runs.map(({ seconds }) => seconds)).toFixed(2),
    triangles: result.indices.length / 3,
    volume: volume(result).toPrecision(6),
    'crossing pairs': kdm.findSelfIntersections(result).pairs,
    result: found.length === 0 ? '2-manifold' : found.join(', '),
  };
}

function own(relativeTolerance) {
  const grid = kdm.buildBooleanGrid(expression, operands, { relativeTolerance });
  try {
    return grid.extract({ strict: 'embedded' });
  } finally {
    grid.delete();
  }
}

const { Manifold, Mesh } = await manifoldModule();
function peer() {
  const made = [];
  const keep = (manifold) => (made.push(manifold), manifold);
  try {
    const [a, b, c] = operands.map(({ positions, indices }) => {
      const mesh = new Mesh({ numProp: 3, vertProperties: positions, triVerts: indices });
      mesh.merge();
      return keep(new Manifold(mesh));
    });
    const { vertProperties, triVerts } = keep(keep(a.add(b)).subtract(c)).getMesh();
    return { positions: vertProperties.slice(), indices: triVerts.slice() };
  } catch (error) {
    return { refused: error.code ?? error.message };
  } finally {
    for (const manifold of made) manifold.delete();
  }
}

const triangles = operands.reduce((sum, { indices }) => sum + indices.length / 3, 0);
console.log(`${path ?? 'a torus'}, twice, and a cylinder: ${triangles} triangles`);
console.log([
  ...[0.002, 0.001, 0.0005].map((share) => row(`kdmanifold, ${share}`, () => own(share))),
  row('manifold-3d', peer),
]);
