// SPDX-License-Identifier: MIT
// Finds everything that a caller can get wrong, before any memory of WebAssembly is taken.
import {
  uselessOfBuild,
  uselessOfExtract,
  uselessOfReduction,
  uselessReduction,
  type Useless,
} from './check-combination.js';
import { KdManifoldError } from './errors.js';
import { isBox, isLegal, rangeText, type OptionSpec } from './option-spec.js';
import {
  analyzeOptions,
  buildOptions,
  extractOptions,
  reduceOptions,
  reductionOptions,
  simplifyOptions,
} from './options.js';
import type {
  AnalyzeOptions,
  BuildOptions,
  CompareOptions,
  ExtractOptions,
  GroupOptions,
  MeshInput,
  PolygonMeshInput,
  ReduceOptions,
  SimplifyOptions,
} from './types.js';

/** A mesh whose arrays are typed arrays that were looked at. */
export interface CheckedMesh {
  positions: Float32Array | Float64Array;
  indices: Whole | null;
  quads: Whole | null;
  sourceFaces: Whole | null;
  cornerNormals: Float32Array | null;
}

type Whole = Exclude<NonNullable<MeshInput['indices']>, readonly number[]>;
type Typed = Float32Array | Float64Array | Whole;

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

const reals = ['Float32Array', 'Float64Array'];
const wholes = [
  ...['Uint32Array', 'Uint16Array', 'Uint8Array', 'Uint8ClampedArray'],
  ...['Int32Array', 'Int16Array', 'Int8Array'],
];

// Says how to get the first of `kinds` from what is none.
function advice(value: unknown, name: string, kinds: string[]): string {
  const [wanted = ''] = kinds;
  const kind = kindOf(value);
  if (kind.startsWith('Big')) return `; ${wanted}.from(${name}, Number) makes one`;
  if (kind === 'DataView' || kind === 'ArrayBuffer' || isBuffer(value)) {
    return `; new ${wanted}(...) makes one of its bytes`;
  }
  if (ArrayBuffer.isView(value)) return `; ${wanted}.from(${name}) makes one`;
  if (typeof value === 'object' && value !== null && 'array' in value) {
    return '; its member array may be one';
  }
  return '';
}

const isBuffer = (value: unknown): boolean =>
  /^\[object (Shared)?ArrayBuffer\]$/.test(Object.prototype.toString.call(value));

// An array whose buffer went to another thread has no length any more.
function isDetached({ buffer, length }: Typed): boolean {
  if (length > 0) return false;
  try {
    new Uint8Array(buffer);
    return false;
  } catch {
    return true;
  }
}

const shown = (value: unknown): string =>
  ['string', 'bigint', 'number'].includes(typeof value) ? String(value) : kindOf(value);

// Takes a typed array as it is, and makes one of a plain array, whose members must be numbers.
function takeNumbers(value: unknown, name: string, kinds: string[], multiple: number): Typed {
  let taken = value as Typed;
  if (Array.isArray(value)) {
    const numbers: unknown[] = value;
    const odd = numbers.findIndex((number) => typeof number !== 'number');
    if (odd >= 0) fail(`${name}[${odd}] is ${shown(numbers[odd])}, which is no number`);
    taken = Float64Array.from(numbers as number[]);
  } else if (!kinds.includes(kindOf(value))) {
    const names = kinds.slice(0, 2).join(' or ');
    fail(`${name}: expected ${names}, got ${kindOf(value)}${advice(value, name, kinds)}`);
  } else if (isDetached(taken)) {
    fail(`${name}: its buffer was handed over to another thread, so the array is empty now`);
  }
  const { length } = taken;
  if (length % multiple !== 0) fail(`${name}: length ${length} is not a multiple of ${multiple}`);
  return taken;
}

function takeIndices(value: unknown, name: string, multiple: number, vertices: number): Whole {
  const indices = takeNumbers(value, name, wholes, multiple);
  for (let i = 0; i < indices.length; ++i) {
    const index = indices[i] as number;
    if (index >= vertices) {
      fail(`${name}[${i}] is ${index}, but there are only ${vertices} vertices`);
    }
    if (index >>> 0 !== index) {
      fail(`${name}[${i}] is ${index}; vertices are numbered 0, 1, 2 and so on`);
    }
  }
  return Array.isArray(value) ? Uint32Array.from(indices) : (indices as Whole);
}

function takeReals(value: unknown, name: string): Float32Array | Float64Array {
  const taken = takeNumbers(value, name, reals, 3) as Float32Array | Float64Array;
  for (let i = 0; i < taken.length; ++i) {
    const number = taken[i] as number;
    // The difference is 0 for finite numbers only. Quicker than to call a function millions of times.
    if (number - number !== 0) fail(`${name}[${i}] is ${number}; coordinates must be finite`);
  }
  return taken;
}

