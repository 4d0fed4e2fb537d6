// SPDX-License-Identifier: MIT
// `npm run sizes [-- DIR]`: what a page has to fetch of the built package (dist/), file by file: plain,
// zipped, and by Brotli, in bytes.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { root } from './run.mjs';

/** What loads a part of the package, and what is fetched beside the modules that it imports. */
export const parts = {
  'making manifolds': { from: ['index.js', 'kdmanifold-worker.js'], beside: ['kdmanifold.wasm'] },
  'several threads, in place of kdmanifold.wasm': {
    from: ['kdmanifold-threads.js'],
    beside: ['kdmanifold-threads.wasm'],
  },
  tools: { from: [], beside: ['kdmanifold-tools.wasm'] },
  three: { from: ['three.js'], beside: [] },
};

/** The files of a part, those that it imports included; what is not there is left out. */
export function filesOf({ from, beside }, folder) {
  const files = new Set();
  const add = (name) => {
    if (files.has(name) || !existsSync(`${folder}/${name}`)) return;
    files.add(name);
    const code = readFileSync(`${folder}/${name}`, 'utf8');
    for (const [, imported] of code.matchAll(/(?:\bfrom|^import)\s*["']\.\/([^"']+)["']/gm)) {
      add(imported);
    }
  };
  from.forEach(add);
  return [...files].sort().concat(beside.filter((name) => existsSync(`${folder}/${name}`)));
}

/** Bytes of files when they are zipped, one by one. */
export const zippedSize = (names, folder) =>
  names.reduce((sum, name) => sum + zipped(readFileSync(`${folder}/${name}`)), 0);

const zipped = (bytes) => gzipSync(bytes, { level: 9 }).length;

function sizesOf(path) {
  const bytes = readFileSync(path);
  return [bytes.length, zipped(bytes), brotliCompressSync(bytes).length];
}

function print(folder) {
  const line = (name, sizes) =>
    console.log(name.padEnd(32) + sizes.map((size) => String(size).padStart(12)).join(''));
  const table = (names) => {
    const rows = names.map((name) => [name, sizesOf(`${folder}/${name}`)]);
    for (const [name, sizes] of rows) line(`  ${name}`, sizes);
    line(
      '  together',
      [0, 1, 2].map((i) => rows.reduce((sum, [, sizes]) => sum + sizes[i], 0)),
    );
  };
  line('', ['plain', 'gzip -9', 'brotli']);
  const counted = new Set();
  for (const [title, part] of Object.entries(parts)) {
    const names = filesOf(part, folder).filter((name) => !counted.has(name));
    if (names.length === 0) continue;
    console.log(title);
    names.forEach((name) => counted.add(name));
    table(names);
  }
  console.log('elsewhere');
  table(readdirSync(folder).filter((name) => /\.(js|wasm)$/.test(name) && !counted.has(name)));
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const folder = process.argv[2] ?? `${root}/dist`;
  if (!existsSync(`${folder}/index.js`)) {
    console.error(`sizes: nothing is built in ${folder}: npm run build -- package`);
    process.exit(1);
  }
  print(folder);
}
