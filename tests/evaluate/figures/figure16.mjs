// SPDX-License-Identifier: MIT
// The paper's figure 16: two copies of a model, one turned by ten degrees, are united and a cylinder is taken away; and
// what they have in common. Natively and in WebAssembly, which must give the same bytes, beside manifold-3d in the same
// run: where it takes the input, volumes must agree within 0.1 %. Where it refuses it, it gets copies that this library
// made of the operands, so that there is a volume to look at.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { load } from '../../../dist/index.js';
import { builders } from '../../../scripts/build.mjs';
import { manifold3dBoolean, ownBoolean } from '../../bench/engines.mjs';
import { contentOf, convert, measure, nameOf, printTable } from '../../bench/shared.mjs';
import { turnedTwice } from '../../bench/turned_twice.mjs';
import { drawBeside } from '../picture.mjs';
import { verdictOf } from '../verdict.mjs';

const models = ['armadillo_86k.ply', 'dragon_48k.ply', 'dragon_202k.ply'];
const degrees = 10;
const relativeTolerance = 0.001; // of the model, not of the long cylinder
const volumeLimit = 0.001;

const operations = [
  {
    name: 'united, cylinder off',
    expression: ['difference', ['union', 0, 1], 2],
    flags: ['--union', '--difference'],
    combine: ([a, b, c], keep) => keep(keep(a.add(b)).subtract(c)),
  },
  {
    name: 'intersection',
    expression: 'intersection',
    flags: ['--intersection'],
    combine: ([a, b], keep) => keep(a.intersect(b)),
  },
];

export default async function figure16({ tools, folder, find, out }) {
  builders.native();
  const kdm = await load();
  const rows = [];
  for (const file of find(models)) {
    const { positions, indices } = kdm.parseMesh(...contentOf(file));
    const model = { positions, indices };
    const { bounds } = kdm.describe(model);
    const operands = turnedTwice(model, bounds, degrees);
    const size = Math.hypot(...bounds.max.map((x, k) => x - bounds.min[k]));
    const context = { kdm, tools, folder, file, tolerance: relativeTolerance * size };
    const shown = [{ title: 'the two', mesh: both(operands) }];
    for (const operation of operations) {
      const { row, mesh } = await rowOf(context, operation, operands);
      rows.push(row);
      shown.push({ title: operation.name, mesh });
    }
    if (out !== undefined)
      await show(kdm, join(out, `figure16_${nameOf(file).replace(/\..*$/, '')}`), shown);
  }
  printTable(rows);
  return { rows, failures: rows.filter(({ verdict }) => verdict !== 'ok').length };
}

async function rowOf(context, { name, expression, flags, combine }, all) {
  const { kdm, tools, folder, file, tolerance } = context;
  const operands = all.slice(0, flags.length + 1);
  const paths = operands.map((mesh, i) => write(kdm, join(folder, `operand${i}.ply`), mesh));
  const result = join(folder, 'result.ply');
  const native = convert(paths[0], result, [
    ...flags.flatMap((flag, i) => [flag, paths[i + 1]]),
    ...['--tolerance', String(tolerance), '--no-reduce', '--threads', '1'],
  ]);
  if (native.refused !== undefined) throw new Error(`${file}: ${native.refused}`);
  const { mesh, seconds } = await ownBoolean(operands, expression, { tolerance });
  const sameBytes = Buffer.compare(kdm.formatMesh(mesh, 'ply'), readFileSync(result)) === 0;
  const judged = measure(tools, result);
  const crossings = kdm.findSelfIntersections(mesh).pairs;

  const peer = await manifold3dBoolean(operands, combine);
  const copies =
    peer.refused === undefined ? operands : operands.map((one) => clean(kdm, one, tolerance));
  const other = peer.refused === undefined ? peer : await manifold3dBoolean(copies, combine);
  const volume = other.mesh && kdm.describe(other.mesh).volume;
  const off = volume && judged.volume / volume - 1;

  const faults = [];
  if (!judged.twoManifold) faults.push('not 2-manifold');
  if (crossings > 0) faults.push(`${crossings} pairs cross`);
  if (!sameBytes) faults.push('native and WebAssembly differ');
  if (peer.refused === undefined && Math.abs(off) > volumeLimit) faults.push('volume');
  const row = {
    model: nameOf(file),
    operation: name,
    input: operands.reduce((sum, { indices }) => sum + indices.length / 3, 0),
    triangles: judged.triangles,
    parts: judged.components,
    euler: judged.eulerCharacteristic,
    '2-manifold': judged.twoManifold ? 'yes' : 'NO',
    crossings,
    volume: judged.volume.toPrecision(6),
    'native, s': native.seconds.toFixed(2),
    'WebAssembly, s': seconds.toFixed(2),
    'manifold-3d': peer.refused ?? `${peer.seconds.toFixed(2)} s`,
    'its volume': volume === undefined ? other.refused : volume.toPrecision(6),
    of: peer.refused === undefined ? 'the input' : 'our copies',
    'off %': off === undefined ? '' : (100 * off).toFixed(3),
    verdict: verdictOf(faults),
  };
  console.log(`${row.model} ${name}: ${row.verdict}`);
  return { row, mesh };
}

function write(kdm, path, mesh) {
  writeFileSync(path, kdm.formatMesh(mesh, 'ply'));
  return path;
}

function clean(kdm, mesh, tolerance) {
  const grid = kdm.buildGrid(mesh, { tolerance });
  try {
    return grid.extract({ strict: 'embedded' });
  } finally {
    grid.delete();
  }
}

/** The model and its turned copy in one mesh. */
function both([a, b]) {
  const positions = new Float32Array(a.positions.length + b.positions.length);
  positions.set(a.positions);
  positions.set(b.positions, a.positions.length);
  const indices = new Uint32Array(a.indices.length + b.indices.length);
  indices.set(a.indices);
  indices.set(
    b.indices.map((index) => index + a.positions.length / 3),
    a.indices.length,
  );
  return { positions, indices };
}

async function show(kdm, stem, shown) {
  for (const { title, mesh } of shown.slice(1)) {
    write(kdm, `${stem}_${title.replace(/\W+/g, '_')}.ply`, mesh);
  }
  await drawBeside(`${stem}.png`, shown, { from: [0.25, 0.3, 1], up: 'y' });
}
