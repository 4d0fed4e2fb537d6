// SPDX-License-Identifier: MIT
// Tables in README.md that the benchmark makes: between two marks, the first of which names the command.

import { readFileSync, writeFileSync } from 'node:fs';
import { root } from '../../scripts/run.mjs';

const begin = (command) => `<!-- Made by \`${command}\`, not by hand. -->`;
const end = '<!-- End of what is made. -->';

/** Rows of equal keys, the first of which names the row, as a table of markdown. */
export function markdownTable(rows) {
  const keys = Object.keys(rows[0]);
  const lines = [keys, keys.map(() => '---'), ...rows.map((row) => keys.map((key) => row[key]))];
  return lines.map((cells) => `| ${cells.join(' | ')} |`).join('\n');
}

/** The other way round. */
export function rowsOfTable(table) {
  const cellsOf = (line) => line.slice(2, -2).split(' | ');
  const [head, , ...lines] = table.split('\n');
  const keys = cellsOf(head);
  return lines.map((line) => Object.fromEntries(cellsOf(line).map((cell, i) => [keys[i], cell])));
}

/** The page with a table in place of the one that the command has made before. */
export function withTable(page, command, table) {
  const [from, to] = placeOf(page, command);
  return `${page.slice(0, from)}\n\n${table}\n\n${page.slice(to)}`;
}

/** Puts the table into README.md. */
export function writeTable(command, table) {
  const path = `${root}/README.md`;
  writeFileSync(path, withTable(readFileSync(path, 'utf8'), command, table));
}

/** The table that the command has made. */
export function tableOf(page, command) {
  return page.slice(...placeOf(page, command)).trim();
}

function placeOf(page, command) {
  const at = page.indexOf(begin(command));
  const from = at + begin(command).length;
  const to = page.indexOf(end, from);
  if (at < 0 || to < 0) throw new Error(`the page has no marks of \`${command}\``);
  return [from, to];
}
