// SPDX-License-Identifier: MIT
// Reads as much of an object file (ELF, 64 bits, little-endian) as is needed to compare definitions.
import { readFileSync } from 'node:fs';

const sectionTypes = { symbols: 2, relocations: 4, withoutBytes: 8 };

/**
 * Sections are { name, bytes, relocations }, relocations { offset, type, symbol, addend }, symbols
 * { name, weak, section, value, size }: without a section what another file defines, without a name
 * a section as a whole.
 */
export function readObject(path) {
  const file = readFileSync(path);
  if (file.toString('latin1', 0, 6) !== '\x7fELF\x02\x01') throw new Error(`${path}: not ELF64`);
  const headers = sectionHeaders(file);
  const textAt = ({ bytes }, offset) => bytes.toString('latin1', offset, bytes.indexOf(0, offset));
  const names = headers[file.readUInt16LE(62)];
  const sections = headers.map((header) => ({
    ...header,
    name: textAt(names, header.nameOffset),
    relocations: [],
  }));
  const table = sections.find(({ type }) => type === sectionTypes.symbols);
  const symbols = table === undefined ? [] : readSymbols(table, sections, textAt);
  for (const { type, info, bytes } of sections) {
    if (type !== sectionTypes.relocations) continue;
    sections[info].relocations = rows(bytes, 24).map((row) => ({
      offset: Number(row.readBigUInt64LE(0)),
      type: row.readUInt32LE(8),
      symbol: symbols[row.readUInt32LE(12)],
      addend: Number(row.readBigInt64LE(16)),
    }));
  }
  return { sections, symbols };
}

function sectionHeaders(file) {
  const start = Number(file.readBigUInt64LE(40));
  const [size, count] = [file.readUInt16LE(58), file.readUInt16LE(60)];
  // With very many sections their number stands in the first one.
  const total = count === 0 ? Number(file.readBigUInt64LE(start + 32)) : count;
  return rows(file.subarray(start, start + size * total), size).map((row) => {
    const type = row.readUInt32LE(4);
    const [offset, length] = [24, 32].map((at) => Number(row.readBigUInt64LE(at)));
    return {
      nameOffset: row.readUInt32LE(0),
      type,
      link: row.readUInt32LE(40),
      info: row.readUInt32LE(44),
      bytes: file.subarray(offset, type === sectionTypes.withoutBytes ? offset : offset + length),
    };
  });
}

function readSymbols(table, sections, textAt) {
  return rows(table.bytes, 24).map((row) => {
    const index = row.readUInt16LE(6);
    return {
      name: textAt(sections[table.link], row.readUInt32LE(0)),
      weak: row[4] >> 4 === 2 || row[4] >> 4 === 10, // or unique: static data of inline functions
      section: index > 0 && index < 0xff00 ? sections[index] : undefined,
      value: Number(row.readBigUInt64LE(8)),
      size: Number(row.readBigUInt64LE(16)),
    };
  });
}

const rows = (bytes, size) =>
  Array.from({ length: bytes.length / size }, (_, i) => bytes.subarray(i * size, (i + 1) * size));
