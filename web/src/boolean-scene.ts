// SPDX-License-Identifier: MIT
// The handle of solids that are moved, in WebAssembly memory.
import { call, type Health } from './call.js';
import { dispose } from './dispose.js';
import { Grid } from './grid.js';
import { Held, type Registry } from './held.js';
import type { RawMade, RawScene } from './kdmanifold.js';
import { checkPlace } from './solids.js';
import { stepsOf, type Shares, type StepOptions } from './steps.js';
import type { ExtractedMesh, GridStats, ProgressOptions, SimplifyReport } from './types.js';

/** What a scene gives. */
export interface SceneMesh extends ExtractedMesh {
  /** The size of the grid that it was made of. */
  stats: GridStats;
  /** With the option `simplify`: how far the grid was simplified; otherwise null. */
  simplify: SimplifyReport | null;
}

/**
 * Solids of which some are moved, and what an expression says of them: fast enough to drag them. Every result is that of
 * a new operation, to the byte; only what has changed is done again. It holds memory outside of JavaScript's reach: call
 * `delete()` when done with it (or declare it with `using`).
 */
export class BooleanScene {
  readonly #held: Held<RawScene>;
  readonly #operands: number;
  readonly #shares: Shares;

  /** @internal */
  static of(
    raw: RawScene,
    operands: number,
    shares: Shares,
    registry: Registry,
    health: Health,
  ): BooleanScene {
    return new BooleanScene(raw, operands, shares, registry, health);
  }

  private constructor(
    raw: RawScene,
    operands: number,
    shares: Shares,
    registry: Registry,
    health: Health,
  ) {
    this.#held = new Held(this, raw, 'scene', registry, health);
    this.#operands = operands;
    this.#shares = shares;
  }

  /**
   * Moves an operand, for the next result.
   *
   * @param operand - its number, counted from 0
   * @param transform - where it goes, as in the option `transforms`; null: where its mesh has it
   * @throws {@link KdManifoldError} with `INVALID_OPTION` or `DELETED`
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * const part = { positions, indices };
   * const scene = (await load()).booleanScene('union', [part, part]);
   * scene.place(1, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 1]);
   * console.log(scene.make().indices.length / 3);
   * scene.delete();
   * ```
   */
  place(operand: number, transform: ArrayLike<number> | null): void {
    const raw = this.#held.get();
    const checked = checkPlace(operand, transform, this.#operands);
    call(this.#held.health, undefined, () => raw.place(operand, checked));
  }

  /**
   * Makes the result with the operands where they are.
   *
   * @param options - a callback for progress
   * @returns the mesh, whose arrays are the caller's, and the account of how it was made
   * @throws {@link KdManifoldError} with what `boolean` throws, or `DELETED`
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * const part = { positions, indices };
   * const scene = (await load()).booleanScene('union', [part, part]);
   * console.log(scene.make().indices.length / 3);
   * scene.delete();
   * ```
   */
  make(options: ProgressOptions = {}): SceneMesh {
    const { grid, levels, reduce, ...made } = this.makeAll(options);
    grid.delete();
    return reduce === null ? made : { ...made, levels, reduce };
  }

  /**
   * Moves an operand and makes the result.
   *
   * @param operand - its number, counted from 0
   * @param transform - where it goes, as in the option `transforms`; null: where its mesh has it
   * @param options - a callback for progress
   * @returns the mesh, whose arrays are the caller's, and the account of how it was made
   * @throws {@link KdManifoldError} with what `boolean` throws, or `DELETED`
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * const part = { positions, indices };
   * const scene = (await load()).booleanScene('difference', [part, part], { reduce: false });
   * for (const x of [0.3, 0.4, 0.5]) {
   *   const mesh = scene.update(1, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, 0, 0, 1]);
   *   console.log(mesh.indices.length / 3);
   * }
   * scene.delete();
   * ```
   */
  update(
    operand: number,
    transform: ArrayLike<number> | null,
    options: ProgressOptions = {},
  ): SceneMesh {
    this.place(operand, transform);
    return this.make(options);
  }

  /** @internal Makes the result with its grid, which is the caller's. */
  makeAll({ onProgress, onStep }: StepOptions): RawMade & { grid: Grid } {
    const raw = this.#held.get();
    const { grid, ...made } = call(this.#held.health, onProgress, (progress) =>
      raw.make(stepsOf(progress, this.#shares, onStep)),
    );
    return { ...made, grid: Grid.of(grid, this.#held.registry, this.#held.health) };
  }

  /**
   * Frees the memory; calling it again does nothing, calling anything else throws `DELETED`.
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * const part = { positions, indices };
   * const scene = (await load()).booleanScene('union', [part, part]);
   * scene.delete();
   * ```
   */
  delete(): void {
    this.#held.free();
  }

  /** The same as `delete()`, for `using`. */
  [dispose](): void {
    this.delete();
  }
}
