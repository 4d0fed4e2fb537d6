// SPDX-License-Identifier: MIT
// A closed model is damaged and repaired: patches punched out, faces turned and doubled, triangles
// torn apart. How far the result is from the intact model, in volume and in distance (fractions of
// the volume and of the bounding-box diagonal).
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { load } from '../../../dist/index.js';
import { contentOf, measure, nameOf, printTable, randomNumbers } from '../../bench/shared.mjs';

const models = ['armadillo_86k.ply'];
const relativeTolerance = 0.002;
const patchArea = 0.005;

const triangleCount = ({ indices }) => indices.length / 3;
const corner = ({ positions, indices }, i) =>
  positions.subarray(3 * indices[i], 3 * indices[i] + 3);

function areas(mesh) {
  return Float64Array.from({ length: triangleCount(mesh) }, (_, t) => {
    const [a, b, c] = [0, 1, 2].map((i) => corner(mesh, 3 * t + i));
    const [u, v] = [b, c].map((p) => [0, 1, 2].map((k) => p[k] - a[k]));
    return (
      Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) /
      2
    );
  });
}

/** Leaves out the triangles nearest to random ones, as many as fill a share of the area each. */
function punched(mesh, holes) {
  const random = randomNumbers(holes);
  const area = areas(mesh);
  const wanted = patchArea * area.reduce((sum, one) => sum + one, 0);
  const gone = new Uint8Array(area.length);
  for (let hole = 0; hole < holes; ++hole) {
    const centre = corner(mesh, 3 * Math.floor(random() * area.length));
    const distance = Float64Array.from(area, (_, t) => {
      const p = corner(mesh, 3 * t);
      return Math.hypot(p[0] - centre[0], p[1] - centre[1], p[2] - centre[2]);
    });
    let sum = 0;
    for (const t of [...area.keys()].sort((s, t) => distance[s] - distance[t])) {
      if (sum >= wanted) break;
      sum += area[t];
      gone[t] = 1;
    }
  }
  return { ...mesh, indices: mesh.indices.filter((_, i) => gone[Math.floor(i / 3)] === 0) };
}

function turned(mesh, share) {
  const random = randomNumbers(Math.round(1000 * share));
  const indices = mesh.indices.slice();
  for (let t = 0; t < triangleCount(mesh); ++t) {
    if (random() < share) indices.subarray(3 * t, 3 * t + 3).reverse();
  }
  return { ...mesh, indices };
}

function doubled(mesh, share) {
  const random = randomNumbers(Math.round(1000 * share));
  const again = [];
  for (let t = 0; t < triangleCount(mesh); ++t) {
    if (random() < share) again.push(...mesh.indices.subarray(3 * t, 3 * t + 3));
  }
  return { ...mesh, indices: Uint32Array.from([...mesh.indices, ...again]) };
}

/** Every triangle by itself, its corners moved by up to `amount`. */
function torn(mesh, amount) {
  const random = randomNumbers(5);
  const positions = Float64Array.from({ length: 3 * mesh.indices.length }, (_, i) => {
    const place = 3 * mesh.indices[Math.floor(i / 3)] + (i % 3);
    return mesh.positions[place] + amount * (2 * random() - 1);
  });
  return { positions, indices: Uint32Array.from({ length: mesh.indices.length }, (_, i) => i) };
}

function damages(mesh, diagonal) {
  return [
    ...[1, 10, 100].map((holes) => [`${holes} holes`, () => punched(mesh, holes)]),
    ...[0.01, 0.1, 0.3].map((share) => [`${100 * share} % turned`, () => turned(mesh, share)]),
    ['10 % doubled', () => doubled(mesh, 0.1)],
    ...[1e-4, 5e-4].map((amount) => [`torn by ${amount}`, () => torn(mesh, amount * diagonal)]),
  ];
}

export default async function damage({ tools, folder, find }) {
  const kdm = await load();
  const rows = [];
  for (const file of find(models)) {
    const { positions, indices } = kdm.parseMesh(...contentOf(file));
    const intact = { positions, indices };
    const { volume, bounds } = kdm.describe(intact);
    const diagonal = Math.hypot(...bounds.max.map((x, i) => x - bounds.min[i]));
    for (const [name, make] of damages(intact, diagonal)) {
      const grid = kdm.buildGrid(make(), { relativeTolerance });
      const result = grid.extract();
      const path = join(folder, 'result.obj');
      writeFileSync(path, kdm.formatMesh(result, 'obj'));
      const measured = measure(tools, path, file);
      const invented = grid.stats.inventedHits;
      grid.delete();
      rows.push({
        model: nameOf(file),
        damage: name,
        triangles: result.indices.length / 3,
        parts: measured.components,
        euler: measured.eulerCharacteristic,
        'invented hits': invented,
        'volume error': (kdm.describe(result).volume / volume - 1).toFixed(5),
        'result to intact': measured.toReference.max.toFixed(5),
        'intact to result': measured.fromReference.max.toFixed(5),
        verdict: measured.twoManifold ? 'ok' : 'FAILS: not 2-manifold',
      });
    }
  }
  printTable(rows);
  return { rows, failures: rows.filter(({ verdict }) => verdict !== 'ok').length };
}
