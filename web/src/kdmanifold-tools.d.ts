// SPDX-License-Identifier: MIT
// The types of what Emscripten generates from wasm/tools_bindings.cpp. Only library.ts and defects.ts see them.
import type { Answer, CreateModule, RawInstance } from './kdmanifold.js';
import type { FileMesh, MeshDefects, PolygonMeshInput } from './types.js';

/** What the wrapper makes `boundaryLoops` and `parts` of. */
export interface RawDefects extends Omit<MeshDefects, 'boundaryLoops' | 'parts'> {
  /** The loops one after the other, and where each ends. */
  loopVertices: Uint32Array<ArrayBuffer>;
  loopEnds: Uint32Array<ArrayBuffer>;
  /** All fields of each part, as `partKeys` lists them; flags are 0 or 1, NaN stands for null. */
  partNumbers: Float64Array<ArrayBuffer>;
}

export interface RawTools extends RawInstance {
  parseMesh(bytes: Uint8Array, format: string, name: string): Answer<FileMesh>;
  formatMesh(
    mesh: PolygonMeshInput,
    format: string,
    exact: boolean,
  ): Answer<Uint8Array<ArrayBuffer>>;
  analyze(mesh: PolygonMeshInput, options: object): Answer<RawDefects>;
}

declare const createTools: CreateModule<RawTools>;
export default createTools;
