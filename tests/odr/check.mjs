// SPDX-License-Identifier: MIT
// `node tests/odr/check.mjs BUILD`: what the object files of a build folder define differently.
import { readFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { output } from '../../scripts/run.mjs';
import { differingDefinitions } from './definitions.mjs';

const build = process.argv[2];
const commands = JSON.parse(readFileSync(join(build, 'compile_commands.json'), 'utf8'));
const sources = new Map(
  commands.map(({ command, file }) => [
    join(build, command.match(/ -o (\S+)/)[1]),
    relative('.', file),
  ]),
);
// Headers that are compiled ahead are listed too; nothing of theirs is linked.
const objects = [...sources.keys()].filter((path) => path.endsWith('.o'));
const found = differingDefinitions(objects, 'kdm');
for (const { name, files } of found) {
  const places = files.map((path) => sources.get(path)).join(', ');
  console.log(`${output('c++filt', [name]).trim()} is defined differently in ${places}`);
}
console.log(`${objects.length} object files, ${found.length} names with different definitions`);
process.exitCode = found.length === 0 ? 0 : 1;