/** Checks the arrays of a mesh and returns them. A mesh without any face is accepted. */
export function checkPolygonMesh(mesh: PolygonMeshInput): CheckedMesh {
  if (typeof mesh !== 'object' || mesh === null) {
    fail(`mesh: expected an object with positions and indices, got ${kindOf(mesh)}`);
  }
  const positions = takeReals(mesh.positions, 'positions');
  const vertices = positions.length / 3;
  const indices = isMissing(mesh.indices)
    ? null
    : takeIndices(mesh.indices, 'indices', 3, vertices);
  if (indices === null && vertices % 3 !== 0) {
    fail(`positions: without indices, length ${positions.length} must be a multiple of 9`);
  }
  const quads = isMissing(mesh.quads) ? null : takeIndices(mesh.quads, 'quads', 4, vertices);
  const sourceFaces = isMissing(mesh.sourceFaces)
    ? null
    : takeSources(mesh.sourceFaces, (indices?.length ?? vertices) / 3 + (quads?.length ?? 0) / 4);
  const cornerNormals = isMissing(mesh.cornerNormals)
    ? null
    : takeNormals(mesh.cornerNormals, (indices?.length ?? vertices) + (quads?.length ?? 0));
  return { positions, indices, quads, sourceFaces, cornerNormals };
}

const isMissing = (value: unknown): value is null | undefined =>
  value === undefined || value === null;

function takeSources(value: unknown, faces: number): Whole {
  const sourceFaces = takeNumbers(value, 'sourceFaces', wholes, 1);
  if (sourceFaces.length !== faces) {
    fail(`sourceFaces: length ${sourceFaces.length}, but there are ${faces} faces`);
  }
  return Array.isArray(value) ? Uint32Array.from(sourceFaces) : (sourceFaces as Whole);
}

function takeNormals(value: unknown, corners: number): Float32Array {
  const normals = takeNumbers(value, 'cornerNormals', ['Float32Array'], 3);
  if (normals.length !== 3 * corners) {
    fail(`cornerNormals: length ${normals.length}, but there are ${corners} corners of faces`);
  }
  return Array.isArray(value) ? Float32Array.from(normals) : (normals as Float32Array);
}

/** Checks a mesh to be converted: it must have triangles, at least one, and may have no quads. */
export function checkMesh(mesh: MeshInput): CheckedMesh {
  const checked = checkPolygonMesh(
    typeof mesh === 'object' && mesh !== null
      ? { ...mesh, quads: null, cornerNormals: null }
      : mesh,
  );
  if (checked.positions.length === 0) fail('the mesh has no vertices');
  if (checked.indices?.length === 0) fail('the mesh has no faces');
  return checked;
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
        const beside =
          name === 'thicken' && value === 'sheets' ? " beside thickenWhat 'sheets'" : '';
        refuse(`a ${spec.kind === 'integer' ? 'whole ' : ''}number ${rangeText(spec)}${beside}`);
      }
      break;
    case 'numbers':
      if (!isDescending(value, spec.least)) {
        refuse(`whole numbers from ${spec.least} on, each smaller than the one before`);
      }
      break;
    case 'box':
      if (!isBox(value)) refuse('6 finite numbers, the lowest corner before the highest');
      break;
    case 'boolean':
      if (typeof value !== 'boolean') refuse('true or false');
      break;
    case 'text':
      break; // the command line's
  }
}

const listOf = (value: unknown): number[] => (Array.isArray(value) ? value : [value]) as number[];

function isDescending(value: unknown, least: number): boolean {
  const numbers = listOf(value);
  return (
    numbers.length > 0 &&
    numbers.every(
      (number, i) => Number.isInteger(number) && !(number >= (numbers[i - 1] ?? Infinity)),
    ) &&
    (numbers.at(-1) as number) >= least
  );
}

// As WebAssembly takes it. What is too large for 32 bits limits nothing.
const wasmList = (value: unknown): number[] =>
  listOf(value).map((number) => Math.min(number, 0xffffffff));

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
    taken[name] = spec.kind === 'numbers' ? wasmList(value) : value;
  }
  return taken;
}

function refuseUseless(useless: Useless | undefined): void {
  if (useless === undefined) return;
  throw new KdManifoldError('INVALID_OPTION', `${useless.name}: ${useless.when}`);
}

