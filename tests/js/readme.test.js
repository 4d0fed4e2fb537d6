// SPDX-License-Identifier: MIT
// Every block of the README runs.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));
const folder = `${root}build/readme`;
const readme = readFileSync(`${root}README.md`, 'utf8');
const blocks = (language) =>
  [...readme.matchAll(new RegExp(`^\`\`\`${language}\n([\\s\\S]*?)^\`\`\``, 'gm'))].map(
    (m) => m[1],
  );

const cube = `
const positions = new Float32Array([0,0,0, 1,0,0, 0,1,0, 1,1,0, 0,0,1, 1,0,1, 0,1,1, 1,1,1]);
const indices = new Uint32Array([0,2,1, 1,2,3, 4,5,6, 5,7,6, 0,1,4, 1,5,4, 2,6,3, 3,6,7, 0,4,2,
  2,4,6, 1,3,5, 3,7,5]);
`;
const cubeObj = `v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1
f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n`;

beforeAll(() => {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  writeFileSync(`${folder}/part.obj`, cubeObj);
});

test.each(blocks('js').map((block, i) => [i, block]))('JavaScript block %i', (i, block) => {
  const file = `${folder}/block${i}.mjs`;
  const report = block.includes('report') ? 'console.log(report.output.twoManifold);' : '';
  writeFileSync(file, `${cube}${block}\n${report}\nconsole.log('done');`);
  const printed = execFileSync(process.execPath, [file], { cwd: folder, encoding: 'utf8' });
  expect(printed).toBe(report ? 'true\ndone\n' : 'done\n');
});

test.each(blocks('sh'))('shell block %#', (block) => {
  const command = block.trim().replace(/^npx kdmanifold/, `${process.execPath} ${root}dist/cli.js`);
  execFileSync('sh', ['-c', command], { cwd: folder });
  expect(existsSync(`${folder}/part-clean.obj`)).toBe(true);
});

test.each(blocks('cpp'))('C++ block %#', (block) => {
  rmSync(`${folder}/part-clean.obj`, { force: true });
  writeFileSync(`${folder}/block.cpp`, block);
  const build = `${root}build/release`;
  const flags = ['-std=c++20', `-I${root}src/include`, `-I${build}/include`];
  const eigen = ['-isystem', '/usr/include/eigen3'];
  const program = `${folder}/block`;
  const library = `${build}/libkdmanifold.a`;
  execFileSync('g++', [...flags, ...eigen, `${folder}/block.cpp`, library, '-o', program]);
  execFileSync(program, [], { cwd: folder });
  expect(readFileSync(`${folder}/part-clean.obj`, 'utf8').match(/^f /gm)).toHaveLength(12);
});

test('has blocks of every kind', () => {
  expect([blocks('js').length, blocks('sh').length, blocks('cpp').length]).toEqual([12, 1, 1]);
});
