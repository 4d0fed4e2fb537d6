// SPDX-License-Identifier: MIT
// Finds everything that a caller can get wrong, before any memory of WebAssembly is taken.
import { KdManifoldError } from './errors.js';
import { isLegal, rangeText, type OptionSpec } from './option-spec.js';
import { analyzeOptions, buildOptions, extractOptions } from './options.js';
import type {
  AnalyzeOptions,
  BuildOptions,
  ExtractOptions,
  MeshInput,
  PolygonMeshInput,
} from './types.js';

type Positions = MeshInput['positions'];
type Indices = Uint16Array | Uint32Array;

const fail = (message: string): never => {
  throw new KdManifoldError('INVALID_MESH', message);
};

/** Names the class of a typed array, also of one from another frame or context; else the type. */
function kindOf(value: unknown): string {
  if (ArrayBuffer.isView(value))
    return (value as { [Symbol.toStringTag]?: string })[Symbol.toStringTag] ?? 'DataView';
  if (value === null) return 'null';
  return Array.isArray(value) ? 'a plain array' : typeof value;
}

function demandKind(value: unknown, name: string, kinds: string[], multiple: number): void {
  const kind = kindOf(value);
  if (!kinds.includes(kind)) fail(`${name}: expected ${kinds.join(' or ')}, got ${kind}`);
  const { length } = value as Positions;
  if (length % multiple !== 0) fail(`${name}: length ${length} is not a multiple of ${multiple}`);
}

function demandIndices(indices: Indices, name: string, vertices: number): void {
  for (let i = 0; i < indices.length; ++i) {
    if ((indices[i] as number) >= vertices) {
      fail(`${name}[${i}] is ${indices[i]}, but there are only ${vertices} vertices`);
    }
  }
}

/** Checks the arrays of a mesh and returns them. A mesh without any face is accepted. */
export function checkPolygonMesh(mesh: PolygonMeshInput): PolygonMeshInput {
  if (typeof mesh !== 'object' || mesh === null) {
    fail(`mesh: expected an object with positions and indices, got ${kindOf(mesh)}`);
  }
  const {
    positions,
    indices = null,
    quads = null,
    sourceFaces = null,
    cornerNormals = null,
  } = mesh;
  demandKind(positions, 'positions', ['Float32Array', 'Float64Array'], 3);
  for (let i = 0; i < positions.length; ++i) {
    const value = positions[i] as number;
    // The difference is 0 for finite numbers only. Quicker than to call a function millions of times.
    if (value - value !== 0) fail(`positions[${i}] is ${value}; coordinates must be finite`);
  }
  const vertices = positions.length / 3;
  if (indices === null) {
    if (vertices % 3 !== 0) {
      fail(`positions: without indices, length ${positions.length} must be a multiple of 9`);
    }
  } else {
    demandKind(indices, 'indices', ['Uint16Array', 'Uint32Array'], 3);
    demandIndices(indices, 'indices', vertices);
  }
  if (quads !== null) {
    demandKind(quads, 'quads', ['Uint32Array'], 4);
    demandIndices(quads, 'quads', vertices);
  }
  if (sourceFaces !== null) {
    demandKind(sourceFaces, 'sourceFaces', ['Uint32Array'], 1);
    const faces = (indices?.length ?? vertices) / 3 + (quads?.length ?? 0) / 4;
    if (sourceFaces.length !== faces) {
      fail(`sourceFaces: length ${sourceFaces.length}, but there are ${faces} faces`);
    }
  }
  if (cornerNormals !== null) {
    demandKind(cornerNormals, 'cornerNormals', ['Float32Array'], 3);
    const corners = (indices?.length ?? vertices) + (quads?.length ?? 0);
    if (cornerNormals.length !== 3 * corners) {
      fail(
        `cornerNormals: length ${cornerNormals.length}, but there are ${corners} corners of faces`,
      );
    }
  }
  return { positions, indices, quads, sourceFaces, cornerNormals };
}

/** Checks a mesh to be converted: it must have triangles, at least one, and may have no quads. */
export function checkMesh(mesh: MeshInput): MeshInput {
  const { positions, indices, sourceFaces } = checkPolygonMesh(
    typeof mesh === 'object' && mesh !== null ? { ...mesh, quads: null } : mesh,
  );
  if (positions.length === 0) fail('the mesh has no vertices');
  if (indices?.length === 0) fail('the mesh has no faces');
  return { positions, indices, sourceFaces };
}

function checkOption(name: string, value: unknown, spec: OptionSpec): void {
  const refuse = (expected: string): never => {
    const shown = typeof value === 'string' ? `'${value}'` : String(value);
    throw new KdManifoldError('INVALID_OPTION', `${name}: expected ${expected}, got ${shown}`);
  };
  switch (spec.kind) {
    case 'choice':
      if (!spec.words.includes(value as string)) refuse(`one of ${spec.words.join(', ')}`);
      break;
    case 'integer':
    case 'number':
      if (!isLegal(value, spec)) {
        refuse(`a ${spec.kind === 'integer' ? 'whole ' : ''}number ${rangeText(spec)}`);
      }
      break;
    case 'boolean':
      if (typeof value !== 'boolean') refuse('true or false');
      break;
    case 'text':
      break; // the command line's
  }
}

/** Takes from `given` what `table` knows and refuses what neither it nor `others` know. */
function pick(given: object, table: Record<string, OptionSpec>, others: string[]): object {
  if (typeof given !== 'object' || given === null) {
    throw new KdManifoldError(
      'INVALID_OPTION',
      `options: expected an object, got ${kindOf(given)}`,
    );
  }
  const taken: Record<string, unknown> = {};
  for (const [name, value] of Object.entries(given)) {
    const spec = Object.hasOwn(table, name) ? table[name] : undefined;
    if (spec === undefined) {
      if (others.includes(name)) continue;
      throw new KdManifoldError('INVALID_OPTION', `${name}: no such option`);
    }
    if (value === undefined) continue;
    checkOption(name, value, spec);
    taken[name] = value;
  }
  return taken;
}

/** Checks and returns the options of `buildGrid`. Those named in `others` are left to others. */
export function checkBuildOptions(given: object, others: string[]): BuildOptions {
  return pick(given, buildOptions, others);
}

/** Checks and returns the options of `Grid.extract`. Those named in `others` are left to others. */
export function checkExtractOptions(given: object, others: string[]): ExtractOptions {
  return pick(given, extractOptions, others);
}

/** Checks and returns the options of `analyze`. */
export function checkAnalyzeOptions(given: object): AnalyzeOptions {
  return pick(given, analyzeOptions, []);
}
