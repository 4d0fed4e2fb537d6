// SPDX-License-Identifier: MIT
// README's tables of peers are in the form in which the benchmark writes them.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import {
  damageCell,
  damageCommand,
  damageEngines,
  damages,
  equalCommand,
  equalRow,
  equalWays,
  readDamageCell,
  readEqualRow,
} from '../bench/peer_rows.mjs';
import { markdownTable, rowsOfTable, tableOf, withTable } from '../bench/readme_table.mjs';
import { root } from './support/paths.js';

const readme = readFileSync(join(root, 'README.md'), 'utf8');

test('the table of damaged inputs', () => {
  const table = tableOf(readme, damageCommand);
  const rows = rowsOfTable(table);
  expect(markdownTable(rows)).toBe(table);
  expect(rows.map(({ input }) => input)).toEqual(damages);
  for (const { input, ...cells } of rows) {
    expect(input).not.toBe('');
    expect(Object.keys(cells)).toEqual(damageEngines);
    for (const cell of Object.values(cells)) expect(damageCell(readDamageCell(cell))).toBe(cell);
  }
});

test('the table of few triangles', () => {
  const table = tableOf(readme, equalCommand);
  const rows = rowsOfTable(table);
  expect(markdownTable(rows)).toBe(table);
  expect(rows.length).toBeGreaterThan(0);
  expect(rows.length % equalWays.length).toBe(0);
  rows.forEach((row, i) => {
    expect(row['made by']).toBe(equalWays[i % equalWays.length]);
    expect(equalRow(readEqualRow(row))).toEqual(row);
  });
});

test('cells say what was measured', () => {
  const found = { twoManifold: false, off: -99.984, triangles: 96638, milliseconds: 23 };
  const cell = 'not manifold, −99.98 %, 96,638 triangles, 23 ms';
  expect(damageCell(found)).toBe(cell);
  expect(readDamageCell(cell)).toEqual({ ...found, off: -99.98 });
  expect(damageCell({ ...found, off: -0.004 })).toContain(', +0.00 %,');
  expect(damageCell({ refused: 'NotManifold' })).toBe('refused (NotManifold)');
  expect(damageCell(readDamageCell('2-manifold, +0.1 %, 5 triangles, 1 ms'))).toBe(
    '2-manifold, +0.10 %, 5 triangles, 1 ms',
  );
});

test('rows say what was measured', () => {
  const found = {
    ...{ model: 'casting.off', way: equalWays[0], triangles: 4210, largest: 0.00098 },
    ...{ rms: 0.000123, twoManifold: true, crossings: 1203, milliseconds: 321 },
    stages: { build: 0.5, extract: 0.25, reduce: 0.25 },
  };
  const row = equalRow(found);
  expect(row).toEqual({
    ...{ model: 'casting.off', 'made by': equalWays[0], triangles: '4,210' },
    ...{ 'largest, %': '0.098', 'rms, %': '0.0123', '2-manifold': 'yes', crossings: '1,203' },
    time: '321 ms: build 50 %, extract 25 %, reduce 25 %',
  });
  expect(equalRow(readEqualRow(row))).toEqual(row);
  const none = equalRow({ model: 'm', way: equalWays[2], refused: 'never as close' });
  expect([none.triangles, none.time]).toEqual(['never as close', '']);
  expect(equalRow(readEqualRow(none))).toEqual(none);
});

test('a table takes the place of the one before, and nothing else', () => {
  const page = 'a\n<!-- Made by `x`, not by hand. -->\n\nold\n\n<!-- End of what is made. -->\nb\n';
  const table = markdownTable([{ one: '1', two: '' }]);
  const made = withTable(page, 'x', table);
  expect(made).toBe(page.replace('old', '| one | two |\n| --- | --- |\n| 1 |  |'));
  expect(tableOf(made, 'x')).toBe(table);
  expect(rowsOfTable(table)).toEqual([{ one: '1', two: '' }]);
  expect(() => withTable(page, 'y', table)).toThrow('no marks');
});
