// SPDX-License-Identifier: MIT
// Extraction alone: triangles a second, natively and in WebAssembly, and the share of its phases
// natively. Medians of five; nothing to hold.
import { runWasm } from '../../bench/engines.mjs';
import {
  closedModels,
  contentOf,
  median,
  nameOf,
  native,
  printTable,
  sizes,
} from '../../bench/shared.mjs';

const phases = ['loops', 'vertices', 'faces'];
const repeat = 5;

export default async function extraction({ tools, folder, find }) {
  const rows = [];
  for (const file of find(closedModels)) {
    for (const { name, options } of sizes) {
      const own = native(tools, folder, file, options, { repeat });
      const wasm = await inWasm(file, options);
      const seconds = extractionSeconds(own.seconds);
      const triangles = wasm.triangles;
      rows.push({
        model: nameOf(file),
        setting: name,
        triangles,
        'native, million/s': rate(triangles, seconds),
        'WebAssembly, million/s': rate(triangles, wasm.seconds),
        ...Object.fromEntries(
          phases.map((phase) => [phase, percent((own.seconds[phase] ?? 0) / seconds)]),
        ),
      });
    }
  }
  console.log('triangles a second of extraction; phases: shares of its native time');
  printTable(rows);
  return { rows, failures: 0 };
}

async function inWasm(file, options) {
  const content = contentOf(file);
  const seconds = [];
  let triangles = 0;
  for (let i = 0; i < repeat; ++i) {
    const run = await runWasm(...content, options);
    seconds.push(extractionSeconds(run.seconds));
    triangles = run.mesh.indices.length / 3;
  }
  return { triangles, seconds: median(seconds) };
}

// What comes before the first phase is its own, in WebAssembly also the copy of the result.
function extractionSeconds(seconds) {
  return ['extract', ...phases].reduce((sum, phase) => sum + (seconds[phase] ?? 0), 0);
}

const rate = (count, seconds) => (count / seconds / 1e6).toFixed(2);
const percent = (part) => `${(100 * part).toFixed(0)} %`;
