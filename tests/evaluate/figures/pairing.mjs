// SPDX-License-Identifier: MIT
// All pairing modes on closed models: each result must be closed, oriented and strictly 2-manifold.
// The verdict is the library's own, and the judge's, if there is one. Only `trace` looks at the
// input; how many parts and handles the others make is a figure, not a fault.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { load } from '../../../dist/index.js';
import { output } from '../../../scripts/run.mjs';
import { closedModels, contentOf, nameOf, printTable, sizes } from '../../bench/shared.mjs';

const pairings = ['trace', 'hermite', 'inside', 'outside'];

export default async function pairing({ folder, judge, find }) {
  const kdm = await load();
  const rows = [];
  for (const file of find(closedModels)) {
    const input = kdm.parseMesh(...contentOf(file));
    for (const { name, options } of sizes) {
      const results = pairings.map((mode) => extracted(kdm, input, { ...options, pairing: mode }));
      rows.push(row(nameOf(file), name, results));
    }
  }
  console.log(`parts and Euler characteristic by ${pairings.join(', ')}`);
  printTable(rows);
  return { rows, failures: rows.filter(({ verdict }) => verdict !== 'ok').length };

  function extracted(module, input, options) {
    const grid = module.buildGrid(input, options);
    const mesh = grid.extract();
    grid.delete();
    const found = module.describe(mesh);
    const result = {
      parts: found.components,
      euler: found.eulerCharacteristic,
      sound: found.twoManifold && found.closed,
    };
    if (judge === undefined) return result;
    const path = join(folder, 'paired.obj');
    writeFileSync(path, module.formatMesh(mesh, 'obj'));
    const judged = JSON.parse(output(judge, [path, '--no-self', '--json']));
    return { ...result, sound: result.sound && judged.two_manifold && judged.closed_oriented };
  }
}

function row(model, setting, results) {
  const bad = pairings.filter((_, i) => !results[i].sound);
  return {
    model,
    setting,
    ...Object.fromEntries(pairings.map((mode, i) => [mode, topology(results[i])])),
    verdict: bad.length === 0 ? 'ok' : `FAILS: ${bad.join(', ')} not 2-manifold`,
  };
}

const topology = ({ parts, euler }) => `${parts}, ${euler}`;
