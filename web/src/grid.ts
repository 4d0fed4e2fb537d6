// SPDX-License-Identifier: MIT
// The handle of a grid that lives in WebAssembly memory.
import { call, type Health } from './call.js';
import {
  checkCompareOptions,
  checkExtractOptions,
  checkMesh,
  checkPolygonMesh,
  checkReduceOptions,
  checkSimplifyOptions,
  type CheckedReduction,
} from './check-input.js';
import { dispose } from './dispose.js';
import { KdManifoldError } from './errors.js';
import { postfix, type BooleanExpression, type BooleanOperation } from './expression.js';
import { Held, type Registry } from './held.js';
import type { RawGrid, RawMade } from './kdmanifold.js';
import { stepsOf, type Shares, type StepOptions } from './steps.js';
import type {
  Account,
  CompareOptions,
  ExtractedMesh,
  ExtractOptions,
  GridStats,
  GroupOptions,
  InputReport,
  MeshInput,
  PolygonMeshInput,
  ProgressOptions,
  ReduceOptions,
  SimplifyOptions,
  SimplifyReport,
} from './types.js';
import type { OwnUint8Array } from './outside-types.js';

// Where the steps of a reduced extraction begin and end.
const extractShares: Shares = { extract: [0, 0.2], reduce: [0.2, 1] };

/**
 * The kd-tree of a mesh, from which surfaces are extracted. It holds memory outside of JavaScript's
 * reach: call `delete()` when done with it (or declare it with `using`). Forgotten grids are freed
 * some time after they have become unreachable.
 */
export class Grid {
  readonly #held: Held<RawGrid>;

  /** @internal */
  static of(raw: RawGrid, registry: Registry, health: Health): Grid {
    return new Grid(raw, registry, health);
  }

  private constructor(raw: RawGrid, registry: Registry, health: Health) {
    this.#held = new Held(this, raw, 'grid', registry, health);
  }

  /** What the grid was built from. */
  get input(): InputReport {
    return this.#held.get().input();
  }

  /** What the operands of Boolean operations are; empty if the grid was built from one mesh. */
  get operands(): InputReport[] {
    return this.#held.get().operands();
  }

  /** The size of the grid. */
  get stats(): GridStats {
    return this.#held.get().stats();
  }

  /**
   * Makes the surface of the grid: closed, oriented outwards, 2-manifold. Of a `sheet` it is a 2-manifold
   * with boundary, turned as the input is. The grid stays as it is.
   *
   * With `reduce: { error, targetTriangles, keepGroups }` the result is embedded, and edges of it are collapsed as long as it stays
   * within `error` of the grid's own surface, down to the numbers of triangles asked for. (`makeManifold` does so within
   * the tolerance of the input.)
   *
   * @param options - what the result must be like, and a callback for progress
   * @returns the mesh, whose arrays are the caller's, and the account of how it was made
   * @throws {@link KdManifoldError} with `INVALID_OPTION`, `EMPTY_RESULT`, `OUT_OF_MEMORY`, `ABORTED`, `DELETED`
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * const grid = (await load()).buildGrid({ positions, indices });
   * const mesh = grid.extract({ normals: true });
   * console.log(mesh.indices.length / 3, mesh.report.crossings);
   * grid.delete();
   * ```
   */
  extract(
    options: ExtractOptions & ProgressOptions & { reduce?: ReduceOptions & GroupOptions } = {},
  ): ExtractedMesh {
    const raw = this.#held.get();
    const checked = checkExtractOptions(options, ['onProgress', 'reduce']);
    if (options.reduce !== undefined) {
      const reduce = checkReduceOptions(options.reduce, []);
      return call(this.#held.health, options.onProgress, (progress) =>
        raw.extractReduced(checked, reduce, stepsOf(progress, extractShares)),
      );
    }
    return call(this.#held.health, options.onProgress, (progress) =>
      raw.extract(checked, progress),
    );
  }

  /**
   * @internal Makes the result of a loaded grid as the command lines do: reduced if the grid was built for it. Frees the
   * grid if that fails.
   */
  make(
    extract: ExtractOptions,
    reduction: CheckedReduction,
    { onProgress, onStep }: StepOptions,
  ): RawMade & { grid: Grid } {
    const raw = this.#held.get();
    const options = { ...extract, ...reduction };
    try {
      const made = call(this.#held.health, onProgress, (progress) =>
        raw.make(options, stepsOf(progress, {}, onStep)),
      );
      return { ...made, grid: this };
    } catch (error) {
      this.delete();
      throw error;
    }
  }

