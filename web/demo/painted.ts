// SPDX-License-Identifier: MIT
// The result on the stage, what is painted on it and on the input, and the legend of that.
import type { Mesh, MeshInput, Report } from 'kdmanifold';
import { inventedOf, lostOf, unresolvedOf, type DefectKind, type Finding } from './findings';
import { showLegend } from './legend';
import type { Stage } from './scene';

export class Painted {
  // What is wrong with the input.
  #defects: Finding<DefectKind>[] = [];
  // What a conversion has to say, of the input and of its result.
  #missing: Finding[] = [];
  #spots: Finding[] = [];
  #invented: Finding[] = [];

  constructor(readonly stage: Stage) {}

  /** What is known to be wrong with the input. */
  get defects(): readonly Finding<DefectKind>[] {
    return this.#defects;
  }

  /** A new input, of which nothing is known. */
  forget(): void {
    this.#defects = [];
    this.showResult(null);
  }

  /** Something else is wrong with the input. */
  add(defects: Finding<DefectKind>[]): void {
    this.#defects.push(...defects);
    this.stage.paint('input', defects);
    this.#showLegend();
  }

  /** Shows a result, or none; of a rough one nothing is known. */
  showResult(mesh: Mesh | null, about?: { input: MeshInput; report: Report }): void {
    this.#missing = about ? lostOf(about.input, about.report) : [];
    this.#spots = about ? unresolvedOf(about.report) : [];
    this.stage.unpaint('input', 'lost');
    this.stage.paint('input', this.#missing);
    this.showInstead(mesh);
  }

  /** Shows a level of the result in its place. */
  showInstead(mesh: Mesh | null): void {
    this.#invented = mesh ? inventedOf(mesh) : [];
    this.stage.show('output', mesh);
    this.stage.paint('output', [...this.#spots, ...this.#invented]);
    this.#showLegend();
  }

  // What is wrong with the result comes first, what is new in it last.
  #showLegend(): void {
    const all = [...this.#missing, ...this.#spots, ...this.#defects, ...this.#invented];
    showLegend(all, (kind, visible) => this.stage.showPaint(kind, visible));
  }
}
