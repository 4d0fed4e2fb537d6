// SPDX-License-Identifier: MIT
// Scripts start on bare machines: what set-up installs is not there yet when their modules are
// loaded, so loading them must neither need it nor decide anything by its absence.
import { mkdirSync, readFileSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { pathToFileURL } from 'node:url';
import { emscriptenEnvironment } from '../../scripts/build.mjs';
import { execute, root, withFolder } from './support/paths.js';

const { scripts } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));

/** What a module imports before its first line runs, as it is written there. */
const importsOf = (module) =>
  [...readFileSync(module, 'utf8').matchAll(/^import\s(?:[^'"]*\sfrom\s)?'([^']+)'/gm)].map(
    ([, name]) => name,
  );

/** The script of every npm command, and all modules that are loaded with them. */
const entries = Object.values(scripts).map((command) => join(root, command.split(' ')[1]));
const loaded = new Set(entries);
for (const module of loaded) {
  for (const name of importsOf(module)) {
    if (name.startsWith('.')) loaded.add(join(dirname(module), name));
  }
}
const title = (module) => relative(root, module);

test.each([...loaded].map((module) => [title(module), module]))(
  '%s imports no package at its top',
  (_, module) => {
    expect(importsOf(module).filter((name) => !/^(node:|\.)/.test(name))).toEqual([]);
  },
);

// Modules that others import; the rest are programs, which set up first of all.
const shared = new Set(
  [...loaded].flatMap((module) => importsOf(module).map((name) => join(dirname(module), name))),
);

test.each([...loaded].filter((module) => shared.has(module)).map((m) => [title(m), m]))(
  '%s looks at no file and runs nothing while it is loaded',
  (_, module) => {
    const watch = `
      import fs from 'node:fs';
      import processes from 'node:child_process';
      import { syncBuiltinESMExports } from 'node:module';
      const forbid = (api, name) => {
        api[name] = (...args) => {
          throw new Error(name + ' ' + String(args[0]));
        };
      };
      for (const name of ['existsSync', 'statSync', 'readFileSync', 'readdirSync']) forbid(fs, name);
      for (const name of ['spawn', 'spawnSync', 'execFileSync']) forbid(processes, name);
      syncBuiltinESMExports();
      await import(${JSON.stringify(pathToFileURL(module).href)});`;
    const { status, stderr } = execute(process.execPath, [
      '--input-type=module',
      '-e',
      watch,
      'nobody',
    ]);
    expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
  },
);

test('Emscripten is shown an acorn that was installed a moment ago', () =>
  withFolder((folder) => {
    expect(emscriptenEnvironment(folder)).toEqual({});
    mkdirSync(join(folder, 'acorn'));
    expect(emscriptenEnvironment(folder).NODE_PATH.split(':')).toContain(folder);
  }));