  /**
   * Makes the grid smaller: splits of the kd-tree are removed, the cheapest first, as long as no part of the surface and
   * no handle comes or goes and the surface stays within `surfaceError` of what it was when the grid was built (section 4
   * of the paper). The grid then takes less memory and fewer bytes, and `extract` makes fewer triangles of it. For few
   * triangles alone, `extract({ reduce })` does far more. Vertices that `extract` adds are not tested: where a grid was
   * stopped by its depth, those between cells (`linkError`) may be further off.
   *
   * With `removedMaterial` or `addedMaterial`, thin bodies go first, or thin cavities are filled, and are counted: the
   * grid's surface then has `removedSurfaces` closed surfaces and `removedHandles` handles less, crumbs included, which
   * `extract` leaves out anyway. No other change of topology is ever taken: bars are not cut, tunnels and gaps that lead
   * outside stay open. The distance holds for what is left.
   *
   * Calls add up: another one with the same `surfaceError` removes no split, one with a larger goes on; what is thin goes
   * in any call. If the call throws, the grid is what it was.
   *
   * @param options - `surfaceError`, which must be above 0, further limits, how thin is thin, and a callback for progress
   * @returns what was removed, and how far the surface may now be from what it was
   * @throws {@link KdManifoldError} with `INVALID_OPTION`, `EMPTY_RESULT`, `OUT_OF_MEMORY`, `ABORTED`, `DELETED`
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * const grid = (await load()).buildGrid({ positions, indices });
   * const { cellsBefore, cells } = grid.simplify({ surfaceError: 0.01 });
   * console.log(cellsBefore, cells, grid.save().length);
   * grid.delete();
   * ```
   */
  simplify(options: SimplifyOptions & ProgressOptions): SimplifyReport {
    const raw = this.#held.get();
    const checked = checkSimplifyOptions(options);
    return call(this.#held.health, options.onProgress, (progress) =>
      raw.simplify(checked, progress),
    );
  }

  /**
   * Holds a result against the mesh that the grid was built from: what of the mesh the result does not come near and,
   * on request, how far the two are apart.
   *
   * @param input - the mesh that was given to `buildGrid`
   * @param result - what `extract` made of the grid
   * @param options - `error`: measure distances too
   * @returns what is lost, the distances or null, and a warning if much is lost
   * @throws {@link KdManifoldError} with `INVALID_MESH`, `INVALID_OPTION`, `OUT_OF_MEMORY`, `DELETED`
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * const grid = (await load()).buildGrid({ positions, indices });
   * const { lost, error } = grid.compare({ positions, indices }, grid.extract(), { error: true });
   * console.log(lost.area, error.toInput.largest, error.toOutput.largest);
   * grid.delete();
   * ```
   */
  compare(input: MeshInput, result: PolygonMeshInput, options: CompareOptions = {}): Account {
    const raw = this.#held.get();
    const { error = false } = checkCompareOptions(options);
    const [from, to] = [checkMesh(input), checkPolygonMesh(result)];
    return call(this.#held.health, undefined, () => raw.compare(from, to, error));
  }

  /**
   * Makes the grid of what an operation says of this grid's solid and another one's, without their meshes: grids that were
   * built, merged, simplified or loaded serve alike. Both must have been built with the same `box`. Where one of them alone
   * has surface, its cells and hits are taken over as they are; where both have, the surfaces that the grids span are cut
   * with each other within the wider of both tolerances. The result is always a valid grid, of which `extract` makes a
   * closed 2-manifold; where both have surface its topology is not certified, so `stats.topologyResolved` is then false,
   * and surfaces nearer than the tolerance may leave slivers and gaps thinner than that. Both grids stay as they are.
   *
   * @param other - the other grid, of the same instance of the library
   * @param expression - an operation, which joins this grid and the other one, or an expression over their numbers 0 and 1
   * @param options - a callback for progress
   * @returns the grid, which holds memory until `delete()`
   * @throws {@link KdManifoldError} with `INVALID_OPTION`, `EMPTY_RESULT`, `OUT_OF_MEMORY`, `ABORTED`, `DELETED`
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * const kdm = await load();
   * const box = [-10, -10, -10, 10, 10, 10]; // the lowest corner and the highest
   * const part = kdm.buildGrid({ positions, indices }, { box });
   * const merged = part.merge(kdm.loadGrid(part.save()), 'union');
   * console.log(merged.extract().indices.length / 3);
   * for (const grid of [part, merged]) grid.delete();
   * ```
   */
  merge(
    other: Grid,
    expression: BooleanOperation | BooleanExpression,
    options: ProgressOptions = {},
  ): Grid {
    const raw = this.#held.get();
    if (!(other instanceof Grid) || other.#held.health !== this.#held.health) {
      throw new KdManifoldError(
        'INVALID_OPTION',
        'other: expected a grid of the same instance of the library',
      );
    }
    const second = other.#held.get();
    const written = postfix(expression, 2);
    const { health, registry } = this.#held;
    const merged = call(health, options.onProgress, (progress) =>
      raw.merge(second, written, progress),
    );
    return Grid.of(merged, registry, health);
  }

  /**
   * Makes bytes of the grid, for `KdManifold.loadGrid`: build once, extract many times. The same grid gives
   * the same bytes everywhere; they take less than half of the memory that the grid holds.
   *
   * @returns the bytes
   * @throws {@link KdManifoldError} with `OUT_OF_MEMORY` or `DELETED`
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * const grid = (await load()).buildGrid({ positions, indices });
   * const bytes = grid.save();
   * console.log(bytes.length);
   * grid.delete();
   * ```
   */
  save(): OwnUint8Array {
    const raw = this.#held.get();
    return call(this.#held.health, undefined, () => raw.save());
  }

  /**
   * Frees the memory; calling it again does nothing, calling anything else throws `DELETED`.
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * const grid = (await load()).buildGrid({ positions, indices });
   * grid.delete();
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
