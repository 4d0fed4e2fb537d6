// SPDX-License-Identifier: MIT
// Everything on the page that is not 3D: reading the controls, writing what is to be read.
import type { BuildOptions, Conversion, ExtractOptions } from 'kdmanifold';
import { clearFacts, showFacts } from './facts';
import { element } from './element';
import type { Lines } from './scene';
import { count, remedyOf } from './story';

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

/** Names the input and gives its size once that is known. */
export function showInput(name: string, triangles?: number): void {
  element('input-name').textContent =
    triangles === undefined ? name : `${name}, ${number.format(triangles)} triangles`;
  element('output-name').textContent = '';
  clearFacts();
  tell('');
}

/** The page while the worker works. */
export function showBusy(): void {
  document.body.dataset.state = 'busy';
  document.body.dataset.verdict = '';
  element('error').hidden = true;
  element('busy').hidden = false;
  element('verdict').textContent = 'Converting…';
  element('remedy').textContent = '';
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
  const { output } = report;
  document.body.dataset.verdict = output.manifold ? 'good' : 'bad';
  element('verdict').textContent = verdictOf(report.output);
  const faces = [`${number.format(output.triangles)} triangles`];
  if (output.quads > 0) faces.push(`${number.format(output.quads)} quads`);
  element('output-name').textContent = faces.join(', ');
  element('remedy').textContent = remedyOf(report);
  showFacts(report);
  finish('done');
  enableDownloads(true);
}

/** What is wrong with the input, in words. */
export function tell(story: string): void {
  element('story').textContent = story;
}

/** An error, as text; what encloses nothing can at least be kept open. */
export function showError(message: string): void {
  element('error-text').textContent = message;
  element('keep-open').hidden = !message.startsWith('NOT_CLOSED');
  element('error').hidden = false;
  element('verdict').textContent = 'No result.';
  finish('error');
}

function finish(state: 'done' | 'error'): void {
  document.body.dataset.state = state;
  element('busy').hidden = true;
}

function verdictOf(output: Conversion['report']['output']): string {
  const rims = `with ${count(output.boundaryLoops, 'boundary loop')}`;
  const kind = output.manifold ? '2-manifold' : 'not 2-manifold';
  return [
    output.closed ? 'Closed' : 'Open',
    output.closed ? kind : `${kind} ${rims}`,
    count(output.components, 'part'),
    `Euler characteristic ${number.format(output.eulerCharacteristic)}`,
  ].join(' · ');
}

function enableDownloads(enabled: boolean): void {
  for (const format of ['obj', 'stl', 'ply']) {
    element<HTMLButtonElement>(`save-${format}`).disabled = !enabled;
  }
}
