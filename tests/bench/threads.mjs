// SPDX-License-Identifier: MIT
// `npm run bench -- --threads [MODEL...] [--tolerance 0.002] [--threads 2] [--repeat 5]`: what threads are worth in
// WebAssembly, in Node: seconds of one and of several for the same conversion, in turn, and whether bytes are the same.
import { builders } from '../../scripts/build.mjs';
import { commandLine, contentOf, median, modelFiles, nameOf, printTable } from './shared.mjs';

const options = commandLine({
  tolerance: { type: 'string', default: '0.002' },
  threads: { type: 'string', default: '2' },
  repeat: { type: 'string', default: '5' },
});
builders.package();
const { close, load, makeManifold, preload } = await import('../../dist/index.js');
const kdm = await load({ threads: 1 });
const several = Number(options.threads);

const same = (a, b) => a.length === b.length && a.every((value, i) => value === b[i]);
const rounded = (seconds) => Number(seconds.toPrecision(3));

/** The conversion by a worker that is ready: its result, and how long it took. */
async function timed(model, threads) {
  await preload({ threads });
  const start = performance.now();
  const { mesh, report } = await makeManifold(model, {
    relativeTolerance: Number(options.tolerance),
    threads,
  });
  const seconds = (performance.now() - start) / 1000;
  if (report.threads !== threads) throw new Error(`${report.threads} threads, not ${threads}`);
  return { mesh, seconds, peakBytes: report.peakBytes };
}

async function rowOf(file) {
  const model = kdm.parseMesh(...contentOf(file));
  const runs = { alone: [], shared: [] };
  let equal = true;
  let peaks = [];
  // In turn, so that a busy machine hurts both alike.
  for (let i = 0; i < Number(options.repeat); ++i) {
    const [alone, shared] = [await timed(model, 1), await timed(model, several)];
    runs.alone.push(alone.seconds);
    runs.shared.push(shared.seconds);
    peaks = [alone.peakBytes, shared.peakBytes].map((bytes) => Math.round(bytes / 2 ** 20));
    for (const name of ['positions', 'indices', 'sourceFaces']) {
      equal &&= same(alone.mesh[name], shared.mesh[name]);
    }
  }
  await close(); // memory never shrinks: the next model's workers begin anew
  const ratios = runs.alone.map((seconds, i) => seconds / runs.shared[i]);
  return {
    model: nameOf(file),
    faces: model.indices.length / 3,
    '1 thread': rounded(median(runs.alone)),
    [`${several} threads`]: rounded(median(runs.shared)),
    ratio: rounded(median(ratios)),
    MB: peaks.join(', '),
    bytes: equal ? 'the same' : 'DIFFERENT',
  };
}

const rows = [];
for (const file of modelFiles(options.models, ['../shared/data'])) rows.push(await rowOf(file));
printTable(rows);
