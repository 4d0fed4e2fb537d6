// SPDX-License-Identifier: MIT
// The types of what Emscripten generates from wasm/bindings.cpp. Only library.ts and grid.ts see them.
import type { ErrorCode } from './errors.js';
import type { Solid } from './solids.js';
import type { MakeStep } from './steps.js';
import type {
  Account,
  ExtractedMesh,
  GridStats,
  InputReport,
  Level,
  MeshReport,
  ParsedMesh,
  PolygonMeshInput,
  ReduceReport,
  SelfIntersections,
  Simplified,
  SimplifyReport,
} from './types.js';

/** What guard() in wasm/marshal.h returns. */
export type Answer<T> = { value: T; code?: undefined } | { code: ErrorCode; message: string };

/** Null, or a callback that never throws and returns true to go on. */
export type RawProgress = ((fraction: number, phase: string) => boolean) | null;

/** Told which step begins; never throws. */
export type RawSteps = (step: MakeStep) => RawProgress;

/** A result that may be reduced; the tolerances in `stats` are those that it keeps. */
export interface RawMade extends Omit<ExtractedMesh, 'reduce'> {
  levels: Level[];
  simplify: SimplifyReport | null;
  reduce: ReduceReport | null;
  stats: GridStats;
}

export interface RawGrid {
  extract(options: object, progress: RawProgress): Answer<ExtractedMesh>;
  extractReduced(options: object, reduce: object, begin: RawSteps): Answer<ExtractedMesh>;
  make(options: object, begin: RawSteps): Answer<RawMade>;
  simplify(options: object, progress: RawProgress): Answer<SimplifyReport>;
  compare(input: PolygonMeshInput, result: PolygonMeshInput, error: boolean): Answer<Account>;
  merge(other: RawGrid, expression: Int32Array, progress: RawProgress): Answer<RawGrid>;
  save(): Answer<Uint8Array<ArrayBuffer>>;
  stats(): GridStats;
  input(): InputReport;
  operands(): InputReport[];
  delete(): void;
}

export interface RawScene {
  /** Null: where the operand was given. */
  place(operand: number, transform: Float64Array | null): Answer<undefined>;
  make(begin: RawSteps): Answer<RawMade & { grid: RawGrid }>;
  delete(): void;
}

/** What every module says about itself. */
export interface RawInstance {
  memory(): { heapBytes: number; usedBytes: number };
  version(): string;
}

export interface RawModule extends RawInstance {
  buildGrid(mesh: PolygonMeshInput, options: object, progress: RawProgress): Answer<RawGrid>;
  buildBooleanGrid(
    operands: Solid[],
    expression: Int32Array,
    options: object,
    progress: RawProgress,
  ): Answer<RawGrid>;
  makeManifold(
    mesh: PolygonMeshInput,
    options: object,
    begin: RawSteps,
  ): Answer<RawMade & { grid: RawGrid }>;
  makeSolids(
    operands: Solid[],
    expression: Int32Array,
    options: object,
    begin: RawSteps,
  ): Answer<RawMade & { grid: RawGrid }>;
  makeScene(operands: Solid[], expression: Int32Array, options: object): Answer<RawScene>;
  simplifyMesh(mesh: PolygonMeshInput, options: object, begin: RawSteps): Answer<Simplified>;
  loadGrid(bytes: Uint8Array, name: string): Answer<RawGrid>;
  thicken(mesh: PolygonMeshInput, thickness: number): Answer<ParsedMesh>;
  describe(mesh: PolygonMeshInput): Answer<MeshReport>;
  findSelfIntersections(mesh: PolygonMeshInput): Answer<SelfIntersections>;
}

/** Makes an instance of a module; the glue's default export. */
export type CreateModule<Raw> = (settings: ModuleSettings) => Promise<Raw>;

export interface ModuleSettings extends Partial<ThreadSettings> {
  instantiateWasm(
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
  ): object;
  print?(text: string): void;
  printErr?(text: string): void;
}

/** What kdmanifold-threads takes besides (wasm/own_worker.js). */
export interface ThreadSettings {
  /** How many threads there are besides the calling one. */
  helpers: number;
  /** Starts a thread, whatever address it is given. */
  Worker: new () => object;
}

declare const createModule: CreateModule<RawModule>;
export default createModule;
