// SPDX-License-Identifier: MIT
// `npm run house -- [COMMIT...]`: the shape of the C++ sources below src/, of the working tree or of
// each commit: how many files, functions and classes there are and how long they are (median,
// largest), how many fields the largest class has, and what the rooms (folders) include of each
// other. Exit status 1 if concepts, headers with their sources, include each other in a circle.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, relative } from 'node:path';
import { output, root, setup } from '../../scripts/run.mjs';

const median = (values) => values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)] ?? 0;

/** Paths below a folder's src/ of all headers and sources. */
function sourcesOf(folder) {
  const source = join(folder, 'src');
  return readdirSync(source, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && /\.(h|cpp)$/.test(entry.name))
    .map((entry) => relative(source, join(entry.parentPath ?? entry.path, entry.name)))
    .sort();
}

/** Functions, classes and fields with their lines, as ctags finds them. */
function tagsOf(folder, files) {
  const { stdout, error } = spawnSync(
    'ctags',
    [
      '--languages=C++',
      '--language-force=C++',
      '--kinds-C++=fcsm',
      '--fields=+neKs',
      '--output-format=json',
      '-f',
      '-',
      ...files.map((file) => join('src', file)),
    ],
    { cwd: folder, encoding: 'utf8', maxBuffer: 1 << 28 },
  );
  if (error) throw error;
  return stdout
    .split('\n')
    .filter(Boolean)
    .map((line) => JSON.parse(line));
}

/** Concepts (paths without ending) and the concepts that each includes. */
function includesOf(folder, files) {
  const conceptOf = (file) => file.replace(/\.(h|cpp)$/, '');
  const known = new Set(files.map(conceptOf));
  const needs = new Map();
  for (const file of files) {
    const text = readFileSync(join(folder, 'src', file), 'utf8');
    const found = needs.get(conceptOf(file)) ?? new Set();
    for (const [, name] of text.matchAll(/^#include "([^"]+)"/gm)) {
      const other = conceptOf(name.startsWith('kdmanifold/') ? `include/${name}` : name);
      if (known.has(other) && other !== conceptOf(file)) found.add(other);
    }
    needs.set(conceptOf(file), found);
  }
  return needs;
}

/** The members of circles: what is left when all that needs nothing, or that nothing needs, goes. */
function inCircles(needs) {
  const left = new Map([...needs].map(([name, others]) => [name, new Set(others)]));
  for (let changed = true; changed;) {
    changed = false;
    for (const [name, others] of left) {
      for (const other of others) if (!left.has(other)) others.delete(other);
      const isNeeded = [...left.values()].some((needed) => needed.has(name));
      if (others.size > 0 && isNeeded) continue;
      left.delete(name);
      changed = true;
    }
  }
  return [...left.keys()];
}

function measure(folder) {
  const files = sourcesOf(folder);
  const lines = files.map(
    (file) => readFileSync(join(folder, 'src', file), 'utf8').split('\n').length - 1,
  );
  const tags = tagsOf(folder, files);
  const lengthOf = (tag) => tag.end - tag.line + 1;
  const functions = tags.filter(
    ({ kind, name, end }) => kind === 'function' && end && !name.startsWith('__anon'),
  );
  const classes = tags.filter(({ kind, end }) => (kind === 'class' || kind === 'struct') && end);
  const fields = new Map();
  for (const { kind, path, scope } of tags) {
    if (kind === 'member')
      fields.set(`${path} ${scope}`, (fields.get(`${path} ${scope}`) ?? 0) + 1);
  }
  const needs = includesOf(folder, files);
  const roomOf = (name) => dirname(name);
  const between = new Set();
  for (const [name, others] of needs) {
    for (const other of others) {
      if (roomOf(other) !== roomOf(name)) between.add(`${roomOf(name)} -> ${roomOf(other)}`);
    }
  }
  const concepts = new Map();
  for (const name of needs.keys())
    concepts.set(roomOf(name), (concepts.get(roomOf(name)) ?? 0) + 1);
  const largest = (items, size, name) => {
    const [first] = items.toSorted((a, b) => size(b) - size(a));
    return first === undefined ? '-' : `${size(first)} (${name(first)})`;
  };
  const circles = inCircles(needs);
  return {
    circles,
    rows: {
      files: files.length,
      'lines a file, median': median(lines),
      'largest file': largest(
        files.map((file, i) => ({ file, count: lines[i] })),
        ({ count }) => count,
        ({ file }) => file,
      ),
      functions: functions.length,
      'lines a function, median': median(functions.map(lengthOf)),
      'longest function': largest(functions, lengthOf, ({ name }) => name),
      classes: classes.length,
      'lines a class, median': median(classes.map(lengthOf)),
      'longest class': largest(classes, lengthOf, ({ name }) => name),
      'most fields': largest(
        [...fields],
        ([, count]) => count,
        ([key]) => key.split(/::| /).at(-1),
      ),
      rooms: concepts.size,
      'concepts a room, most': largest(
        [...concepts],
        ([, count]) => count,
        ([name]) => name,
      ),
      'includes between rooms': between.size,
      'concepts in circles': circles.length === 0 ? 0 : `${circles.length} (${circles.join(', ')})`,
    },
  };
}

/** Measures a commit in a folder of its own. */
function measureCommit(commit) {
  const folder = mkdtempSync(join(tmpdir(), 'kdmanifold-house-'));
  try {
    const archive = join(folder, 'archive.tar');
    output('git', ['archive', '--format=tar', `--output=${archive}`, commit, 'src']);
    output('tar', ['-xf', archive, '-C', folder]);
    return measure(folder);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

setup('house');
const commits = process.argv.slice(2);
const columns = commits.map((commit) => [commit, measureCommit(commit)]);
if (columns.length === 0) columns.push(['working tree', measure(root)]);
for (const [name, { rows }] of columns) {
  console.log(`== ${name}`);
  for (const [what, value] of Object.entries(rows)) console.log(`${what.padEnd(26)}${value}`);
}
process.exitCode = columns.at(-1)[1].circles.length === 0 ? 0 : 1;
