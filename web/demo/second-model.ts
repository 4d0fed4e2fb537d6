// SPDX-License-Identifier: MIT
// The second model of Boolean operations: where it comes from, where it is, what is made of the two.
import { Vector3 } from 'three';
import type { BooleanOperation, MeshInput, Warning } from 'kdmanifold';
import { element } from './element';
import type { Gizmo, GizmoMode } from './gizmo';
import { samples } from './models';

/** What is joined with the input, and how. */
export interface Joined {
  name: string;
  mesh: MeshInput;
  warnings: Warning[];
  operation: BooleanOperation;
  transform: number[];
}

/** A ball round the input. */
export interface Ball {
  centre: Vector3;
  radius: number;
}

// Beside the input's middle, and smaller: so that the two share something, and not all.
const sampleSize = 0.6;
const sampleOffset = 0.5;

export class SecondModel {
  readonly #sample = element<HTMLSelectElement>('second-sample');
  readonly #file = element<HTMLInputElement>('second-file');
  readonly #fields = ['x', 'y', 'z'].map((axis) => element<HTMLInputElement>(`second-${axis}`));
  #model: { name: string; mesh: MeshInput; warnings: Warning[] } | null = null;
  #mode: GizmoMode = 'translate';
  #asked = 0;

  /**
   * `onChange` is called when another result is wanted, `read` makes a mesh of a file, `around` says where the input
   * is.
   */
  constructor(
    readonly gizmo: Gizmo,
    readonly read: (file: File) => Promise<MeshInput & { warnings: Warning[] }>,
    readonly around: () => Ball,
    readonly onChange: () => void,
    readonly onError: (error: unknown) => void,
  ) {
    this.#sample.append(...samples.map(({ name }) => new Option(name)));
    this.#sample.addEventListener('change', () => this.#takeSample());
    this.#file.addEventListener('change', () => void this.#takeFile().catch(onError));
    element('operation').addEventListener('change', onChange);
    for (const radio of document.querySelectorAll<HTMLInputElement>('[name="second-mode"]')) {
      radio.addEventListener('change', () => {
        this.#mode = radio.value as GizmoMode;
        gizmo.setMode(this.#mode);
        this.update();
      });
    }
    this.#fields.forEach((field, axis) => {
      field.addEventListener('input', () => this.#move(field, axis));
    });
    element('second-remove').addEventListener('click', () => {
      this.forget();
      this.#sample.focus();
      onChange();
    });
  }

  /** What is to be joined with the input; null: nothing. */
  get joined(): Joined | null {
    if (this.#model === null) return null;
    const operation = element<HTMLSelectElement>('operation').value as BooleanOperation;
    return { ...this.#model, operation, transform: this.gizmo.transform };
  }

  /** Takes the model away. */
  forget(): void {
    ++this.#asked;
    this.#sample.selectedIndex = 0;
    this.#file.value = '';
    this.#show(null);
  }

  /** The fields say what the handles did. */
  update(): void {
    element('second-hint').textContent = {
      translate: "Where its middle is, in the model's units.",
      rotate: 'Degrees about each axis.',
      scale: 'How many times as large, along each of its axes.',
    }[this.#mode];
    // Four digits, of places as many as the input's size calls for.
    const unit =
      this.#mode === 'translate' ? 10 ** Math.floor(Math.log10(this.around().radius)) : 1;
    const step = unit / 1000;
    this.gizmo.read(this.#mode).forEach((value, i) => {
      const field = this.#fields[i] as HTMLInputElement;
      if (field === document.activeElement) return;
      field.value = String(Number((Math.round(value / step) * step).toPrecision(12)));
      field.removeAttribute('aria-invalid');
    });
  }

  #takeSample(): void {
    ++this.#asked;
    const sample = samples[this.#sample.selectedIndex - 1];
    this.#file.value = '';
    this.#show(sample ? { name: sample.name, mesh: sample.make(), warnings: [] } : null);
    if (sample !== undefined) {
      const { centre, radius } = this.around();
      const place = centre.clone().add(new Vector3(sampleOffset * radius, 0, 0));
      this.gizmo.fit(sampleSize * radius, place);
      this.update();
    }
    this.onChange();
  }

  async #takeFile(): Promise<void> {
    const [file] = this.#file.files ?? [];
    if (file === undefined) return;
    const asked = ++this.#asked;
    const { warnings, ...mesh } = await this.read(file);
    if (asked !== this.#asked) return;
    this.#sample.selectedIndex = 0;
    // Files of one kind tend to share their coordinates: it stays where it is.
    this.#show({ name: file.name, mesh, warnings });
    this.onChange();
  }

  #show(model: { name: string; mesh: MeshInput; warnings: Warning[] } | null): void {
    this.#model = model;
    element('second-controls').hidden = model === null;
    element('second-name').textContent = model === null ? '' : `and ${model.name}`;
    this.gizmo.show(model && model.mesh);
    this.update();
  }

  // Only along one axis: fields show rounded values, and the model is not to be moved by that.
  #move(field: HTMLInputElement, axis: number): void {
    const value = field.valueAsNumber;
    // Nothing is scaled to nothing.
    const valid = Number.isFinite(value) && (this.#mode !== 'scale' || value !== 0);
    field.setAttribute('aria-invalid', String(!valid));
    if (!valid) return;
    const values = this.gizmo.read(this.#mode);
    values[axis] = value;
    this.gizmo.write(this.#mode, values);
    this.onChange();
  }
}
