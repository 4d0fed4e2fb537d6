// SPDX-License-Identifier: MIT
// What is to be read on the page: verdict, story, errors, progress.
import type { Conversion, MeshReport, Warning } from 'kdmanifold';
import { repairs } from './controls';
import { element } from './element';
import { clearFacts, showFacts, showReducedFacts } from './facts';
import { isMostlyNew, remedyOf, verdictOf } from './story';

const number = new Intl.NumberFormat('en');

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
  element('warnings').replaceChildren();
  element('remedy').textContent = '';
  element('advice').hidden = true;
  element<HTMLProgressElement>('progress').removeAttribute('value');
  element('phase').textContent = '';
  enableDownloads(false);
}

/** The page while the second model is on the move: a rough result, or what there is in its place. */
export function showRough(words: string): void {
  // The stage must not move under the pointer.
  const status = element('status');
  status.style.minHeight ||= `${status.getBoundingClientRect().height}px`;
  showBusy();
  document.body.dataset.state = 'dragging';
  element('busy').hidden = true;
  element('verdict').textContent = words;
  element('output-name').textContent = '';
}

/** How far the worker is. */
export function showProgress(fraction: number, phase: string): void {
  element<HTMLProgressElement>('progress').value = fraction;
  element('phase').textContent = phase;
}

/** The verdict in words, and the numbers; `thickness` of a shell, `warnings` of the file. */
export function showResult(
  { report }: Conversion,
  { thickness = 0, warnings }: { thickness?: number | undefined; warnings: Warning[] },
): void {
  const { output } = report;
  document.body.dataset.verdict = output.manifold ? 'good' : 'bad';
  element('verdict').textContent = verdictOf(output);
  const faces = [`${number.format(output.triangles)} triangles`];
  if (output.quads > 0) faces.push(`${number.format(output.quads)} quads`);
  element('output-name').textContent = faces.join(', ');
  element('warnings').replaceChildren(
    ...[...warnings, ...report.warnings].map(({ message }) => warningOf(message)),
  );
  element('remedy').textContent = remedyOf(report, thickness);
  element('advice').hidden = !isMostlyNew(report);
  showFacts(report);
  finish('done');
  enableDownloads(true);
}

/** A level of the result, `apart` from it at most; null: not known yet. */
export function showReduced(report: MeshReport, apart: number | null): void {
  document.body.dataset.verdict = report.manifold ? 'good' : 'bad';
  element('verdict').textContent = verdictOf(report);
  element('output-name').textContent = `${number.format(report.triangles)} triangles`;
  showReducedFacts(report, apart);
}

function warningOf(message: string): HTMLElement {
  const item = document.createElement('li');
  item.textContent = `${message[0]?.toUpperCase()}${message.slice(1)}.`;
  return item;
}

/** What is wrong with the input, in words. */
export function tell(story: string): void {
  element('story').textContent = story;
}

/** An error, as text, with the ways on from there if the input is not closed. */
export function showError(message: string): void {
  const open = message.startsWith('NOT_CLOSED');
  element('error-text').textContent = message;
  element('ways').hidden = !open;
  element('repair').hidden = repairs();
  element('error').hidden = false;
  element('verdict').textContent = 'No result.';
  finish('error');
}

function finish(state: 'done' | 'error'): void {
  document.body.dataset.state = state;
  element('status').style.minHeight = '';
  element('busy').hidden = true;
}

function enableDownloads(enabled: boolean): void {
  for (const format of ['obj', 'stl', 'ply']) {
    element<HTMLButtonElement>(`save-${format}`).disabled = !enabled;
  }
}
