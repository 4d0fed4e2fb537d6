// SPDX-License-Identifier: MIT
// The table of what input and result consist of: what has changed stands out.
import { element } from './element';
import type { Summary } from './findings';

const number = new Intl.NumberFormat('en');

/** What can be said of one side; null: not yet, or not at all. */
export interface Account {
  summary: Summary;
  triangles: number;
}

const rows: [string, (account: Account) => number | null][] = [
  ['Triangles', ({ triangles }) => triangles],
  ['Parts', ({ summary }) => summary.parts],
  ['of them cavities', ({ summary }) => summary.cavities],
  ['Tunnels', ({ summary }) => summary.tunnels],
  ['Holes', ({ summary }) => summary.holes],
];

/** Shows both sides, as far as they are known. */
export function showChanges(input: Account | null, result: Account | null): void {
  const table = element<HTMLTableElement>('changes');
  table.tBodies[0]?.replaceChildren(
    ...rows.map(([name, read]) => {
      const [before, after] = [input, result].map((side) => side && read(side));
      const row = document.createElement('tr');
      const head = document.createElement('th');
      head.scope = 'row';
      head.textContent = name;
      const cells = [input, result].map((side) => cellOf(side && read(side), side !== null));
      // That a reduced result has fewer triangles goes without saying.
      if (name !== 'Triangles' && known(before) && known(after) && before !== after) {
        row.className = 'changed';
      }
      row.append(head, ...cells);
      return row;
    }),
  );
  element('changes-hint').textContent = unknownOf(input, result);
}

const known = (value: number | null | undefined): value is number => typeof value === 'number';

function cellOf(value: number | null, isThere: boolean): HTMLElement {
  const cell = document.createElement('td');
  cell.textContent = known(value) ? number.format(value) : isThere ? 'not known' : '…';
  return cell;
}

function unknownOf(input: Account | null, result: Account | null): string {
  const reasons: string[] = [];
  for (const [side, name] of [
    [input, 'input'],
    [result, 'result'],
  ] as const) {
    if (side?.summary.tunnels === null) {
      reasons.push(`Tunnels of the ${name} cannot be counted: its faces are no oriented surface.`);
    }
    if (side?.summary.cavities === null) {
      reasons.push(`So many parts of the ${name} overlap that nobody looked for cavities.`);
    }
  }
  return reasons.join(' ');
}
