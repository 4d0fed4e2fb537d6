// SPDX-License-Identifier: MIT
// Patterns of file names that no shell has expanded, matched as src/cli/glob.cpp does: `fs.globSync` comes with
// Node 22 only.
import { lstatSync, readdirSync, statSync, type Stats } from 'node:fs';

/** Says whether the text has `*`, `?` or `[`. */
export const isPattern = (text: string): boolean => /[*?[]/.test(text);

const codeOf = (character = ''): number => character.codePointAt(0) ?? 0;

// One place of a pattern that stands for one character: whether it does, and where the pattern goes on.
type Place = [fits: boolean, end: number];

// The class that begins behind the bracket at `open`. Without a closing bracket the bracket is itself.
function matchClass(pattern: string[], open: number, c: string): Place {
  let at = open + 1;
  const negated = pattern[at] === '!' || pattern[at] === '^';
  if (negated) ++at;
  const close = pattern.indexOf(']', at + 1);
  if (close < 0) return [c === '[', open + 1];
  const code = codeOf(c);
  let found = false;
  for (; at < close; ++at) {
    const low = codeOf(pattern[at]);
    const range = at + 2 < close && pattern[at + 1] === '-';
    if (range) at += 2;
    found ||= low <= code && code <= codeOf(pattern[at]);
  }
  return [found !== negated, close + 1];
}

function matchOne(pattern: string[], at: number, c = ''): Place {
  if (pattern[at] === '?') return [true, at + 1];
  if (pattern[at] === '[') return matchClass(pattern, at, c);
  return [pattern[at] === c, at + 1];
}

/**
 * Says whether a name without folders fits a pattern: `*` is any text, `?` any character, `[a-z]` one of these,
 * `[!a-z]` one of all others. A name that begins with a dot wants one in the pattern.
 */
export function fits(name: string, pattern: string): boolean {
  if (name.startsWith('.') && !pattern.startsWith('.')) return false;
  const text = Array.from(name);
  const wanted = Array.from(pattern);
  let at = 0; // in the pattern
  let star = -1; // behind the last star, to which one can go back
  let resume = 0; // where in the text that star ends
  for (let i = 0; i < text.length;) {
    if (wanted[at] === '*') {
      star = ++at;
      resume = i;
      continue;
    }
    const [one, end] = at < wanted.length ? matchOne(wanted, at, text[i]) : [false, 0];
    if (one) {
      at = end;
      ++i;
    } else if (star >= 0) {
      at = star;
      i = ++resume;
    } else {
      return false;
    }
  }
  while (wanted[at] === '*') ++at;
  return at === wanted.length;
}

// Undefined where nothing is, or nobody may look.
function look(path: string, at: (path: string) => Stats): Stats | undefined {
  try {
    return at(path);
  } catch {
    return undefined;
  }
}

const isFile = (path: string): boolean => look(path, statSync)?.isFile() === true;
const isFolder = (path: string): boolean => look(path, statSync)?.isDirectory() === true;
const isLink = (path: string): boolean => look(path, lstatSync)?.isSymbolicLink() === true;

function namesIn(folder: string): string[] {
  try {
    return readdirSync(folder === '' ? '.' : folder);
  } catch {
    return [];
  }
}

// `before` is the path so far, with its slash.
function* walk(before: string, [pattern = '', ...rest]: string[]): Generator<string> {
  const last = rest.length === 0;
  if (!isPattern(pattern)) {
    if (!last) yield* walk(`${before}${pattern}/`, rest);
    else if (isFile(before + pattern)) yield before + pattern;
    return;
  }
  const deep = pattern === '**' && !last;
  if (deep) yield* walk(before, rest);
  for (const name of namesIn(before)) {
    if (!fits(name, pattern)) continue;
    const path = before + name;
    if (last) {
      if (isFile(path)) yield path;
    } else if (deep) {
      // Not through links, which may lead back.
      if (isFolder(path) && !isLink(path)) yield* walk(`${path}/`, [pattern, ...rest]);
    } else if (isFolder(path)) {
      yield* walk(`${path}/`, rest);
    }
  }
}

/**
 * Returns the paths of all files that fit, in the order of their bytes. `**` between slashes is any number of folders,
 * even none; what cannot be read is passed over.
 */
export function expand(pattern: string): string[] {
  const slashes = process.platform === 'win32' ? pattern.replaceAll('\\', '/') : pattern;
  const found = new Set(walk('', slashes.split('/')));
  return [...found].sort((a, b) => Buffer.compare(Buffer.from(a), Buffer.from(b)));
}
