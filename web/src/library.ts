// SPDX-License-Identifier: MIT
// The synchronous interface: the loaded module with its functions.
import { BooleanScene } from './boolean-scene.js';
import { call, type Health } from './call.js';
import { isReduced } from './check-combination.js';
import {
  checkAnalyzeOptions,
  checkBuildOptions,
  checkMakeOptions,
  checkMesh,
  checkPolygonMesh,
  checkReduceOptions,
  type CheckedReduction,
} from './check-input.js';
import { toDefects } from './defects.js';
import { KdManifoldError } from './errors.js';
import type { BooleanExpression, BooleanOperation } from './expression.js';
import { Grid } from './grid.js';
import type { RawTools } from './kdmanifold-tools.js';
import type { RawMade, RawModule } from './kdmanifold.js';
import type { OwnUint8Array } from './outside-types.js';
import { checkSolids, solidKeys, type SolidOptions, type Solids } from './solids.js';
import { plainShares, reducedShares, stepsOf, type Shares, type StepOptions } from './steps.js';
import type {
  AnalyzeOptions,
  BuildOptions,
  ExtractOptions,
  FileMesh,
  GroupOptions,
  MeshDefects,
  MeshFormat,
  MeshInput,
  MeshReport,
  ParsedMesh,
  PolygonMeshInput,
  ProgressOptions,
  ReduceOptions,
  ReductionOptions,
  SelfIntersections,
  Simplified,
} from './types.js';

const formats: readonly string[] = ['obj', 'stl', 'ply', 'off'] satisfies MeshFormat[];

/**
 * Returns the format that a file name's extension stands for, in any case.
 *
 * @param path - a file's name, with or without folders
 * @returns the format, as `parseMesh` and `formatMesh` take it
 * @throws {@link KdManifoldError} with `IO_ERROR` for other extensions
 *
 * @example
 * ```js
 * import { formatFromPath } from 'kdmanifold';
 *
 * console.log(formatFromPath('parts/bracket.STL')); // stl
 * ```
 */
export function formatFromPath(path: string): MeshFormat {
  const extension = /\.([^./\\]+)$/.exec(path)?.[1]?.toLowerCase() ?? '';
  if (formats.includes(extension)) return extension as MeshFormat;
  throw new KdManifoldError(
    'IO_ERROR',
    `${path}: the file's name ends in none of .obj, .stl, .ply and .off`,
  );
}

/** Says whether this is the name of a saved grid: it ends in `.kdgrid` (any case). */
export function namesAGrid(path: string): boolean {
  return /\.kdgrid$/i.test(path);
}

/** Ends the threads of instances that nobody can use any more. */
const abandoned = new FinalizationRegistry<() => void>((end) => end());

