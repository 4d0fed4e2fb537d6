// SPDX-License-Identifier: MIT
// The reference pages: every function has an example that runs, every parameter a text, and no link is broken.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { execute, root } from './support/paths.js';

const folder = join(root, 'build/reference');
let pages;

beforeAll(() => {
  mkdirSync(folder, { recursive: true });
  const json = join(folder, 'api.json');
  const { status, stdout, stderr } = execute(
    join(root, 'node_modules/.bin/typedoc'),
    ['--json', json, '--out', join(folder, 'html')],
    { cwd: root },
  );
  expect({ status, output: status ? stdout + stderr : '' }).toEqual({ status: 0, output: '' });
  pages = JSON.parse(readFileSync(json, 'utf8'));
}, 120_000);

/** All functions and methods, as [name, signature]. */
function* functionsOf(node, path = '') {
  for (const child of node.children ?? []) {
    const name = path === '' ? child.name : `${path}.${child.name}`;
    for (const signature of child.signatures ?? []) {
      // What is Error's is not ours to explain.
      if (child.inheritedFrom === undefined) yield [name, signature];
    }
    yield* functionsOf(child, name);
  }
}

const textOf = (comment) => (comment?.summary ?? []).map(({ text }) => text).join('');

test('every function has an example, every parameter a text', () => {
  const functions = [...functionsOf(pages)].filter(([name]) => !/constructor|dispose/.test(name));
  expect(functions.length).toBeGreaterThan(15);
  const lacking = functions.flatMap(([name, { comment, parameters = [] }]) => [
    ...(comment?.blockTags?.some(({ tag }) => tag === '@example') ? [] : [`${name}: no example`]),
    ...parameters
      .filter((parameter) => textOf(parameter.comment) === '')
      .map((parameter) => `${name}: ${parameter.name} has no text`),
  ]);
  expect(lacking).toEqual([]);
});

const sources = [
  ...['make-manifold', 'load', 'life-cycle', 'library', 'grid'],
  ...['boolean-scene', 'open-boolean-scene'],
];
const examples = sources.flatMap((name) => {
  const text = readFileSync(join(root, `web/src/${name}.ts`), 'utf8');
  return [...text.matchAll(/@example\n((?: *\*.*\n)+?) *\*\//g)].map(([, lines], i) => [
    `${name} ${i}`,
    lines.replace(/^ *\* ?/gm, '').replace(/^```.*$/gm, ''),
  ]);
});
examples.push([
  'docs/start.md',
  /^```js\n([^`]*)/m.exec(readFileSync(join(root, 'docs/start.md'), 'utf8'))[1],
]);

const cube = `
const positions = new Float32Array([0,0,0, 1,0,0, 0,1,0, 1,1,0, 0,0,1, 1,0,1, 0,1,1, 1,1,1]);
const indices = new Uint32Array([0,2,1, 1,2,3, 4,5,6, 5,7,6, 0,1,4, 1,5,4, 2,6,3, 3,6,7, 0,4,2,
  2,4,6, 1,3,5, 3,7,5]);
`;

test.each(examples)('the example of %s runs', (name, code) => {
  const file = join(folder, 'example.mjs');
  writeFileSync(file, cube + code);
  const { status, stdout, stderr } = execute(process.execPath, [file], { cwd: folder });
  expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
  // What an example says that it prints, it prints.
  for (const [, promised] of code.matchAll(/console\.log\(.*\); \/\/ (.*)/g)) {
    expect(stdout).toContain(promised);
  }
});
