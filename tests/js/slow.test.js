// SPDX-License-Identifier: MIT
// The tests that `npm test -- quick` leaves out are there: a name that nothing has any more would
// bring its test back into the quick set, and nobody would see why it became slow.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './support/paths.js';

const slow = JSON.parse(readFileSync(join(root, 'tests/slow.json'), 'utf8'));

const folder = join(root, 'tests/cpp');
const sources = readdirSync(folder, { recursive: true })
  .filter((name) => name.endsWith('_test.cpp'))
  .map((name) => readFileSync(join(folder, name), 'utf8'))
  .join('\n');

test.each(slow.cpp)('%s is a test in C++', (name) => {
  // Instances of a parametrised test have their prefix before it and their name behind it.
  const [suite, title] = name.replace(/^\w+\/|\/\*$/g, '').split('.');
  expect(sources).toMatch(new RegExp(`TEST(?:_P|_F)?\\(${suite},\\s*${title}\\)`));
});

test.each(slow.js)('%s is a file of tests in JavaScript', (name) => {
  expect(existsSync(join(root, `tests/js/${name}.test.js`))).toBe(true);
});
