// SPDX-License-Identifier: MIT
// Finds names that object files define differently: inline functions, templates, members of classes
// and tables of virtual functions, of which a linker keeps whichever it meets first. GCC's -Wodr
// compares types only; here code is compared, as g++ -O0 -Wa,--keep-locals makes it for x86-64.
import { createHash } from 'node:crypto';
import { readObject } from './object_file.mjs';

/**
 * Every name in a namespace, or of a template over one of its types, that is not defined alike
 * everywhere, with one file for each of its definitions.
 */
export function differingDefinitions(objects, namespace) {
  const mangled = `${namespace.length}${namespace}`;
  const definitions = new Map();
  const shared = new Set();
  for (const path of objects) {
    for (const { name, weak, digest } of definitionsOf(path, mangled)) {
      if (weak) shared.add(name);
      if (!definitions.has(name)) definitions.set(name, new Map());
      const files = definitions.get(name);
      if (!files.has(digest)) files.set(digest, path);
    }
  }
  return [...definitions]
    .filter(([name, files]) => shared.has(name) && files.size > 1)
    .map(([name, files]) => ({ name, files: [...files.values()] }));
}

const isConstant = ({ name }) => name.startsWith('.rodata');

/** The definitions of an object file, with digests that are equal if they are. */
function definitionsOf(path, mangled) {
  const { symbols } = readObject(path);
  const places = new Map();
  for (const symbol of symbols) {
    // Labels within code name no more than places in a function; those of constants tell their ends.
    const isLabel = symbol.name.startsWith('.L');
    if (symbol.section === undefined || symbol.name === '') continue;
    if (isLabel && !isConstant(symbol.section)) continue;
    if (!places.has(symbol.section)) places.set(symbol.section, []);
    places.get(symbol.section).push({ ...symbol, name: isLabel ? '' : symbol.name });
  }
  for (const inOne of places.values()) {
    inOne.sort((a, b) => a.value - b.value || (a.name < b.name ? -1 : 1));
  }
  return symbols
    .filter(({ name, section, size }) => section && size > 0 && name.includes(mangled))
    .map((symbol) => ({ ...symbol, digest: digestOf(symbol, places) }));
}

/** Of the bytes, and of what is filled into them at linking. */
function digestOf({ section, value, size }, places) {
  const hash = createHash('sha1').update(section.bytes.subarray(value, value + size));
  for (const { offset, type, symbol, addend } of section.relocations) {
    if (offset < value || offset >= value + size) continue;
    hash.update(`${offset - value} ${target(type, symbol, addend, places)}\n`);
  }
  return hash.digest('latin1');
}

const absolute = 1; // R_X86_64_64; all others that occur count from the end of their four bytes

/** What a relocation refers to, whatever it is called and wherever it lies in its file. */
function target(type, { name, section, value }, addend, places) {
  const offset = addend + (type === absolute ? 0 : 4);
  if (name !== '' && !name.startsWith('.L')) return `${name} ${offset}`;
  // Local functions, data and constants are given as places in their section.
  const inOne = places.get(section) ?? [];
  const index = inOne.findLastIndex((place) => place.value <= value + offset);
  if (index < 0) return section.name;
  const { name: nearest, value: begin } = inOne[index];
  const place = `${nearest} ${value + offset - begin}`;
  if (!isConstant(section)) return place;
  const end = inOne.slice(index).find((next) => next.value > begin)?.value;
  const constant = section.bytes.toString('latin1', begin, end ?? section.bytes.length);
  return `${place} ${constant.replace(/\0+$/, '')}`;
}
