// SPDX-License-Identifier: MIT
// Everything on the page that is not 3D: reading the controls, writing what is to be read.
import type { BuildOptions, Conversion, ExtractOptions, InputReport } from 'kdmanifold';
import type { Lines } from './scene';

/** An element of the page that must be there. */
export function element<T extends HTMLElement = HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (found === null) throw new Error(`the page has no element #${id}`);
  return found as T;
}

const number = new Intl.NumberFormat('en');
const decimal = new Intl.NumberFormat('en', { maximumSignificantDigits: 3 });

/** What the conversion controls say. */
export function readOptions(): BuildOptions & ExtractOptions {
  const choice = (id: string): string => element<HTMLSelectElement>(id).value;
  return {
    strategy: choice('strategy') as BuildOptions['strategy'],
    ...(byTolerance()
      ? { relativeTolerance: readTolerance() }
      : { depth: element<HTMLInputElement>('depth').valueAsNumber }),
    inside: choice('inside') as BuildOptions['inside'],
    pairing: choice('pairing') as BuildOptions['pairing'],
    quads: element<HTMLInputElement>('quads').checked,
  };
}

/** What the line switches say. */
export function readLines(): Lines {
  return {
    wireframe: element<HTMLInputElement>('wireframe').checked,
    creases: element<HTMLInputElement>('creases').checked,
  };
}

// Two strategies are told how exact to be, the others how deep to go.
function byTolerance(): boolean {
  return ['adaptive', 'octree'].includes(element<HTMLSelectElement>('strategy').value);
}

// The slider is logarithmic.
function readTolerance(): number {
  return Number((10 ** element<HTMLInputElement>('tolerance').valueAsNumber).toPrecision(2));
}

/** Shows the control that counts for the strategy and says what it means. */
export function explainSize(): void {
  const depth = element<HTMLInputElement>('depth').valueAsNumber;
  const tolerance = `${decimal.format(readTolerance() * 100)} %`;
  element('tolerance-row').hidden = !byTolerance();
  element('depth-row').hidden = byTolerance();
  element('tolerance-value').textContent = tolerance;
  element('depth-value').textContent = String(depth);
  const cells = number.format(Math.round(2 ** (depth / 3)));
  const strategy = element<HTMLSelectElement>('strategy').value;
  element('size-hint').textContent = byTolerance()
    ? `The result stays within ${tolerance} of the model's diagonal.`
    : strategy === 'median'
      ? 'At most so many splits on the way to a cell.'
      : `${cells} cells along each axis.`;
}

/** Names the input and gives its size. */
export function showInput(name: string, triangles: number): void {
  element('input-name').textContent = `${name}, ${number.format(triangles)} triangles`;
  element('output-name').textContent = '';
  for (const table of ['input-facts', 'output-facts', 'grid-facts']) fillTable(table, []);
}

/** The page while the worker works. */
export function showBusy(): void {
  document.body.dataset.state = 'busy';
  document.body.dataset.verdict = '';
  element('error').hidden = true;
  element('busy').hidden = false;
  element('verdict').textContent = 'Converting…';
  element<HTMLProgressElement>('progress').removeAttribute('value');
  element('phase').textContent = '';
  enableDownloads(false);
}

/** How far the worker is. */
export function showProgress(fraction: number, phase: string): void {
  element<HTMLProgressElement>('progress').value = fraction;
  element('phase').textContent = phase;
}

/** The verdict in words, and the numbers. */
export function showResult({ report }: Conversion): void {
  const { input, grid, output, seconds } = report;
  document.body.dataset.verdict = output.twoManifold ? 'good' : 'bad';
  element('verdict').textContent = verdictOf(report.output);
  const faces = [`${number.format(output.triangles)} triangles`];
  if (output.quads > 0) faces.push(`${number.format(output.quads)} quads`);
  element('output-name').textContent = faces.join(', ');
  fillTable('input-facts', inputFacts(input));
  fillTable('output-facts', [
    ['Vertices', number.format(output.vertices)],
    ['Triangles', number.format(output.triangles)],
    ['Quads', number.format(output.quads)],
    ['Parts', number.format(output.components)],
    ['Euler characteristic', number.format(output.eulerCharacteristic)],
    ['Closed', yes(output.closed)],
    ['2-manifold', yes(output.twoManifold)],
    ['Inserted vertices', number.format(output.insertedVertices)],
    ['Split vertices', number.format(output.splitVertices)],
    ['Link vertices', number.format(output.linkVertices)],
    ['Flipped edges', number.format(output.flippedEdges)],
    ['Dropped pillows', number.format(output.droppedPillows)],
  ]);
  fillTable('grid-facts', [
    ['Build', `${decimal.format(seconds.build)} s`],
    ['Extract', `${decimal.format(seconds.extract)} s`],
    ['Leaves', number.format(grid.leaves)],
    ['Hits', number.format(grid.hits)],
    ['Depth reached', number.format(grid.depth)],
    ['Topology resolved', grid.topologyResolved ? 'yes' : 'not known'],
    ['Grid', `${decimal.format(grid.bytes / 2 ** 20)} MB`],
    ['Heap', `${decimal.format(report.peakBytes / 2 ** 20)} MB`],
  ]);
  finish('done');
  enableDownloads(true);
}

/** An error, as text. */
export function showError(message: string): void {
  const box = element('error');
  box.textContent = message;
  box.hidden = false;
  element('verdict').textContent = 'No result.';
  finish('error');
}

function finish(state: 'done' | 'error'): void {
  document.body.dataset.state = state;
  element('busy').hidden = true;
}

function verdictOf(output: Conversion['report']['output']): string {
  const parts = output.components === 1 ? '1 part' : `${number.format(output.components)} parts`;
  return [
    output.closed ? 'Closed' : 'Not closed',
    output.twoManifold ? '2-manifold' : 'not 2-manifold',
    parts,
    `Euler characteristic ${number.format(output.eulerCharacteristic)}`,
  ].join(' · ');
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

function enableDownloads(enabled: boolean): void {
  for (const format of ['obj', 'stl', 'ply']) {
    element<HTMLButtonElement>(`save-${format}`).disabled = !enabled;
  }
}
