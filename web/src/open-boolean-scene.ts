// SPDX-License-Identifier: MIT
// Solids that are moved, in a worker of their own.
import type { BooleanOptions } from './boolean.js';
import { checkMakeOptions } from './check-input.js';
import { fulfil, type Kept, type Outcome, type SceneOrder } from './convert.js';
import { aborted, KdManifoldError } from './errors.js';
import type { BooleanExpression, BooleanOperation } from './expression.js';
import { jobKeys, jobOf, ownMesh, refuse, type JobOptions } from './job.js';
import { loadMain } from './load.js';
import type { Source } from './load-options.js';
import { checkPlace, checkSolids, solidKeys, type Solid } from './solids.js';
import type { Conversion, MeshInput } from './types.js';
import { converse } from './worker/converse.js';
import { end, open } from './worker/pool.js';
import type { WorkerPort } from './worker/protocol.js';

/** How one result is heard of, and stopped. */
export type SceneJobOptions = Pick<JobOptions, 'onProgress' | 'signal'>;

const sceneKeys = jobKeys.filter((key) => key !== 'onProgress' && key !== 'signal');

/** All that are open. */
const openScenes = new Set<OpenBooleanScene>();

/**
 * Solids that are kept in a worker of their own, outside of the line that `concurrency` speaks of, until `close`. Where
 * there are no workers they are kept on the calling thread.
 */
export class OpenBooleanScene {
  readonly #setup: NonNullable<SceneOrder['setup']>;
  readonly #source: Source;
  readonly #kept: Kept = {};
  /** Where the operands are to go that were moved since the last result. */
  readonly #moved = new Map<number, Float64Array | null>();
  #port: Promise<WorkerPort | null> | null = null;
  #last: Promise<unknown> = Promise.resolve();
  #isSetUp = false;
  #isClosed = false;
  #stop: (() => void) | null = null;

  /** @internal */
  static of(setup: NonNullable<SceneOrder['setup']>, source: Source): OpenBooleanScene {
    return new OpenBooleanScene(setup, source);
  }

