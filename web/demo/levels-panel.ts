// SPDX-License-Identifier: MIT
// The sliders that choose among levels of detail, by triangles or by distance. Levels are made when the
// panel is open, and made anew with each result.
import type { Mesh } from 'kdmanifold';
import { describeError } from './describe-error';
import { element } from './element';
import { makeLevels, type Level } from './levels';
import type { Measurer } from './measurer';

const number = new Intl.NumberFormat('en');
const decimal = new Intl.NumberFormat('en', { maximumSignificantDigits: 2 });

// A slider moves in bursts; meshes of each of its steps need not be drawn.
const settleMilliseconds = 80;
// The slider of distances is logarithmic.
const errorSteps = 100;

/** What the levels are made of: a result, how large its input is, and whether it can be reduced. */
export interface LevelSource {
  mesh: Mesh;
  /** The input's diagonal. */
  extent: number;
  closed: boolean;
}

export class LevelsPanel {
  readonly #panel = element<HTMLDetailsElement>('levels');
  readonly #triangles = element<HTMLInputElement>('level-triangles');
  readonly #error = element<HTMLInputElement>('level-error');
  #source: LevelSource | null = null;
  #levels: Level[] = [];
  #running: AbortController | null = null;
  #settling = 0;

  /** `onShow` is told which level is to be shown, `onMeasure` of which one the distance has become known. */
  constructor(
    readonly measurer: Measurer,
    readonly onShow: (level: Level, isFull: boolean) => void,
    readonly onMeasure: (level: Level) => void,
  ) {
    this.#panel.addEventListener('toggle', () => this.#makeIfOpen());
    this.#triangles.addEventListener('input', () => {
      this.#choose(this.#triangles.valueAsNumber);
      this.#placeError();
    });
    // It stays where it is put: the next level may be several steps away.
    this.#error.addEventListener('input', () => this.#choose(this.#within(this.#distance())));
    element('level-stop').addEventListener('click', () => this.#stop('Stopped.'));
    element('level-again').addEventListener('click', () => this.#makeIfOpen());
    this.take(null);
  }

  /** The level that is shown, if there are levels. */
  get shown(): Level | undefined {
    return this.#levels[this.#triangles.valueAsNumber];
  }

  /** What names of files say of the level that is shown; empty for the result itself. */
  get suffix(): string {
    const { shown } = this;
    return shown === undefined || shown.apart === 0 ? '' : `-${shown.triangles}`;
  }

  /** A new result, or none: what was made of the one before does not count any more. */
  take(source: LevelSource | null): void {
    this.#stop('');
    clearTimeout(this.#settling);
    this.#source = source;
    this.#levels = [];
    this.#say('');
    this.#update();
    this.#makeIfOpen();
  }

  #makeIfOpen(): void {
    if (!this.#panel.open || this.#levels.length > 0 || this.#running) return;
    if (this.#source === null) return;
    if (this.#reducible()) void this.#make(this.#source);
    else this.#say('Levels are made of closed results without quads.');
  }

  #reducible(): boolean {
    return this.#source !== null && this.#source.closed && this.#source.mesh.quads === undefined;
  }

  async #make({ mesh }: LevelSource): Promise<void> {
    const mine = (this.#running = new AbortController());
    const progress = element<HTMLProgressElement>('level-progress');
    progress.removeAttribute('value');
    this.#say('');
    this.#update();
    try {
      const { levels, warnings } = await makeLevels(mesh, mine.signal, (fraction) => {
        progress.value = fraction;
      });
      if (this.#running !== mine) return;
      this.#levels = levels;
      this.#triangles.max = String(levels.length - 1);
      this.#triangles.value = this.#triangles.max;
      this.#update();
      await this.#measure(mesh, mine);
      if (this.#running !== mine) return;
      this.#running = null;
      this.#update();
      this.#placeError();
      if (warnings.length > 0) this.#say(warnings.map(({ message }) => `${message}.`).join(' '));
    } catch (error) {
      if (this.#running !== mine) return;
      this.#running = null;
      this.#update();
      this.#say(describeError(error));
    }
  }

  // The one that is shown first, then from many triangles to few.
  async #measure(mesh: Mesh, mine: AbortController): Promise<void> {
    this.measurer.keep('result', mesh);
    const unknown = ({ apart }: Level): boolean => apart === null;
    for (;;) {
      const { shown } = this;
      const level = shown && unknown(shown) ? shown : this.#levels.findLast(unknown);
      if (level === undefined) return;
      const apart = await this.measurer.apart(level.mesh, 'result');
      if (this.#running !== mine) return;
      level.apart = apart;
      this.#update();
      this.onMeasure(level);
    }
  }

  #stop(reason: string): void {
    const running = this.#running;
    this.#running = null;
    running?.abort();
    if (running === null) return;
    this.#update();
    this.#say(reason);
  }

  #choose(index: number): void {
    this.#triangles.value = String(index);
    this.#update();
    clearTimeout(this.#settling);
    this.#settling = window.setTimeout(() => {
      const level = this.shown;
      if (level !== undefined) this.onShow(level, index === this.#levels.length - 1);
    }, settleMilliseconds);
  }

  // The distances of all levels but the result, none below 0.
  #range(): [number, number] | null {
    const known = this.#levels.map(({ apart }) => apart);
    if (known.length < 2 || known.includes(null)) return null;
    const distances = known.map(Number).filter((apart) => apart > 0);
    return distances.length === 0 ? null : [Math.min(...distances), Math.max(...distances)];
  }

  // What the slider of distances says; at its left end the result itself.
  #distance(): number {
    const [least, most] = this.#range() ?? [0, 0];
    const share = this.#error.valueAsNumber / errorSteps;
    return share === 0 ? 0 : least * (most / least) ** share * (1 + 1e-9);
  }

  // The level of the fewest triangles that is no further away.
  #within(distance: number): number {
    return this.#levels.findIndex(({ apart }) => (apart ?? Infinity) <= distance);
  }

  #update(): void {
    const level = this.shown;
    const range = this.#range();
    element('level-busy').hidden = this.#running === null || this.#levels.length > 0;
    element('level-again').hidden =
      this.#running !== null || this.#levels.length > 0 || !this.#reducible();
    element('level-sliders').hidden = level === undefined;
    this.#error.disabled = range === null;
    if (level === undefined) return;
    const { apart } = level;
    const triangles = number.format(level.triangles);
    element('level-triangles-value').textContent = triangles;
    this.#triangles.setAttribute('aria-valuetext', `${triangles} triangles`);
    const distance = apart === null ? 'measuring…' : this.#inUnits(apart);
    element('level-error-value').textContent = apart === null ? '…' : decimal.format(apart);
    this.#error.setAttribute('aria-valuetext', distance);
    element('level-story').textContent =
      apart === 0
        ? 'This is the full result.'
        : `${distance[0]?.toUpperCase()}${distance.slice(1)} from the full result.`;
  }

  // Puts the slider of distances to that of the level that is shown.
  #placeError(): void {
    const [range, apart] = [this.#range(), this.shown?.apart ?? 0];
    if (range === null) return;
    const [least, most] = range;
    const share = most > least ? Math.log(apart / least) / Math.log(most / least) : 1;
    // Up, so that it includes this very level.
    const place = apart > 0 ? Math.max(1, Math.ceil(share * errorSteps - 1e-6)) : 0;
    this.#error.value = String(place);
  }

  #inUnits(apart: number): string {
    const share = (100 * apart) / (this.#source?.extent ?? 1);
    return `at most ${decimal.format(apart)} units (${decimal.format(share)} % of the diagonal)`;
  }

  #say(message: string): void {
    element('level-message').textContent = message;
  }
}
