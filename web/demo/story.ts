// SPDX-License-Identifier: MIT
// The verdict in words: what was wrong with the input, and what has become of it.
import type { OutputReport, Report } from 'kdmanifold';
import type { DefectKind, Finding, Summary } from './findings';

const number = new Intl.NumberFormat('en');
const decimal = new Intl.NumberFormat('en', { maximumSignificantDigits: 3 });
const percent = new Intl.NumberFormat('en', { style: 'percent', maximumSignificantDigits: 2 });
const list = new Intl.ListFormat('en');

/** "1 hole", "1,200 holes". */
export function count(n: number, one: string, many = `${one}s`): string {
  return `${number.format(n)} ${n === 1 ? one : many}`;
}

const words: Record<DefectKind, (n: number, summary: Summary) => string> = {
  open: (n, { holes }) =>
    holes > 0
      ? `it is open (${count(n, 'edge')} round ${count(holes, 'hole')})`
      : `it is open at ${count(n, 'edge')}`,
  crowded: (n) => `${count(n, 'edge has', 'edges have')} three or more faces`,
  pinched: (n) => `it is pinched in ${count(n, 'vertex', 'vertices')}`,
  disagreeing: (n) => `faces disagree across ${count(n, 'edge')}`,
  flipped: (n) => `${count(n, 'face is', 'faces are')} turned the wrong way`,
  doubled: (n) => `${count(n, 'face is', 'faces are')} doubled`,
  degenerate: (n) => `${count(n, 'face has', 'faces have')} no area`,
  crossing: (n) => count(n, 'face crosses others', 'faces cross each other'),
};

/** One or two sentences; `crossingsKnown`: has the search for them come to its end? */
export function storyOf(
  summary: Summary,
  findings: readonly Finding<DefectKind>[],
  crossingsKnown: boolean,
): string {
  const known = new Map(findings.map((finding) => [finding.kind, finding.count]));
  // Where faces are turned it goes without saying that their neighbours disagree.
  if (known.has('flipped')) known.delete('disagreeing');
  const clauses = [...known].map(([kind, n]) => words[kind](n, summary));
  const extent = [count(summary.parts, 'part')];
  if (summary.cavities) extent.push(count(summary.cavities, 'cavity', 'cavities'));
  const clean = summary.closed && clauses.length === 0 && crossingsKnown;
  const closed = summary.closed ? ' and is closed' : '';
  return [
    `The input has ${list.format(extent)}${closed}${clean ? ' and free of defects' : ''}`,
    clauses.length > 0 ? `; ${list.format(clauses)}` : '',
    crossingsKnown ? '.' : '. Looking for crossings…',
  ].join('');
}

/** The result in a few words. */
export function verdictOf(
  output: Pick<
    OutputReport,
    'closed' | 'manifold' | 'components' | 'boundaryLoops' | 'eulerCharacteristic'
  >,
): string {
  const { components, boundaryLoops, eulerCharacteristic } = output;
  const words = [
    output.closed ? 'Closed' : 'Open',
    output.manifold ? '2-manifold' : 'not 2-manifold',
  ];
  if (!output.closed) words.push(count(boundaryLoops, 'rim'));
  words.push(count(components, 'part'));
  // Euler's formula holds for manifolds only.
  const tunnels = components - (eulerCharacteristic + boundaryLoops) / 2;
  if (output.manifold && tunnels > 0) words.push(count(tunnels, 'tunnel'));
  return words.join(' · ');
}

/** Is so much of it new that the input may not be meant as a solid? */
export function isMostlyNew({ output }: Report): boolean {
  return output.inventedArea > 0.4 * output.area;
}

/** What the conversion did about it; empty if nothing. `thickness`: of a shell, in model units. */
export function remedyOf({ input, grid, output }: Report, thickness: number): string {
  const done: string[] = [];
  if (thickness > 0) done.push(`a shell ${decimal.format(thickness)} thick built around it`);
  if (input.flipped) done.push('all of it turned over');
  if (input.sewnEdges > 0) done.push(`${count(input.sewnEdges, 'pair')} of edges sewn together`);
  if (input.turnedFaces > 0) done.push(`${count(input.turnedFaces, 'face')} turned`);
  const share = percent.format(output.inventedArea / output.area);
  const invented = output.inventedArea > 0 ? `, which invented ${share} of the area` : '';
  if (grid.windingThreshold > 0) {
    if (grid.inventedHits > 0) done.push(`holes and gaps closed${invented}`);
  } else if (input.patchedHoles > 0) {
    done.push(`${count(input.patchedHoles, 'hole')} closed by patches${invented}`);
  }
  const left = (n: number, one: string, many?: string): void => {
    if (n > 0) done.push(`${count(n, one, many)} left out`);
  };
  left(input.duplicateFaces, 'copy of a face', 'copies of faces');
  left(input.cancelledFaces, 'face back to back', 'faces back to back');
  left(input.degenerateFaces, 'face without area', 'faces without area');
  left(output.droppedParts, 'part');
  left(output.droppedCrumbs, 'sliver beside closed holes', 'slivers beside closed holes');
  return done.length === 0 ? '' : `Done about it: ${list.format(done)}.`;
}
