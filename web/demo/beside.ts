// SPDX-License-Identifier: MIT
// Levels kept beside the result, each in a view of its own that the same camera looks at.
import { element } from './element';
import type { Level } from './levels';
import type { Stage } from './scene';

const number = new Intl.NumberFormat('en');
const decimal = new Intl.NumberFormat('en', { maximumSignificantDigits: 2 });

// So many more than input and result.
const most = 4;

export class Beside {
  #kept: { level: Level; section: HTMLElement }[] = [];

  /** `onChange` is called whenever a view has come or gone. */
  constructor(
    readonly stage: Stage,
    readonly onChange: () => void,
  ) {}

  /** Keeps a level in view. */
  keep(level: Level): void {
    if (this.#kept.some((kept) => kept.level === level)) return;
    const section = this.#sectionOf(level);
    element('stage').append(section);
    this.#kept.push({ level, section });
    this.#arrange();
    this.stage.addView(section, level.mesh);
    this.onChange();
  }

  /** The level's distance from the result has become known. */
  tell(level: Level): void {
    const words = this.#kept.find((kept) => kept.level === level)?.section.querySelector('p');
    if (words) words.textContent = captionOf(level);
  }

  /** Takes all away. */
  clear(): void {
    if (this.#kept.length === 0) return;
    for (const { section } of this.#kept.splice(0)) this.#drop(section);
    this.#arrange();
    this.onChange();
  }

  #remove(level: Level): void {
    const gone = this.#kept.find((kept) => kept.level === level);
    if (gone === undefined) return;
    this.#kept = this.#kept.filter((kept) => kept !== gone);
    this.#drop(gone.section);
    this.#arrange();
    element('level-keep').focus();
    this.onChange();
  }

  #drop(section: HTMLElement): void {
    section.remove();
    this.stage.removeView(section);
  }

  // Style sheets go by the number of views.
  #arrange(): void {
    element('stage').dataset.views = String(2 + this.#kept.length);
    element<HTMLButtonElement>('level-keep').disabled = this.#kept.length >= most;
  }

  #sectionOf(level: Level): HTMLElement {
    const section = document.createElement('section');
    const triangles = `${number.format(level.triangles)} triangles`;
    section.className = 'view';
    section.ariaLabel = `Level of ${triangles}`;
    const head = document.createElement('h2');
    head.textContent = 'Level';
    const remove = document.createElement('button');
    remove.type = 'button';
    remove.className = 'link';
    remove.textContent = 'Remove';
    remove.ariaLabel = `Remove the level of ${triangles}`;
    remove.addEventListener('click', () => this.#remove(level));
    const words = document.createElement('p');
    words.textContent = captionOf(level);
    section.append(head, words, remove);
    return section;
  }
}

function captionOf({ triangles, apart }: Level): string {
  const error = apart ? `, error ${decimal.format(apart)}` : '';
  return `${number.format(triangles)} triangles${error}`;
}
