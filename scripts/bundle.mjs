// SPDX-License-Identifier: MIT
// Makes dist/, the files that are published, of build/js/: few files, so that a page without a bundler
// fetches little and soon. All code lies in dist/ itself, since it names the other files as its neighbours.
import {
  chmodSync,
  copyFileSync,
  cpSync,
  existsSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  writeFileSync,
} from 'node:fs';
import { root, tool } from './run.mjs';

const from = `${root}/build/js`;
const to = `${root}/dist`;

const bundle = (entries, ...settings) =>
  tool('esbuild', [
    ...entries.map((name) => `${from}/${name}.js`),
    ...['--bundle', '--packages=external', '--target=es2022'],
    ...['--charset=utf8', '--log-level=warning', ...settings],
  ]);

// Takes blanks and comments out, but for those with which imports tell other bundlers what to do. Names stay: they are
// what errors show.
function shrink(path) {
  const imports = /\bimport\(\s*((?:\/\*[^*]*\*\/\s*)*)/g;
  const before = readFileSync(path, 'utf8');
  const hints = [...before.matchAll(imports)].map(([, hint]) => hint.replace(/\s+/g, ' '));
  tool('esbuild', [
    path,
    '--minify-whitespace',
    ...[`--outfile=${path}`, '--allow-overwrite', '--charset=utf8', '--log-level=warning'],
  ]);
  const parts = readFileSync(path, 'utf8').split(imports);
  if (parts.length !== 2 * hints.length + 1) throw new Error(`${path}: an import came or went`);
  // Every other part is what the parentheses hold: comments, of which there are none.
  writeFileSync(
    path,
    parts.map((part, i) => (i % 2 ? `import(${hints[(i - 1) / 2]}` : part)).join(''),
  );
}

// Takes the addresses of files out of a glue that is told what they hold, so that bundlers look for none.
function forgetFiles(glue) {
  const address = /new URL\("[^"]*",import\.meta\.url\)/g;
  writeFileSync(glue, readFileSync(glue, 'utf8').replace(address, '""'));
}

/** Bundles modules, worker and CommonJS, and adds the WebAssembly files and the types of both. */
export function bundlePackage() {
  mkdirSync(to, { recursive: true });
  const withThreads = existsSync(`${from}/kdmanifold-threads.js`);
  const modules = [
    'kdmanifold',
    'kdmanifold-tools',
    ...(withThreads ? ['kdmanifold-threads'] : []),
  ];
  // Emscripten's glue has no such comments, and shrinks by a quarter.
  for (const name of modules) {
    const glue = `${from}/${name}.js`;
    tool('esbuild', [
      glue,
      '--minify',
      `--outfile=${glue}`,
      '--allow-overwrite',
      '--log-level=warning',
    ]);
  }
  bundle(
    ['index', 'three', 'cli'],
    ...['--format=esm', '--splitting', `--outdir=${to}`, '--chunk-names=[name]-[hash]'],
  );
  // In one piece, so that it works wherever it is copied to.
  bundle(['worker/serve'], ...['--format=esm', `--outfile=${to}/kdmanifold-worker.js`]);
  if (withThreads) {
    forgetFiles(`${from}/kdmanifold-threads.js`);
    bundle(['threads/module'], ...['--format=esm', `--outfile=${to}/kdmanifold-threads.js`]);
  }
  for (const name of readdirSync(to)) {
    if (name.endsWith('.js')) shrink(`${to}/${name}`);
  }
  // For `require`, which reaches Node alone (package.json). Its files are the neighbours of the modules.
  bundle(
    ['index', 'three'],
    ...['--format=cjs', '--platform=node', `--outdir=${to}/cjs`],
    ...['--define:import.meta.url=kdmModuleUrl', `--banner:js=${moduleUrl}`],
  );
  writeFileSync(`${to}/cjs/package.json`, '{ "type": "commonjs" }\n');
  for (const name of modules) copyFileSync(`${from}/${name}.wasm`, `${to}/${name}.wasm`);
  chmodSync(`${to}/cli.js`, 0o755);
  const isType = (path) => !/\.[a-z]+$/.test(path) || /\.d\.ts$/.test(path);
  for (const folder of [`${to}/types`, `${to}/cjs`]) {
    cpSync(from, folder, { recursive: true, filter: isType });
  }
}

// The address of dist/index.js, as seen from dist/cjs/.
const moduleUrl =
  `const kdmModuleUrl = require('node:url').pathToFileURL(` +
  `require('node:path').join(__dirname, '../index.js')).href;`;
