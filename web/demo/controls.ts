// SPDX-License-Identifier: MIT
// The controls: what they say, and which of them count.
import type { BuildOptions, ExtractOptions, MeshInput, Report } from 'kdmanifold';
import { element } from './element';
import type { Lines } from './view';

/** What is made of an input: solid or shell, which are closed, or a sheet, which is open. */
export type Make = 'solid' | 'shell' | 'sheet';

const number = new Intl.NumberFormat('en');
const decimal = new Intl.NumberFormat('en', { maximumSignificantDigits: 3 });

const choice = (id: string): string => element<HTMLSelectElement>(id).value;
const amount = (id: string): number => element<HTMLInputElement>(id).valueAsNumber;
const checked = (id: string): boolean => element<HTMLInputElement>(id).checked;

// The diagonal of the input's bounding box, which percentages are of.
let size = 1;
// What the thickness is a number of.
let unit = choice('thickness-unit');
// Does the input have gaps to be closed?
let gaps = false;
// Has anybody said how much of them to fill?
let gapsAreSet = false;
// How far the input and the last result are apart, a fraction of the diagonal; null: not known.
let distance: number | null = null;

/** What the conversion controls say; throws if the thickness is none. */
export function readOptions(): BuildOptions & ExtractOptions {
  const make = choice('make') as Make;
  return {
    strategy: choice('strategy') as BuildOptions['strategy'],
    ...(byTolerance() ? { relativeTolerance: readTolerance() } : { depth: amount('depth') }),
    pairing: readPairing(make),
    quads: checked('quads'),
    ...(make === 'solid' && {
      inside: choice('inside') as BuildOptions['inside'],
      windingThreshold: repairs() && gapsAreSet ? (100 - amount('gaps')) / 100 : 0,
    }),
    ...(make === 'shell' && { thicken: readThickness() }),
    ...(make === 'sheet'
      ? { inside: 'sheet' }
      : { parts: choice('parts') as ExtractOptions['parts'] }),
  };
}

// Sheets have no inside that hits could be joined by.
function readPairing(make: Make): BuildOptions['pairing'] {
  const pairing = choice('pairing') as BuildOptions['pairing'];
  return make === 'sheet' && pairing !== 'hermite' ? 'trace' : pairing;
}

/** Are holes to be closed? */
export function repairs(): boolean {
  return choice('make') === 'solid' && choice('inside') === 'repair';
}

/** What the line switches say. */
export function readLines(): Lines {
  return { wireframe: checked('wireframe'), creases: checked('creases') };
}

/** Chooses what is to be made of the input. */
export function chooseMake(make: Make): void {
  element<HTMLSelectElement>('make').value = make;
}

/** A new input: percentages are of its size, and whether it has gaps is not known. */
export function measure({ positions, indices }: MeshInput): void {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  const corners = indices?.length ?? positions.length / 3;
  for (let i = 0; i < 3 * corners; ++i) {
    const [corner, axis] = [Math.floor(i / 3), i % 3];
    const value = positions[3 * (indices?.[corner] ?? corner) + axis] as number;
    if (value < (low[axis] as number)) low[axis] = value;
    if (value > (high[axis] as number)) high[axis] = value;
  }
  size = Math.hypot(...high.map((value, axis) => value - (low[axis] as number)));
  gaps = gapsAreSet = false;
  distance = null;
}

/** What the conversion has measured; shells are meant to be away from the input. */
export function learnOfError({ input, error }: Report, thickness = 0): void {
  if (!error || thickness > 0) return;
  distance = Math.max(error.toInput.largest, error.toOutput.largest) / input.extent;
}

/** The last result does not count any more. */
export function forgetError(): void {
  distance = null;
  explainSize();
}

/** Gaps that have been closed may be closed differently. */
export function learnOfGaps({ grid, input }: Report): void {
  if (grid.inventedHits > 0 || input.patchedHoles > 0) gaps = true;
  if (grid.windingThreshold === 0) return;
  element<HTMLInputElement>('gaps').value = String(Math.round(100 - 100 * grid.windingThreshold));
}

/** From now on gaps are filled as much as the control says. */
export function setGaps(): void {
  gapsAreSet = true;
}

/** The thickness stays what it is when its unit changes. */
export function changeUnit(): void {
  const to = choice('thickness-unit');
  const field = element<HTMLInputElement>('thickness');
  const factor = to === unit ? 1 : to === 'percent' ? 100 / size : size / 100;
  unit = to;
  const thickness = field.valueAsNumber * factor;
  if (Number.isFinite(thickness)) field.value = String(Number(thickness.toPrecision(4)));
}

/** Shows the controls that count for what is to be made and says what they mean. */
export function explainControls(): void {
  const make = choice('make') as Make;
  element('make-hint').textContent = {
    solid: 'Holes are closed and turned faces turned back.',
    shell: 'Around all of the surface, half to either side: for what encloses nothing.',
    sheet: 'The surface as it is, holes and all.',
  }[make];
  element('thickness-row').hidden = make !== 'shell';
  element('parts-row').hidden = make === 'sheet';
  element('inside-row').hidden = make !== 'solid';
  element('gaps-row').hidden = !repairs() || !gaps;
  element('gaps-value').textContent = `${amount('gaps')} %`;
  explainThickness();
  explainSize();
}

function explainThickness(): void {
  const units = thicknessInUnits();
  const inPercent = choice('thickness-unit') === 'percent';
  const hint = element('thickness-hint');
  hint.hidden = element('thickness-row').hidden || !(units > 0);
  hint.textContent = inPercent
    ? `${decimal.format(units)} in the model's units.`
    : `${decimal.format((100 * units) / size)} % of the model's diagonal.`;
}

function thicknessInUnits(): number {
  return amount('thickness') * (choice('thickness-unit') === 'percent' ? size / 100 : 1);
}

function readThickness(): number {
  const thickness = thicknessInUnits();
  if (!(thickness > 0)) throw new Error('The thickness must be a number above 0.');
  return thickness;
}

// Some strategies are told how exact to be, the others how deep to go.
function byTolerance(): boolean {
  return ['adaptive', 'octree', 'feature'].includes(choice('strategy'));
}

// The slider is logarithmic.
function readTolerance(): number {
  return Number((10 ** amount('tolerance')).toPrecision(2));
}

function explainSize(): void {
  const depth = amount('depth');
  const tolerance = `${decimal.format(readTolerance() * 100)} %`;
  element('tolerance-row').hidden = !byTolerance();
  element('depth-row').hidden = byTolerance();
  element('tolerance-value').textContent = tolerance;
  element('depth-value').textContent = String(depth);
  const cells = number.format(Math.round(2 ** (depth / 3)));
  element('size-hint').textContent = byTolerance()
    ? `The result aims to stay within ${tolerance} of the model's diagonal.`
    : choice('strategy') === 'median'
      ? 'At most so many splits on the way to a cell.'
      : `${cells} cells along each axis.`;
  const apart = element('distance-hint');
  apart.hidden = distance === null;
  apart.textContent = `Measured: at most ${decimal.format(100 * (distance ?? 0))} % of it apart.`;
}
