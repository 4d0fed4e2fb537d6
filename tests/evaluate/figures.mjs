// SPDX-License-Identifier: MIT
// `npm run figures -- DIR [--section NAME]... [--judge COMMAND] [--json FILE]`
// What must hold, and how far it goes, on the models of a folder. Sections: manifold (the default),
// embedded, pairing, extraction, quality, comparison, corner, slope, memory, repair, damage, hostile,
// solids; or all. Each is a file in `figures/`.
// The judge is a further program that knows nothing of the library: it gets a mesh file (and
// `--ref INPUT`) and prints JSON. Exit status 1 if a figure does not hold.
import { writeFileSync } from 'node:fs';
import { builders } from '../../scripts/build.mjs';
import { buildTools, commandLine, modelFiles, nameOf, withFolder } from '../bench/shared.mjs';

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
];
const options = commandLine({
  section: { type: 'string', multiple: true, default: ['manifold'] },
  judge: { type: 'string' },
});
const wanted = options.section.includes('all') ? sections : options.section;
const unknown = wanted.find((name) => !sections.includes(name));
if (unknown !== undefined || options.models.length === 0) {
  console.error(
    unknown === undefined
      ? 'figures: name a folder of models'
      : `figures: unknown section '${unknown}' (${sections.join(', ')}, all)`,
  );
  process.exit(2);
}

const files = modelFiles(options.models, []);
const tools = buildTools();
builders.package();

let failures = 0;
const report = {};
for (const section of wanted) {
  console.log(`== ${section}`);
  const { default: run } = await import(`./figures/${section}.mjs`);
  const result = await withFolder((folder) =>
    run({ files, tools, folder, judge: options.judge, find }),
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
