// SPDX-License-Identifier: MIT
// `npm run bench -- --whole [MODEL...] [--soups] [--tolerance 0.002] [--repeat 5]`: the conversion that users get, file
// by file, or for scenes of many loose parts, by the native command line: whether the result is 2-manifold and embedded,
// and welds by position to a 2-manifold mesh when it is written as STL; area lost; how far result and input are from
// each other, both ways, in tolerances; processor time of the whole process, and how much of it goes into making the
// result embedded.
import { join } from 'node:path';
import { builders } from '../../scripts/build.mjs';
import {
  buildTools,
  commandLine,
  convert,
  measure,
  median,
  modelFiles,
  nameOf,
  printTable,
  withFolder,
} from './shared.mjs';
import { writeSoups } from './soups.mjs';

const options = commandLine({
  tolerance: { type: 'string', default: '0.002' },
  repeat: { type: 'string', default: '5' },
  soups: { type: 'boolean', default: false },
});
builders.native();
const tools = buildTools(['kdm_measure']);
const converted = (file, result, ...args) =>
  convert(file, result, ['--relative-tolerance', options.tolerance, ...args]);

const share = (value) => (value === undefined ? '' : `${Number((100 * value).toPrecision(2))} %`);
const times = (value) => Number(value.toPrecision(3));

function rowOf(file, folder) {
  const result = join(folder, 'result.stl');
  const { report, refused } = converted(file, result, '--check');
  if (refused !== undefined) return { model: nameOf(file), refused };
  const welded = measure(tools, result, undefined, ['--weld']);
  // In turn, so that a busy machine hurts both alike.
  const seconds = { embedded: [], manifold: [] };
  for (let i = 0; i < Number(options.repeat); ++i) {
    for (const strict of ['embedded', 'manifold']) {
      seconds[strict].push(converted(file, result, '--strict', strict).seconds);
    }
  }
  const whole = median(seconds.embedded);
  const { tolerance } = report.grid;
  const { input, output, error, lost } = report;
  return {
    model: nameOf(file),
    faces: input.triangles,
    triangles: output.triangles,
    '2-manifold': output.twoManifold,
    crossings: output.selfIntersections,
    'zero area': output.degenerateFaces ?? 0,
    'STL welds': welded.twoManifold,
    lost: share(lost?.share),
    'to input': times(error.toInput.largest / tolerance),
    'rms ': times(error.toInput.rms / tolerance),
    'to output': times(error.toOutput.largest / tolerance),
    rms: times(error.toOutput.rms / tolerance),
    seconds: times(whole),
    embedding: share(1 - median(seconds.manifold) / whole),
    warnings: report.warnings.map(({ code }) => code).join(' '),
  };
}

const rows = await withFolder((folder) =>
  (options.soups ? writeSoups(folder) : modelFiles(options.models, ['../shared/data'])).map(
    (file) => rowOf(file, folder),
  ),
);
printTable(rows.filter((row) => row.refused === undefined));
for (const { model, refused } of rows)
  if (refused !== undefined) console.log(`${model}: ${refused}`);
