// SPDX-License-Identifier: MIT
// The paper's figure 13: the Dragon's grid is made smaller by removing splits, without any change of topology: at almost
// no error, and with as much error as leaves the paper's 22,227 triangles. Parts and Euler characteristic must stay, and
// the surface near to what it was: within one and a half times of what is allowed it and of the tolerance, as README
// says of all distances, since vertices that `extract` adds are not tested when splits are removed.
import { join } from 'node:path';
import { load } from '../../../dist/index.js';
import { builders } from '../../../scripts/build.mjs';
import { contentOf, convert, measure, nameOf, printTable, twoSided } from '../../bench/shared.mjs';
import { drawBeside } from '../picture.mjs';
import { verdictOf } from '../verdict.mjs';

const models = ['dragon_48k.ply', 'dragon_202k.ply'];
const relativeTolerance = 0.001;
const almostNothing = 1e-5; // of the diagonal, as all errors here
const wanted = 22227;
const nearEnough = 0.005;
const beyond = 1.5;

export default async function figure13({ tools, folder, find, out }) {
  builders.native();
  const kdm = await load();
  const rows = [];
  for (const file of find(models)) {
    const stem = join(out ?? folder, `figure13_${nameOf(file).replace(/\..*$/, '')}`);
    const meshes = makeMeshes(file, stem, join(folder, 'whole.kdgrid'));
    const [whole] = meshes.map(({ path }) => path);
    const own = meshes.map((made) => rowOf(tools, file, made, whole));
    for (const row of own) row.verdict = verdictOn(row, own[0]);
    rows.push(...own);
    if (out !== undefined) await show(kdm, file, stem, meshes);
  }
  console.log('errors and distances: % of the diagonal, the largest and the root mean square');
  printTable(rows.map(shown));
  return { rows, failures: rows.filter(({ verdict }) => verdict !== 'ok').length };
}

/** What is built, at almost no error, and at the number of triangles. */
function makeMeshes(file, stem, grid) {
  const make = (input, name, error, args) => {
    const path = `${stem}_${name}.ply`;
    const made = convert(input, path, ['--no-reduce', '--threads', '1', ...args]);
    if (made.refused !== undefined) throw new Error(`${input}: ${made.refused}`);
    return { path, error, ...made };
  };
  const whole = make(file, 'whole', 0, [
    ...['--relative-tolerance', String(relativeTolerance), '--save-grid', grid],
  ]);
  const diagonal = whole.report.grid.askedTolerance / relativeTolerance;
  const simplified = (name, error) =>
    make(grid, name, error, ['--simplify', String(error * diagonal)]);
  const fine = simplified('fine', almostNothing);
  return [whole, fine, searched((error) => simplified('coarse', error))];
}

/** The run that comes near to the wanted number of triangles; the more error, the fewer. */
function searched(run) {
  let [low, high] = [almostNothing, 0.01];
  for (let i = 0; ; ++i) {
    const error = Math.sqrt(low * high);
    const made = run(error);
    const { triangles } = made.report.output;
    if (i === 15 || Math.abs(triangles / wanted - 1) <= nearEnough) return made;
    if (triangles > wanted) low = error;
    else high = error;
  }
}

function rowOf(tools, file, { path, error, report, seconds }, whole) {
  const { grid, output } = report;
  const judged = measure(tools, path, file);
  const moved = error === 0 ? 0 : twoSided(measure(tools, path, whole, ['--no-check'])).max;
  const { triangles, components, eulerCharacteristic, twoManifold } = judged;
  return {
    ...{ model: nameOf(file), error, moved, leaves: grid.leaves, triangles, components },
    ...{ eulerCharacteristic, twoManifold, crossings: output.crossings, seconds },
    toInput: judged.toReference,
    fromInput: judged.fromReference,
  };
}

function verdictOn(row, whole) {
  const faults = [];
  if (!row.twoManifold) faults.push('not 2-manifold');
  if (row.crossings > 0) faults.push(`${row.crossings} pairs cross`);
  if (row.components !== whole.components) faults.push('parts');
  if (row.eulerCharacteristic !== whole.eulerCharacteristic) faults.push('handles');
  if (row.moved > beyond * (row.error + relativeTolerance)) faults.push('moved too far');
  const coarse = row.error > almostNothing;
  if (coarse && Math.abs(row.triangles / wanted - 1) > nearEnough) faults.push('triangles');
  return verdictOf(faults);
}

function shown(row) {
  const percent = (part, digits) => (100 * part).toFixed(digits);
  const both = ({ max, rms }) => `${percent(max, 3)} ${percent(rms, 4)}`;
  return {
    model: row.model,
    'error %': percent(row.error, 4),
    'moved %': percent(row.moved, 4),
    leaves: row.leaves,
    triangles: row.triangles,
    parts: row.components,
    euler: row.eulerCharacteristic,
    '2-manifold': row.twoManifold ? 'yes' : 'NO',
    crossings: row.crossings,
    'to input %': both(row.toInput),
    'from input %': both(row.fromInput),
    seconds: row.seconds.toFixed(2),
    verdict: row.verdict,
  };
}

async function show(kdm, file, stem, meshes) {
  const meshOf = (path) => kdm.parseMesh(...contentOf(path));
  const input = { title: `input`, mesh: meshOf(file) };
  const results = meshes.map(({ path, error, report }) => ({
    title: `${error === 0 ? 'as built' : `error ${(100 * error).toPrecision(2)} %`}: ${report.output.triangles} triangles`,
    mesh: meshOf(path),
  }));
  const view = { from: [0.25, 0.3, 1], up: 'y' };
  await drawBeside(`${stem}.png`, [input, ...results], view);
  await drawBeside(`${stem}_edges.png`, [input, ...results], { ...view, lines: true });
}
