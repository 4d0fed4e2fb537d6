// SPDX-License-Identifier: MIT
// Colours the result, and levels beside it, by how far each spot is from the input.
import type { Mesh } from 'kdmanifold';
import { element } from './element';
import type { Heat } from './measure';
import type { Measurer } from './measurer';
import type { Stage } from './scene';

const decimal = new Intl.NumberFormat('en', { maximumSignificantDigits: 2 });

export class HeatPanel {
  readonly #box = element<HTMLInputElement>('heat');
  // What has been measured, as long as its mesh is there.
  #measured = new WeakMap<object, Heat>();
  #asked = 0;

  /** `onError` is told why nothing could be measured. */
  constructor(
    readonly stage: Stage,
    readonly measurer: Measurer,
    readonly onError: (error: unknown) => void,
  ) {
    this.#box.addEventListener('change', () => this.refresh());
  }

  /** A new input, from which all is measured anew. */
  forget(): void {
    this.#measured = new WeakMap();
    this.refresh();
  }

  /** What is shown has changed. */
  refresh(): void {
    this.#refresh().catch(this.onError);
  }

  async #refresh(): Promise<void> {
    const asked = ++this.#asked;
    const meshes = this.#box.checked ? this.stage.results() : [];
    if (meshes.length === 0) {
      this.stage.setHeat(new Map(), 1);
      element('heat-legend').hidden = true;
      return;
    }
    const heats = new Map<Mesh, Heat>();
    for (const mesh of meshes) {
      heats.set(mesh, await this.#heatOf(mesh));
      if (asked !== this.#asked) return;
    }
    // One scale for all, so that they can be compared.
    const largest = Math.max(...[...heats.values()].map((heat) => heat.largest));
    this.stage.setHeat(heats, largest);
    [0, largest / 2, largest].forEach((value, i) => {
      element(`heat-${i}`).textContent = decimal.format(value);
    });
    element('heat-legend').hidden = false;
  }

  async #heatOf(mesh: Mesh): Promise<Heat> {
    const known = this.#measured.get(mesh);
    if (known !== undefined) return known;
    const heat = await this.measurer.heat(mesh, 'input');
    this.#measured.set(mesh, heat);
    return heat;
  }
}