  private constructor(setup: NonNullable<SceneOrder['setup']>, source: Source) {
    this.#setup = setup;
    this.#source = source;
    openScenes.add(this);
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
   * import { openBooleanScene } from 'kdmanifold';
   *
   * const part = { positions, indices };
   * const scene = openBooleanScene('union', [part, part]);
   * scene.place(1, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 1]);
   * const { mesh } = await scene.make();
   * scene.close();
   * ```
   */
  place(operand: number, transform: ArrayLike<number> | null): void {
    this.#demand();
    const { solids } = this.#setup.subject;
    const checked = checkPlace(operand, transform, solids.length);
    this.#moved.set(operand, checked);
    (solids[operand] as Solid).transform = checked; // for another worker
  }

  /**
   * Makes the result with the operands where they are by then. Calls wait for each other.
   *
   * @param options - how to be told and stopped. What is stopped in a worker is set up anew for the next result, which
   *   takes as long as the first: to drop a result that is out of date, leave it alone.
   * @returns the mesh and the account, as `boolean` gives them
   * @throws {@link KdManifoldError} with what `boolean` throws, or `DELETED`
   *
   * @example
   * ```js
   * import { openBooleanScene } from 'kdmanifold';
   *
   * const part = { positions, indices };
   * const scene = openBooleanScene('union', [part, part]);
   * const { mesh } = await scene.make();
   * console.log(mesh.indices.length / 3);
   * scene.close();
   * ```
   */
  make(options: SceneJobOptions = {}): Promise<Conversion> {
    const made = this.#last.then(() => this.#make(options));
    this.#last = made.catch(() => {});
    return made;
  }

  /**
   * Moves an operand and makes the result.
   *
   * @param operand - its number, counted from 0
   * @param transform - where it goes, as in the option `transforms`; null: where its mesh has it
   * @param options - as for `make`
   * @returns the mesh and the account, as `boolean` gives them
   * @throws {@link KdManifoldError} with what `boolean` throws, or `DELETED`
   *
   * @example
   * ```js
   * import { openBooleanScene } from 'kdmanifold';
   *
   * const part = { positions, indices };
   * const scene = openBooleanScene('difference', [part, part], { reduce: false });
   * for (const x of [0.3, 0.4, 0.5]) {
   *   const { mesh } = await scene.update(1, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, 0, 0, 1]);
   *   console.log(mesh.indices.length / 3);
   * }
   * scene.close();
   * ```
   */
  async update(
    operand: number,
    transform: ArrayLike<number> | null,
    options: SceneJobOptions = {},
  ): Promise<Conversion> {
    this.place(operand, transform);
    return this.make(options);
  }

  /**
   * Ends the worker; what is under way rejects with `ABORTED`. Calling it again does nothing.
   *
   * @example
   * ```js
   * import { openBooleanScene } from 'kdmanifold';
   *
   * const part = { positions, indices };
   * const scene = openBooleanScene('union', [part, part]);
   * await scene.make();
   * scene.close();
   * ```
   */
  close(): void {
    openScenes.delete(this);
    this.#isClosed = true;
    this.#stop?.();
    this.#forget();
  }

  async #make(options: SceneJobOptions): Promise<Conversion> {
    this.#demand();
    const { signal, onProgress } = jobOf(options);
    const port = await (this.#port ??= this.#open()).catch((error: unknown) => {
      this.#forget();
      throw error;
    });
    this.#demand();
    if (signal?.aborted) throw aborted(signal);
    const order: SceneOrder = {
      type: 'scene',
      setup: this.#isSetUp ? null : this.#setup,
      places: [...this.#moved],
    };
    this.#moved.clear();
    const outcome = await (port === null
      ? this.#makeHere(order, { signal, onProgress })
      : this.#makeThere(port, order, { signal, onProgress }));
    this.#isSetUp = true;
    return outcome as Conversion;
  }

  #open(): Promise<WorkerPort | null> {
    return this.#source.worker === false ? Promise.resolve(null) : open(this.#source);
  }

  async #makeHere(order: SceneOrder, { signal, onProgress }: SceneJobOptions): Promise<Outcome> {
    const library = await loadMain(this.#source);
    try {
      return fulfil(
        library,
        order,
        (fraction, phase) => (signal?.aborted ? false : onProgress?.(fraction, phase)),
        this.#kept,
      );
    } catch (error) {
      if (library.broken) this.#forget();
      throw signal?.aborted ? aborted(signal) : error;
    }
  }

  async #makeThere(
    port: WorkerPort,
    order: SceneOrder,
    { signal, onProgress }: SceneJobOptions,
  ): Promise<Outcome> {
    port.hold(true);
    const talk = converse(port, { order, transfer: [], source: this.#source, signal, onProgress });
    const onAbort = (): void => talk.stop(aborted(signal));
    signal?.addEventListener('abort', onAbort);
    this.#stop = () => talk.stop(aborted());
    try {
      const outcome = await talk.outcome;
      port.hold(false);
      // It may die unnoticed between two results.
      port.listen(
        () => {},
        () => this.#forget(),
      );
      return outcome;
    } catch (error) {
      if (talk.fit()) port.hold(false);
      else this.#forget();
      throw error;
    } finally {
      this.#stop = null;
      signal?.removeEventListener('abort', onAbort);
    }
  }

  // The next result begins with a new worker.
  #forget(): void {
    this.#port?.then(
      (port) => port && end(port),
      () => {},
    );
    this.#port = null;
    this.#isSetUp = false;
    this.#kept.scene?.delete();
    delete this.#kept.scene;
  }

  #demand(): void {
    if (this.#isClosed) throw new KdManifoldError('DELETED', 'this scene has been closed');
  }
}

/**
 * Keeps meshes and what an expression says of them in a worker, so that each can be moved and the result made again in a
 * fraction of the time: what is dragged is seen at once. Results are those of `boolean`, to the byte. The worker starts
 * with the first result.
 *
 * Cells stay where nothing has changed as long as the bounding box of all operands does. What must be fast should not be
 * reduced: `reduce: false`, and `strict: 'manifold'` if triangles may cross meanwhile.
 *
 * @param expression - an operation, which joins all operands from left to right, or an expression over their numbers
 * @param operands - the meshes; their arrays are copied unless `transfer` is set
 * @param options - all that `boolean` can be told, but for `onProgress` and `signal`, which each result has of its own
 * @returns the scene, which holds memory until `close()`
 * @throws {@link KdManifoldError} with `INVALID_MESH`, `INVALID_OPTION`; what else is wrong with the operands turns up with
 *   the first result
 *
 * @example
 * ```js
 * import { openBooleanScene } from 'kdmanifold';
 *
 * const part = { positions, indices };
 * const scene = openBooleanScene('difference', [part, part], { reduce: false });
 * const { mesh } = await scene.update(1, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 1]);
 * console.log(mesh.indices.length / 3, mesh.sourceOperands);
 * scene.close();
 * ```
 */
export function openBooleanScene(
  expression: BooleanOperation | BooleanExpression,
  operands: readonly MeshInput[],
  options: Omit<BooleanOptions, keyof SceneJobOptions> = {},
): OpenBooleanScene {
  if (typeof options !== 'object' || options === null) {
    throw new KdManifoldError('INVALID_OPTION', 'options: expected an object');
  }
  const checked = checkSolids(expression, operands, options);
  const made = checkMakeOptions(options, [...solidKeys, ...sceneKeys]);
  const { source } = jobOf(options);
  if (typeof source.worker === 'object') {
    refuse('worker', 'a function that starts workers: a scene has one of its own');
  }
  const solids = checked.solids.map((solid) => ({ ...solid, ...ownMesh(solid, options) }));
  return OpenBooleanScene.of({ ...made, subject: { ...checked, solids } }, source);
}

/** @internal Closes all scenes. */
export function closeScenes(): void {
  for (const scene of openScenes) scene.close();
}
