// SPDX-License-Identifier: MIT
// The handle of solids that are moved, in WebAssembly memory.
import { call, type Health } from './call.js';
import { dispose } from './dispose.js';
import { KdManifoldError } from './errors.js';
import { Grid } from './grid.js';
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

/** @internal What frees handles that were forgotten. */
export type Registry = FinalizationRegistry<{ delete(): void }>;

/**
 * Solids of which some are moved, and what an expression says of them: fast enough to drag them. Every result is that of
 * a new operation, to the byte; only what has changed is done again. It holds memory outside of JavaScript's reach: call
 * `delete()` when done with it (or declare it with `using`).
 */
export class BooleanScene {
  #raw: RawScene | null;
  readonly #operands: number;
  readonly #shares: Shares;
  readonly #registry: Registry;
  readonly #health: Health;

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
    this.#raw = raw;
    this.#operands = operands;
    this.#shares = shares;
    this.#registry = registry;
    this.#health = health;
    registry.register(this, raw, this);
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
    const raw = this.#demand();
    const checked = checkPlace(operand, transform, this.#operands);
    call(this.#health, undefined, () => raw.place(operand, checked));
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
    const raw = this.#demand();
    const { grid, ...made } = call(this.#health, onProgress, (progress) =>
      raw.make(stepsOf(progress, this.#shares, onStep)),
    );
    return { ...made, grid: Grid.of(grid, this.#registry, this.#health) };
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
    if (this.#raw === null) return;
    this.#registry.unregister(this);
    if (!this.#health.broken) this.#raw.delete();
    this.#raw = null;
  }

  /** The same as `delete()`, for `using`. */
  [dispose](): void {
    this.delete();
  }

  #demand(): RawScene {
    if (this.#raw === null) {
      throw new KdManifoldError('DELETED', 'this scene has been deleted');
    }
    return this.#raw;
  }
}