/** The library, loaded: everything happens on the calling thread and is done when it returns. */
export class KdManifold {
  readonly #raw: RawModule;
  #tools: RawTools | null = null;
  #lack: Error | null = null;
  readonly #health: Health = { broken: false };
  readonly #registry = new FinalizationRegistry<{ delete(): void }>((raw) => {
    if (!this.#health.broken) raw.delete();
  });

  /** @internal */
  static of(raw: RawModule, threads = 1, endThreads?: () => void): KdManifold {
    return new KdManifold(raw, threads, endThreads);
  }

  private constructor(
    raw: RawModule,
    /** How many threads share the work of a call. */
    readonly threads: number,
    endThreads?: () => void,
  ) {
    this.#raw = raw;
    // Grids and scenes hold it, too.
    if (endThreads) abandoned.register(this.#health, endThreads);
  }

  /** @internal Whether file formats and `analyze` are there. */
  get hasTools(): boolean {
    return this.#tools !== null;
  }

  /** @internal Lets file formats and `analyze` be there. */
  takeTools(tools: RawTools): void {
    this.#tools = tools;
  }

  /** @internal Says why they are not. */
  lackTools(reason: Error): void {
    this.#lack = reason;
  }

  #demandTools(): RawTools {
    if (this.#tools !== null) return this.#tools;
    if (this.#lack !== null) throw this.#lack;
    throw new KdManifoldError(
      'LOAD_FAILED',
      'file formats and analyze were not asked for: load() without tools: false has them',
    );
  }

  /** @internal Whether a trap has made this instance unusable. */
  get broken(): boolean {
    return this.#health.broken;
  }

  /** The version of the package. */
  get version(): string {
    return this.#raw.version();
  }

  /**
   * Builds the grid of a mesh, whose shells may overlap, nest and intersect. With the default inside rule,
   * `repair`, the mesh may be open and its faces may disagree; `sheet` and `thicken` take any surface. The
   * other rules refuse meshes that are not closed and consistently oriented (`NOT_CLOSED`).
   *
   * @param mesh - the triangles; their arrays are read, not kept
   * @param options - how to split, what counts as inside, and a callback for progress
   * @returns the grid, which holds memory until `delete()`
   * @throws {@link KdManifoldError} with `INVALID_MESH`, `INVALID_OPTION`, `NOT_CLOSED`, `OUT_OF_MEMORY`, `ABORTED`
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * const grid = (await load()).buildGrid({ positions, indices }, { tolerance: 0.01 });
   * console.log(grid.stats.leaves, grid.stats.topologyResolved);
   * grid.delete();
   * ```
   */
  buildGrid(mesh: MeshInput, options: BuildOptions & ProgressOptions = {}): Grid {
    const checked = checkBuildOptions(options, ['onProgress']);
    const input = checkMesh(mesh);
    const raw = call(this.#health, options.onProgress, (progress) =>
      this.#raw.buildGrid(input, checked, progress),
    );
    return Grid.of(raw, this.#registry, this.#health);
  }

  /** @internal Does what `makeManifold` does, with options that were checked; the grid is the caller's. */
  make(
    mesh: MeshInput,
    options: BuildOptions & ExtractOptions & CheckedReduction,
    shares: Shares,
    { onProgress, onStep }: StepOptions,
  ): RawMade & { grid: Grid } {
    const input = checkMesh(mesh);
    const { grid, ...made } = call(this.#health, onProgress, (progress) =>
      this.#raw.makeManifold(input, options, stepsOf(progress, shares, onStep)),
    );
    return { ...made, grid: Grid.of(grid, this.#registry, this.#health) };
  }

  /** @internal Does what `boolean` does, with operands and options that were checked; the grid is the caller's. */
  makeSolids(
    { solids, expression }: Solids,
    options: BuildOptions & ExtractOptions & CheckedReduction,
    shares: Shares,
    { onProgress, onStep }: StepOptions,
  ): RawMade & { grid: Grid } {
    const { grid, ...made } = call(this.#health, onProgress, (progress) =>
      this.#raw.makeSolids(solids, expression, options, stepsOf(progress, shares, onStep)),
    );
    return { ...made, grid: Grid.of(grid, this.#registry, this.#health) };
  }

  /**
   * Reduces a mesh to fewer triangles: within a distance of it, to a number of triangles, or both; several numbers make
   * several levels of detail. Parts and handles stay, no two triangles cross. Vertices of equal position are joined
   * first, once positions are rounded to 32 bits; a mesh that is then closed, 2-manifold and crosses itself nowhere is
   * taken as it is, any other is first made so, as by `makeManifold`.
   *
   * @param mesh - the triangles, in whatever state; their arrays are read, not kept
   * @param options - `error` in model units, `targetTriangles`, `keepGroups`, and a callback for progress
   * @returns the mesh, the levels and the account
   * @throws {@link KdManifoldError} with `INVALID_MESH`, `INVALID_OPTION`, `NOT_CLOSED`, `EMPTY_RESULT`,
   * `OUT_OF_MEMORY`, `ABORTED`
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * const kdm = await load();
   * const { mesh, report } = kdm.simplifyMesh({ positions, indices }, { error: 0.01 });
   * console.log(report.trianglesBefore, mesh.indices.length / 3);
   * ```
   */
  simplifyMesh(
    mesh: MeshInput,
    options: ReduceOptions & GroupOptions & ProgressOptions,
  ): Simplified {
    const checked = checkReduceOptions(options, ['onProgress']);
    const input = checkMesh(mesh);
    return call(this.#health, options.onProgress, (progress) =>
      this.#raw.simplifyMesh(input, checked, stepsOf(progress, reducedShares)),
    );
  }

  /**
   * Builds the grid of what an expression says of several meshes, each of which is prepared as `buildGrid` does; faces
   * on faces leave nothing behind. `boolean` does the same in a worker, and extracts.
   *
   * @param expression - an operation, which joins all operands from left to right, or an expression over their numbers
   * @param operands - the meshes; their arrays are read, not kept
   * @param options - how to split, where the operands go, what counts as inside, and a callback for progress
   * @returns the grid, which holds memory until `delete()`
   * @throws {@link KdManifoldError} with `INVALID_MESH`, `INVALID_OPTION`, `NOT_CLOSED`, `OUT_OF_MEMORY`, `ABORTED`
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * const part = { positions, indices };
   * const grid = (await load()).buildBooleanGrid(['union', 0, ['intersection', 0, 1]], [part, part]);
   * const mesh = grid.extract({ strict: 'embedded' });
   * console.log(mesh.sourceOperands.length === mesh.indices.length / 3); // true
   * grid.delete();
   * ```
   */
  buildBooleanGrid(
    expression: BooleanOperation | BooleanExpression,
    operands: readonly MeshInput[],
    options: BuildOptions & SolidOptions & ProgressOptions = {},
  ): Grid {
    const checked = checkBuildOptions(options, ['onProgress', ...solidKeys]);
    const subject = checkSolids(expression, operands, options);
    const raw = call(this.#health, options.onProgress, (progress) =>
      this.#raw.buildBooleanGrid(subject.solids, subject.expression, checked, progress),
    );
    return Grid.of(raw, this.#registry, this.#health);
  }

  /**
   * Keeps meshes and what an expression says of them, so that each can be moved and the result made again in a fraction
   * of the time: what is dragged is seen at once. `openBooleanScene` does the same in a worker.
   *
   * @param expression - an operation, which joins all operands from left to right, or an expression over their numbers
   * @param operands - the meshes; their arrays are copied
   * @param options - all that `boolean` can be told of building, extracting and reducing, and where the operands are at
   *   first
   * @returns the scene, which holds memory until `delete()`
   * @throws {@link KdManifoldError} with `INVALID_MESH`, `INVALID_OPTION`, `OUT_OF_MEMORY`; what else is wrong with the
   *   operands turns up with the first result
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * const part = { positions, indices };
   * const scene = (await load()).booleanScene('difference', [part, part], { reduce: false });
   * const mesh = scene.update(1, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 1]);
   * console.log(mesh.indices.length / 3);
   * scene.delete();
   * ```
   */
  booleanScene(
    expression: BooleanOperation | BooleanExpression,
    operands: readonly MeshInput[],
    options: BuildOptions & ExtractOptions & ReductionOptions & SolidOptions = {},
  ): BooleanScene {
    return this.makeScene(
      checkSolids(expression, operands, options),
      checkMakeOptions(options, solidKeys),
    );
  }

  /** @internal Does what `booleanScene` does, with operands and options that were checked. */
  makeScene(
    { solids, expression }: Solids,
    { build, extract, reduction }: ReturnType<typeof checkMakeOptions>,
  ): BooleanScene {
    const raw = call(this.#health, undefined, () =>
      this.#raw.makeScene(solids, expression, { ...build, ...extract, ...reduction }),
    );
    const shares = isReduced(reduction, build, extract) ? reducedShares : plainShares;
    return BooleanScene.of(raw, solids.length, shares, this.#registry, this.#health);
  }

  /**
   * Loads the grid that `Grid.save` or the command line's `--save-grid` made. All of it is checked: bytes
   * that are cut off, damaged or made up are refused.
   *
   * @param content - the bytes
   * @param name - what error messages call them
   * @returns the grid, which holds memory until `delete()`
   * @throws {@link KdManifoldError} with `PARSE_ERROR` or `OUT_OF_MEMORY`
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * const kdm = await load();
   * const built = kdm.buildGrid({ positions, indices });
   * const again = kdm.loadGrid(built.save(), 'part.kdgrid');
   * for (const grid of [built, again]) grid.delete();
   * ```
   */
  loadGrid(content: Uint8Array | ArrayBuffer, name = 'grid'): Grid {
    const bytes = bytesOf(content);
    const raw = call(this.#health, undefined, () => this.#raw.loadGrid(bytes, name));
    return Grid.of(raw, this.#registry, this.#health);
  }

  /**
   * Finds what is wrong with a mesh of any kind: open edges, holes, faces that disagree, doubled and
   * degenerate ones, parts inside out, with lists of all of them.
   *
   * @param mesh - triangles, and quads if there are any
   * @param options - what takes longer is looked for on request
   * @returns the lists
   * @throws {@link KdManifoldError} with `INVALID_MESH` or `INVALID_OPTION`
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * const defects = (await load()).analyze({ positions, indices }, { selfIntersections: true });
   * console.log(defects.boundaryLoops.length, defects.selfIntersectingFaces.length);
   * ```
   */
  analyze(mesh: PolygonMeshInput, options: AnalyzeOptions = {}): MeshDefects {
    const tools = this.#demandTools();
    const checked = checkAnalyzeOptions(options);
    const input = checkPolygonMesh(mesh);
    return toDefects(call(this.#health, undefined, () => tools.analyze(input, checked)));
  }

  /**
   * Makes a closed shell around a surface, half of `thickness` (model units, above 0) to either side: what an
   * open surface needs to be printed. Its parts may overlap; `buildGrid` makes their union, and with
   * the option `thicken` does both.
   *
   * @param mesh - the surface
   * @param thickness - in model units, above 0
   * @returns the shell
   * @throws {@link KdManifoldError} with `INVALID_MESH` or `INVALID_OPTION`
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * const kdm = await load();
   * const shell = kdm.thicken({ positions, indices: indices.slice(0, 3) }, 0.1);
   * console.log(kdm.describe(shell).closed); // true
   * ```
   */
  thicken(mesh: PolygonMeshInput, thickness: number): ParsedMesh {
    if (!(Number.isFinite(thickness) && thickness > 0)) {
      throw new KdManifoldError(
        'INVALID_OPTION',
        `thickness: expected a finite number above 0, got ${String(thickness)}`,
      );
    }
    const input = checkPolygonMesh(mesh);
    return call(this.#health, undefined, () => this.#raw.thicken(input, thickness));
  }

  /**
   * Counts vertices, faces, parts and faulty edges, and says whether the mesh is 2-manifold.
   *
   * @param mesh - triangles, and quads if there are any
   * @returns the counts
   * @throws {@link KdManifoldError} with `INVALID_MESH`
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * console.log((await load()).describe({ positions, indices }).twoManifold);
   * ```
   */
  describe(mesh: PolygonMeshInput): MeshReport {
    const input = checkPolygonMesh(mesh);
    return call(this.#health, undefined, () => this.#raw.describe(input));
  }

  /**
   * Finds the faces that cross or touch others, exactly, for the coordinates as they are.
   *
   * @param mesh - triangles, and quads if there are any
   * @returns the faces, and how many pairs they make
   * @throws {@link KdManifoldError} with `INVALID_MESH`
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * console.log((await load()).findSelfIntersections({ positions, indices }).pairs);
   * ```
   */
  findSelfIntersections(mesh: PolygonMeshInput): SelfIntersections {
    const input = checkPolygonMesh(mesh);
    return call(this.#health, undefined, () => this.#raw.findSelfIntersections(input));
  }

  /**
   * Reads a file's content. What it is for certain counts, not the format asked for; text may be UTF-8 or UTF-16.
   * Faces with fewer than three corners or with a coordinate that is not finite are skipped, with a warning.
   *
   * @param content - bytes, or the text of an OBJ, OFF, text STL or text PLY
   * @param format - which it is; counts where the content fits no format for certain
   * @param name - what error messages call it
   * @returns the mesh and `warnings`; polygons are cut into triangles, which `sourceFaces` tells
   * @throws {@link KdManifoldError} with `PARSE_ERROR` (line, byte or rule), `INVALID_OPTION`, `OUT_OF_MEMORY`
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * const mesh = (await load()).parseMesh('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n', 'obj', 'one.obj');
   * console.log(mesh.indices.length); // 3
   * ```
   */
  parseMesh(
    content: Uint8Array | ArrayBuffer | string,
    format: MeshFormat,
    name = 'input',
  ): FileMesh {
    const tools = this.#demandTools();
    checkFormat(format);
    const bytes =
      typeof content === 'string' ? new TextEncoder().encode(content) : bytesOf(content);
    return call(this.#health, undefined, () => tools.parseMesh(bytes, format, name));
  }

  /**
   * Makes the content of a file with the mesh (STL and PLY binary). Positions are 32-bit numbers; in text (OBJ, OFF)
   * the shortest that read back as the same, or, if `exact`, those that do so in 64 bits too: for programs that
   * must not see the surface moved, as by `strict: 'embedded'`.
   *
   * @param mesh - triangles, and quads if there are any
   * @param format - which to write
   * @param options - `exact`: 64 bits in text
   * @returns the file's bytes
   * @throws {@link KdManifoldError} with `INVALID_MESH` or `INVALID_OPTION`
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * const bytes = (await load()).formatMesh({ positions, indices }, 'stl');
   * console.log(bytes.length === 84 + 50 * (indices.length / 3)); // true
   * ```
   */
  formatMesh(
    mesh: PolygonMeshInput,
    format: MeshFormat,
    { exact = false }: { exact?: boolean } = {},
  ): OwnUint8Array {
    const tools = this.#demandTools();
    checkFormat(format);
    const input = checkPolygonMesh(mesh);
    return call(this.#health, undefined, () => tools.formatMesh(input, format, exact));
  }

  /**
   * Says how much memory WebAssembly holds.
   *
   * @returns bytes of the heap, which never shrinks, and bytes of it in use
   *
   * @example
   * ```js
   * import { load } from 'kdmanifold';
   *
   * console.log((await load()).memory().heapBytes / 2 ** 20, 'MB');
   * ```
   */
  memory(): { heapBytes: number; usedBytes: number } {
    const { heapBytes, usedBytes } = this.#raw.memory();
    const tools = this.#tools?.memory() ?? { heapBytes: 0, usedBytes: 0 };
    return { heapBytes: heapBytes + tools.heapBytes, usedBytes: usedBytes + tools.usedBytes };
  }
}

/** A view of bytes, also of buffers from another frame. */
function bytesOf(content: Uint8Array | ArrayBuffer): Uint8Array {
  if (ArrayBuffer.isView(content)) {
    return new Uint8Array(content.buffer, content.byteOffset, content.byteLength);
  }
  if (/^\[object (Shared)?ArrayBuffer\]$/.test(Object.prototype.toString.call(content))) {
    return new Uint8Array(content);
  }
  throw new KdManifoldError(
    'INVALID_OPTION',
    `content: expected a Uint8Array or an ArrayBuffer, got ${content === null ? 'null' : typeof content}`,
  );
}

function checkFormat(format: string): void {
  if (formats.includes(format)) return;
  throw new KdManifoldError(
    'INVALID_OPTION',
    `format: expected one of ${formats.join(', ')}, got '${format}'`,
  );
}
