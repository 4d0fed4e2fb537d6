// SPDX-License-Identifier: MIT
// `npm run figures -- DIR [--judge COMMAND]`: every closed model of the folder, natively and in
// WebAssembly, at depths 12, 18 and 24 by every rule; see figures.cpp. The two must agree byte for
// byte. A further judge gets each result as an OBJ file and must print JSON with `two_manifold`.
import { createHash } from 'node:crypto';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { extname, join } from 'node:path';
import { builders } from '../../scripts/build.mjs';
import { output, tryRun } from '../../scripts/run.mjs';
import { buildTools, commandLine, median, modelFiles, nameOf } from './shared.mjs';

const options = commandLine({ judge: { type: 'string' } });
if (options.models.length === 0) {
  console.error('figures: name a folder of models');
  process.exit(2);
}
const files = modelFiles(options.models, []);
const tools = buildTools();
builders.wasm();
builders.package();
const { runWasm } = await import('./engines.mjs');
const { load } = await import('../../dist/index.js');
const kdm = await load();

const folder = mkdtempSync(join(tmpdir(), 'kdm-figures-'));
let failures = 0;
try {
  const report = join(folder, 'native.json');
  const native = tryRun(join(tools, 'kdm_figures'), [
    ...['--models', ...files, '--json', report, '--keep', folder],
  ]);
  failures += native.status === 0 ? 0 : 1;
  const rows = JSON.parse(readFileSync(report, 'utf8'));
  console.log('\nWebAssembly against native, byte for byte:');
  for (const row of rows.filter(({ figure }) => figure === 'manifold')) await compareOne(row);
  const speed = rows.find(({ figure }) => figure === 'seconds');
  if (speed !== undefined) await compareSpeed(speed);
  console.log(failures === 0 ? 'all figures hold' : `${failures} failures`);
} finally {
  rmSync(folder, { recursive: true });
}
process.exitCode = failures === 0 ? 0 : 1;

async function compareOne({ model, strategy, depth }) {
  const { mesh } = await runWasm(...source(model), { strategy, depth });
  const own = kdm.formatMesh(mesh, 'obj');
  const stem = nameOf(model).replace(/\.[^.]*$/, '');
  const path = join(folder, `${stem}_${strategy}_${depth}.obj`);
  const same = hash(own) === hash(readFileSync(path));
  let verdict = same ? 'same bytes' : 'DIFFERENT BYTES';
  failures += same ? 0 : 1;
  if (options.judge !== undefined) {
    if (!same) writeFileSync(path, own);
    const judged = JSON.parse(output(options.judge, [path, '--no-self', '--json']));
    failures += judged.two_manifold ? 0 : 1;
    verdict += judged.two_manifold
      ? ', 2-manifold for the judge'
      : ', NOT 2-manifold for the judge';
  }
  console.log(`  ${model.padEnd(24)} ${strategy.padEnd(8)} ${depth}  ${verdict}`);
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
  const file = files.find((path) => nameOf(path) === model);
  return [readFileSync(file), extname(file).slice(1).toLowerCase()];
}

function hash(bytes) {
  return createHash('sha256').update(bytes).digest('hex');
}
