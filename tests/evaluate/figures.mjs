// SPDX-License-Identifier: MIT
// `npm run figures -- DIR [--section NAME]... [--judge COMMAND] [--json FILE] [--out DIR]`
// What must hold, and how far it goes, on the models of a folder. Sections: manifold (the default),
// embedded, pairing, extraction, quality, comparison, corner, slope, memory, repair, damage, hostile,
// solids, figure13 to figure16; paper for these four, or all. Each is a file in `figures/`.
// With `--out` the paper's figures leave their meshes in a folder, and pictures of them side by side.
// The judge is a further program that knows nothing of the library: it gets a mesh file (and
// `--ref INPUT`) and prints JSON. Exit status 1 if a figure does not hold.
import { mkdirSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { builders } from '../../scripts/build.mjs';
import { buildTools, commandLine, modelFiles, nameOf, withFolder } from '../bench/shared.mjs';

const paper = ['figure13', 'figure14', 'figure15', 'figure16'];
const sections = [
  'manifold',
  'embedded',
  'pairing',
  'extraction',
  'quality',
  'comparison',
  'corner',
  'slope',
  'memory',
  'repair',
  'damage',
  'hostile',
  'solids',
  ...paper,
];
const options = commandLine({
  section: { type: 'string', multiple: true, default: ['manifold'] },
  judge: { type: 'string' },
  out: { type: 'string' },
});
const groups = { all: sections, paper };
const wanted = [...new Set(options.section.flatMap((name) => groups[name] ?? [name]))];
const unknown = wanted.find((name) => !sections.includes(name));
if (unknown !== undefined || options.models.length === 0) {
  console.error(
    unknown === undefined
      ? 'figures: name a folder of models'
      : `figures: unknown section '${unknown}' (${[...sections, ...Object.keys(groups)].join(', ')})`,
  );
  process.exit(2);
}

const files = modelFiles(options.models, []);
const tools = buildTools();
builders.package();
// Seconds are those of one thread, in all sections: the first call decides.
const { load } = await import('../../dist/index.js');
await load({ threads: 1 });
const out =
  options.out === undefined
    ? undefined
    : resolve(process.env.INIT_CWD ?? process.cwd(), options.out);
if (out !== undefined) mkdirSync(out, { recursive: true });

let failures = 0;
const report = {};
for (const section of wanted) {
  console.log(`== ${section}`);
  const { default: run } = await import(`./figures/${section}.mjs`);
  const result = await withFolder((folder) =>
    run({ files, tools, folder, judge: options.judge, find, out }),
  );
  failures += result.failures;
  report[section] = result.rows;
}
if (options.json !== undefined) writeFileSync(options.json, JSON.stringify(report, null, 1) + '\n');
console.log(failures === 0 ? 'all figures hold' : `${failures} failures`);
process.exitCode = failures === 0 ? 0 : 1;

/** The files of these names (scenes stay as they are); one that is missing is a failure. */
function find(names) {
  return names.flatMap((name) => {
    if (name.startsWith('scene:')) return [name];
    const file = files.find((path) => nameOf(path) === name);
    if (file !== undefined) return [file];
    console.log(`${name} is MISSING among the models`);
    ++failures;
    return [];
  });
}
