// SPDX-License-Identifier: MIT
// Every closed model, natively and in WebAssembly, at depths 12, 18 and 24 by every rule; see
// figures.cpp. The two must agree byte for byte, and the judge must find each result 2-manifold.
import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { load } from '../../../dist/index.js';
import { output, tryRun } from '../../../scripts/run.mjs';
import { runWasm } from '../../bench/engines.mjs';
import { contentOf, median, nameOf } from '../../bench/shared.mjs';

export default async function manifold({ files, tools, folder, judge }) {
  const kdm = await load();
  const report = join(folder, 'native.json');
  const native = tryRun(join(tools, 'kdm_figures'), [
    ...['--models', ...files, '--json', report, '--keep', folder],
  ]);
  let failures = native.status === 0 ? 0 : 1;
  const rows = JSON.parse(readFileSync(report, 'utf8'));
  console.log('\nWebAssembly against native, byte for byte:');
  for (const row of rows.filter(({ figure }) => figure === 'manifold')) {
    failures += await compareOne(row);
  }
  const speed = rows.find(({ figure }) => figure === 'seconds');
  if (speed !== undefined) await compareSpeed(speed);
  return { rows, failures };

  async function compareOne({ model, strategy, depth }) {
    const { mesh } = await runWasm(...source(model), { strategy, depth });
    const own = kdm.formatMesh(mesh, 'obj');
    const stem = nameOf(model).replace(/\.[^.]*$/, '');
    const path = join(folder, `${stem}_${strategy}_${depth}.obj`);
    const same = hash(own) === hash(readFileSync(path));
    let verdict = same ? 'same bytes' : 'DIFFERENT BYTES';
    let found = same ? 0 : 1;
    if (judge !== undefined) {
      if (!same) writeFileSync(path, own);
      const judged = JSON.parse(output(judge, [path, '--no-self', '--json']));
      found += judged.two_manifold ? 0 : 1;
      verdict += judged.two_manifold
        ? ', 2-manifold for the judge'
        : ', NOT 2-manifold for the judge';
    }
    console.log(`  ${model.padEnd(24)} ${strategy.padEnd(8)} ${depth}  ${verdict}`);
    return found;
  }

  async function compareSpeed({ model, seconds }) {
    const runs = [];
    for (let i = 0; i < 5; ++i) {
      runs.push((await runWasm(...source(model), { strategy: 'median', depth: 19 })).seconds);
    }
    console.log(`\nseconds on ${model} by median at depth 19, median of five: native, WebAssembly`);
    for (const stage of Object.keys(seconds)) {
      const own = median(runs.map((one) => one[stage] ?? 0));
      console.log(`  ${stage.padEnd(9)} ${seconds[stage].toFixed(4)}  ${own.toFixed(4)}`);
    }
  }

  function source(model) {
    return contentOf(files.find((path) => nameOf(path) === model));
  }
}

function hash(bytes) {
  return createHash('sha256').update(bytes).digest('hex');
}