/** Checks and returns the options of `buildGrid`. Those named in `others` are left to others. */
export function checkBuildOptions(given: object, others: string[]): BuildOptions {
  const options: BuildOptions = pick(given, buildOptions, others);
  refuseUseless(uselessOfBuild(options));
  return options;
}

/** Checks and returns the options of `Grid.extract`. Those named in `others` are left to others. */
export function checkExtractOptions(given: object, others: string[]): ExtractOptions {
  const options: ExtractOptions = pick(given, extractOptions, others);
  refuseUseless(uselessOfExtract(options));
  return options;
}

/** Groups as WebAssembly takes them. */
export interface CheckedGroups {
  keepGroups?: Uint32Array;
}

/** Checks and copies the groups of faces. */
export function checkGroups({ keepGroups }: GroupOptions): CheckedGroups {
  if (keepGroups === undefined) return {};
  if (!Array.isArray(keepGroups) && !wholes.includes(kindOf(keepGroups))) {
    const expected = 'an array of whole numbers, one a face';
    throw new KdManifoldError(
      'INVALID_OPTION',
      `keepGroups: expected ${expected}, got ${kindOf(keepGroups)}`,
    );
  }
  const groups = Uint32Array.from(keepGroups);
  const odd = groups.findIndex((group, i) => group !== keepGroups[i]);
  if (odd >= 0 || groups.length === 0) {
    const found = odd >= 0 ? `keepGroups[${odd}] is ${shown(keepGroups[odd])}` : 'it is empty';
    throw new KdManifoldError(
      'INVALID_OPTION',
      `keepGroups: expected whole numbers from 0 on, but ${found}`,
    );
  }
  return { keepGroups: groups };
}

/** Options of reduction, with the numbers as WebAssembly takes them. */
export interface CheckedReduction extends CheckedGroups {
  reduce?: boolean;
  targetTriangles?: number[];
}

/**
 * Checks and returns whether and how far results are reduced, beside the other options, which have been checked. Those
 * named in `others` are left to others.
 */
export function checkReductionOptions(
  given: object,
  build: BuildOptions,
  extract: ExtractOptions,
  others: string[],
): CheckedReduction {
  const options: CheckedReduction = pick(given, reductionOptions, others);
  refuseUseless(uselessOfReduction(options) ?? uselessReduction(options, build, extract));
  return options;
}

/** Checks all that one call from meshes to a mesh can be told. Options named in `others` are left to others. */
export function checkMakeOptions(
  given: object,
  others: string[],
): { build: BuildOptions; extract: ExtractOptions; reduction: CheckedReduction } {
  const [ofBuild, ofExtract, ofReduction] = [buildOptions, extractOptions, reductionOptions].map(
    (table) => Object.keys(table),
  ) as [string[], string[], string[]];
  const build = checkBuildOptions(given, [...others, ...ofExtract, ...ofReduction]);
  const extract = checkExtractOptions(given, [...others, ...ofBuild, ...ofReduction]);
  const reduction = checkReductionOptions(given, build, extract, [
    ...others,
    ...ofBuild,
    ...ofExtract,
  ]);
  return { build, extract, reduction };
}

/** Options of `simplifyMesh`, with the numbers as WebAssembly takes them. */
export interface CheckedReduce extends CheckedGroups {
  error?: number;
  targetTriangles?: number[];
}

/** Checks and returns how far a mesh is reduced. Options named in `others` are left to others. */
export function checkReduceOptions(
  given: ReduceOptions & GroupOptions,
  others: string[],
): CheckedReduce {
  const options: CheckedReduce = {
    ...pick(given, reduceOptions, ['keepGroups', ...others]),
    ...checkGroups(given),
  };
  if (!options.error && options.targetTriangles === undefined) {
    throw new KdManifoldError(
      'INVALID_OPTION',
      'error: expected a number above 0, unless targetTriangles is given',
    );
  }
  return options;
}

/** Checks and returns how far a grid is simplified. */
export function checkSimplifyOptions(given: SimplifyOptions): SimplifyOptions {
  const options: SimplifyOptions = pick(given, simplifyOptions, ['onProgress']);
  if (!options.surfaceError) {
    throw new KdManifoldError('INVALID_OPTION', 'surfaceError: expected a number above 0');
  }
  return options;
}

/** Checks and returns the options of `analyze`. */
export function checkAnalyzeOptions(given: object): AnalyzeOptions {
  return pick(given, analyzeOptions, []);
}

const compareOptions = { error: { flag: '--check', kind: 'boolean', default: false } } as const;

/** Checks and returns the options of `Grid.compare`. */
export function checkCompareOptions(given: object): CompareOptions {
  return pick(given, compareOptions, []);
}
