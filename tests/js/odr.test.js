// SPDX-License-Identifier: MIT
// The check of `npm test -- odr` on small sources: it must find what differs, and nothing else.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { differingDefinitions } from '../odr/definitions.mjs';
import { execute, withFolder } from './support/paths.js';

/** What is found in two object files, of which each has one of these definitions and uses it. */
const findings = (definitions, use) =>
  withFolder((folder) => {
    const objects = definitions.map((definition, i) => {
      const [source, object] = ['cpp', 'o'].map((ending) => join(folder, `${i}.${ending}`));
      // What comes before moves everything in the file, which makes no difference.
      const before = i === 0 ? '' : 'const char* before() { return "before"; }';
      writeFileSync(source, `${before}\n${definition}\nauto use${i}(int x) { ${use} }\n`);
      const flags = ['-std=c++20', '-O0', '-Wa,--keep-locals', '-c'];
      expect(execute('g++', [...flags, source, '-o', object])).toMatchObject({ stderr: '' });
      return object;
    });
    const found = differingDefinitions(objects, 'kdm');
    return execute('c++filt', [found.map(({ name }) => name).join('\n')]).stdout.trim();
  });

const inKdm = (...texts) => texts.map((text) => `namespace kdm { ${text} }`);
const alike = [
  ['functions', 'inline double f(int x) { return x * 2.5; }', 'return kdm::f(x);'],
  [
    'constants',
    'constexpr double k[] = {1, 2}; inline double f(int i) { return k[i]; }',
    'return kdm::f(x);',
  ],
  ['templates', 'template <class T> T f(T x) { return x + 1; }', 'return kdm::f(x);'],
  ['words', 'inline const char* f(int x) { return x ? "one" : "two"; }', 'return kdm::f(x);'],
  [
    'choices',
    'inline int f(int x) { switch (x) { case 0: return 9; case 1: return 7; case 2: return 3; case 3: return 5; case 4: return 1; default: return 0; } }',
    'return kdm::f(x);',
  ],
  ['classes', 'struct S { virtual int f(int x) { return x; } };', 'return kdm::S().f(x);'],
  [
    'static data',
    'inline int f(int x) { static int sum = 3; return sum += x; }',
    'return kdm::f(x);',
  ],
];

test.each(alike)('equal %s are not reported', async (_, text, use) => {
  expect(await findings(inKdm(text, text), use)).toBe('');
});

test.each([
  [
    'code',
    'inline int f(int x) { return x + x; }',
    'inline int f(int x) { return x * x; }',
    'kdm::f(int)',
  ],
  [
    'a number',
    'inline double f(int x) { return x * 2.5; }',
    'inline double f(int x) { return x * 3.5; }',
    'kdm::f(int)',
  ],
  [
    'a word',
    'inline const char* f(int) { return "one"; }',
    'inline const char* f(int) { return "two"; }',
    'kdm::f(int)',
  ],
  [
    'a callee',
    'int g(); int h(); inline int f(int) { return g(); }',
    'int g(); int h(); inline int f(int) { return h(); }',
    'kdm::f(int)',
  ],
  [
    'a constant',
    'constexpr double k[] = {1, 2}; inline double f(int i) { return k[i]; }',
    'constexpr double k[] = {1, 3}; inline double f(int i) { return k[i]; }',
    'kdm::f(int)',
  ],
  [
    'a template',
    'template <class T> int f(T x) { return x + 1; }',
    'template <class T> int f(T x) { return x + 2; }',
    'int kdm::f<int>(int)',
  ],
  [
    'static data',
    'inline int f(int x) { static int sum = 3; return sum += x; }',
    'inline int f(int x) { static int sum = 4; return sum += x; }',
    'kdm::f(int)::sum',
  ],
])('differences in %s are reported', async (_, first, second, name) => {
  expect(await findings(inKdm(first, second), 'return kdm::f(x);')).toBe(name);
});

test('a member that differs is reported, other namespaces are not', async () => {
  const both = [1, 2].map((n) => `struct S { virtual int f(int x) { return x + ${n}; } };`);
  expect(await findings(inKdm(...both), 'return kdm::S().f(x);')).toBe('kdm::S::f(int)');
  const other = [1, 2].map((n) => `namespace other { inline int f(int x) { return x + ${n}; } }`);
  expect(await findings(other, 'return other::f(x);')).toBe('');
});
