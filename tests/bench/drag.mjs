// SPDX-License-Identifier: MIT
// `npm run bench -- --drag [MODEL...] [--tolerance 0.005] [--steps 30]`: what a step takes while a ring of 2,000 triangles
// is dragged through a model, from which it is taken off: milliseconds of processor time in WebAssembly, beside a new
// operation, whose bytes must be the same.
import { writeFileSync } from 'node:fs';
import { builders } from '../../scripts/build.mjs';
import { commandLine, contentOf, median, modelFiles, nameOf, printTable } from './shared.mjs';

const options = commandLine({
  tolerance: { type: 'string', default: '0.005' },
  steps: { type: 'string', default: '30' },
});
const steps = Number(options.steps);
builders.package();
const { load } = await import('../../dist/index.js');
const { torus } = await import('../js/support/meshes.js');
const kdm = await load({ threads: 1 });

const kinds = {
  'rough (manifold)': { strict: 'manifold', reduce: false },
  embedded: { strict: 'embedded', reduce: false },
  reduced: {},
};

/** Processor time of this process: others may be busy as well. */
function timed(work) {
  const start = process.cpuUsage();
  const result = work();
  const { user, system } = process.cpuUsage(start);
  return { result, milliseconds: (user + system) / 1000 };
}

const same = (a, b) => a.length === b.length && a.every((value, i) => value === b[i]);

function rowOf(file, kind) {
  const model = kdm.parseMesh(...contentOf(file));
  const { min, max } = kdm.describe(model).bounds;
  const size = Math.hypot(...max.map((x, k) => x - min[k]));
  const ring = torus(50, 20);
  const at = (step) => {
    // Along the longest diagonal of the box, through its middle third, a thirtieth of the ring at a time.
    const along = 1 / 3 + step / (3 * steps);
    const scale = size / 30;
    const place = min.map((x, k) => x + along * (max[k] - x));
    return [scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0, ...place, 1];
  };
  const settings = { relativeTolerance: Number(options.tolerance), ...kinds[kind] };
  const scene = kdm.booleanScene('difference', [model, ring], settings);
  const first = timed(() => scene.update(1, at(0)));
  const updates = [];
  const anew = [];
  let equal = true;
  for (let step = 1; step <= steps; ++step) {
    const update = timed(() => scene.update(1, at(step)));
    const fresh = kdm.booleanScene('difference', [model, ring], {
      ...settings,
      transforms: [null, at(step)],
    });
    const full = timed(() => fresh.make());
    fresh.delete();
    for (const name of ['positions', 'indices', 'sourceFaces']) {
      equal &&= same(update.result[name], full.result[name]);
    }
    updates.push(update.milliseconds);
    anew.push(full.milliseconds);
  }
  scene.delete();
  const [a, b] = [model, ring].map(({ indices }) => indices.length / 3);
  return {
    model: nameOf(file),
    kind,
    from: `${a} + ${b}`,
    to: first.result.indices.length / 3,
    'first ms': Math.round(first.milliseconds),
    'update ms': Math.round(median(updates)),
    'worst ms': Math.round(Math.max(...updates)),
    'anew ms': Math.round(median(anew)),
    bytes: equal ? 'the same' : 'DIFFERENT',
  };
}

const files = modelFiles(options.models, []);
if (files.length === 0) {
  console.error('bench: --drag needs models, such as armadillo_86k.ply');
  process.exit(2);
}
const rows = files.flatMap((file) => Object.keys(kinds).map((kind) => rowOf(file, kind)));
printTable(rows);
if (options.json) writeFileSync(options.json, JSON.stringify(rows, null, 2));
if (rows.some(({ bytes }) => bytes !== 'the same')) process.exit(1);
