// SPDX-License-Identifier: MIT
// The types of what Emscripten generates from wasm/bindings.cpp. Only library.ts and grid.ts see it.
import type { ErrorCode } from './errors.js';
import type {
  ExtractedMesh,
  GridStats,
  InputReport,
  MeshDefects,
  MeshReport,
  ParsedMesh,
  PolygonMeshInput,
  SelfIntersections,
} from './types.js';

/** What guard() in wasm/marshal.h returns. */
export type Answer<T> = { value: T; code?: undefined } | { code: ErrorCode; message: string };

/** Null, or a callback that never throws and returns true to go on. */
export type RawProgress = ((fraction: number, phase: string) => boolean) | null;

export interface RawGrid {
  extract(options: object, progress: RawProgress): Answer<ExtractedMesh>;
  save(): Answer<Uint8Array<ArrayBuffer>>;
  stats(): GridStats;
  input(): InputReport;
  delete(): void;
}

/** What the wrapper makes `boundaryLoops` and `parts` of. */
export interface RawDefects extends Omit<MeshDefects, 'boundaryLoops' | 'parts'> {
  /** The loops one after the other, and where each ends. */
  loopVertices: Uint32Array<ArrayBuffer>;
  loopEnds: Uint32Array<ArrayBuffer>;
  /** All fields of each part, as `partKeys` lists them; flags are 0 or 1, NaN stands for null. */
  partNumbers: Float64Array<ArrayBuffer>;
}

export interface RawModule {
  buildGrid(mesh: PolygonMeshInput, options: object, progress: RawProgress): Answer<RawGrid>;
  loadGrid(bytes: Uint8Array, name: string): Answer<RawGrid>;
  parseMesh(bytes: Uint8Array, format: string, name: string): Answer<ParsedMesh>;
  formatMesh(
    mesh: PolygonMeshInput,
    format: string,
    exact: boolean,
  ): Answer<Uint8Array<ArrayBuffer>>;
  analyze(mesh: PolygonMeshInput, options: object): Answer<RawDefects>;
  thicken(mesh: PolygonMeshInput, thickness: number): Answer<ParsedMesh>;
  describe(mesh: PolygonMeshInput): Answer<MeshReport>;
  findSelfIntersections(mesh: PolygonMeshInput): Answer<SelfIntersections>;
  memory(): { heapBytes: number; usedBytes: number };
  version(): string;
}

export interface ModuleSettings {
  instantiateWasm(
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
  ): object;
  print?(text: string): void;
  printErr?(text: string): void;
}

export default function createModule(settings: ModuleSettings): Promise<RawModule>;
