// SPDX-License-Identifier: MIT
// The legend of what is painted on input and result; its entries switch it on and off.
import { element } from './element';
import type { Finding, Kind } from './findings';

/** What is painted in which colour, on light and on dark ground alike; names are for the legend. */
export const paints: Record<Kind, { name: string; colour: string }> = {
  open: { name: 'Open edges', colour: '#e3002d' },
  crowded: { name: 'Edges of three or more faces', colour: '#d400c8' },
  pinched: { name: 'Pinched vertices', colour: '#00a7d6' },
  disagreeing: { name: 'Edges whose faces disagree', colour: '#5a00e0' },
  flipped: { name: 'Faces turned the wrong way', colour: '#8b4dff' },
  doubled: { name: 'Doubled faces', colour: '#12a150' },
  degenerate: { name: 'Faces without area', colour: '#00b3a4' },
  crossing: { name: 'Crossing faces', colour: '#f5b400' },
  lost: { name: 'Missing from the result', colour: '#d0021b' },
  unresolved: { name: 'Spots where the topology was given up', colour: '#ff8a00' },
  invented: { name: 'New faces that close holes', colour: '#77b300' },
};

const number = new Intl.NumberFormat('en');
// What was switched off stays so with the next model.
const hidden = new Set<Kind>();

/** Lists the findings; `onToggle` is told what is to be seen, now and whenever that changes. */
export function showLegend(
  findings: Finding[],
  onToggle: (kind: Kind, visible: boolean) => void,
): void {
  const legend = element('legend');
  legend.hidden = findings.length === 0;
  legend.replaceChildren(
    ...legend.querySelectorAll('legend'),
    ...findings.map((finding) => entry(finding, onToggle)),
  );
  for (const { kind } of findings) onToggle(kind, !hidden.has(kind));
}

function entry(
  { kind, count, shape }: Finding,
  onToggle: (kind: Kind, visible: boolean) => void,
): HTMLElement {
  const label = document.createElement('label');
  const box = document.createElement('input');
  box.type = 'checkbox';
  box.checked = !hidden.has(kind);
  box.dataset.kind = kind;
  box.addEventListener('change', () => {
    if (box.checked) hidden.delete(kind);
    else hidden.add(kind);
    onToggle(kind, box.checked);
  });
  const swatch = document.createElement('span');
  swatch.className = `swatch ${shape}`;
  swatch.style.setProperty('--paint', paints[kind].colour);
  label.append(box, swatch, `${paints[kind].name} (${number.format(count)})`);
  return label;
}
