// SPDX-License-Identifier: MIT
// The tables of numbers below the views.
import type {
  InputReport,
  LostArea,
  MeshError,
  MeshReport,
  OutputReport,
  ReduceReport,
  Report,
} from 'kdmanifold';
import { element } from './element';

const number = new Intl.NumberFormat('en');
const percent = new Intl.NumberFormat('en', { style: 'percent', maximumSignificantDigits: 2 });
const decimal = new Intl.NumberFormat('en', { maximumSignificantDigits: 3 });

/** All there is to be counted about a conversion. */
export function showFacts(report: Report): void {
  const { input, grid, output, reduce, seconds, lost, error } = report;
  fillTable('input-facts', inputFacts(input));
  fillTable('output-facts', [
    ...resultFacts(output),
    ...(reduce === null ? [] : beforeReduction(reduce)),
    ['Inserted vertices', number.format(output.insertedVertices)],
    ['Split vertices', number.format(output.splitVertices)],
    ['Link vertices', number.format(output.linkVertices)],
    ['Flipped edges', number.format(output.flippedEdges)],
    ['Dropped pillows', number.format(output.droppedPillows)],
    ...(lost ? missing(lost) : []),
    ...(error ? distances(error) : []),
  ]);
  fillTable('grid-facts', [
    ['Build', `${decimal.format(seconds.build)} s`],
    ['Extract', `${decimal.format(seconds.extract)} s`],
    ['Reduce', reduce === null ? 'not done' : `${decimal.format(seconds.reduce)} s`],
    ['Leaves', number.format(grid.leaves)],
    ['Hits', number.format(grid.hits)],
    ['Depth reached', number.format(grid.depth)],
    ['Topology resolved', grid.topologyResolved ? 'yes' : 'not known'],
    ['Grid', `${decimal.format(grid.bytes / 2 ** 20)} MB`],
    ['Heap', `${decimal.format(report.peakBytes / 2 ** 20)} MB`],
  ]);
}

/** What can be counted of a level of the result, `apart` from it at most; null: not known yet. */
export function showReducedFacts(report: MeshReport, apart: number | null): void {
  fillTable('output-facts', [
    ...resultFacts(report),
    ['Furthest from the full result', apart === null ? '…' : decimal.format(apart)],
  ]);
}

const resultFacts = (
  result: Pick<MeshReport, keyof MeshReport & keyof OutputReport>,
): [string, string][] => [
  ['Vertices', number.format(result.vertices)],
  ['Triangles', number.format(result.triangles)],
  ['Quads', number.format(result.quads)],
  ['Parts', number.format(result.components)],
  ['Euler characteristic', number.format(result.eulerCharacteristic)],
  ['Closed', yes(result.closed)],
  ['2-manifold', yes(result.twoManifold)],
];

const beforeReduction = ({ trianglesBefore }: ReduceReport): [string, string][] => [
  ['Triangles before reduction', number.format(trianglesBefore)],
];

const missing = ({ area, share }: LostArea): [string, string][] => [
  ['Area missing', area > 0 ? percent.format(share) : 'none'],
];

// How far the two are apart, in model units.
const distances = ({ toInput, toOutput }: MeshError): [string, string][] => [
  ['Furthest from the input', decimal.format(toInput.largest)],
  ['On average (rms)', decimal.format(toInput.rms)],
  ["The input's furthest from it", decimal.format(toOutput.largest)],
  ['On average (rms)', decimal.format(toOutput.rms)],
];

/** Empties the tables. */
export function clearFacts(): void {
  for (const table of ['input-facts', 'output-facts', 'grid-facts']) fillTable(table, []);
}

function inputFacts(input: InputReport): [string, string][] {
  const facts: [string, string][] = [
    ['Vertices (joined)', number.format(input.vertices)],
    ['Triangles', number.format(input.triangles)],
    ['Parts', number.format(input.components)],
    ['Closed', yes(input.closed)],
    ['Non-manifold edges', number.format(input.nonManifoldEdges)],
    ['Back-to-back faces', number.format(input.cancelledFaces)],
    ['Faces without area', number.format(input.degenerateFaces)],
    ['Lattice step', decimal.format(input.latticeStep)],
  ];
  if (input.flipped) facts.push(['Was inside out', 'yes, turned']);
  return facts;
}

const yes = (value: boolean): string => (value ? 'yes' : 'no');

function fillTable(id: string, facts: [string, string][]): void {
  const body = element(id).querySelector('tbody');
  body?.replaceChildren(
    ...facts.map(([name, value]) => {
      const row = document.createElement('tr');
      const head = document.createElement('th');
      head.scope = 'row';
      head.textContent = name;
      const cell = document.createElement('td');
      cell.textContent = value;
      row.append(head, cell);
      return row;
    }),
  );
}
