// SPDX-License-Identifier: MIT
// The attributes of all parts of a source side by side: one row of numbers per vertex of its mesh.
import { KdManifoldError } from '../errors.js';
import { readMorphed, wholeType, type RawAttribute, type Values } from './attributes.js';
import { nameOf, refuse } from './kinds.js';
import type { MeshSource, SourcePart } from './source.js';

/** One attribute. */
export interface Column {
  name: string;
  /** Where its numbers are in a row, and how many. */
  offset: number;
  itemSize: number;
  /** Not null: it holds whole numbers, in an array of this class, that mean nothing in between. */
  whole: string | null;
  gpuType: number | undefined;
}

/** The attributes of all vertices. */
export interface Table {
  columns: Column[];
  /** Numbers per vertex. */
  width: number;
  rows: Float64Array;
}

/** Belong to the old surface only: positions, normals and tangents, bones. */
const never = ['position', 'normal', 'tangent', 'skinIndex', 'skinWeight'];

/** Makes the table; `wanted` null: of every attribute that means something on the new surface. */
export function tabulate(source: MeshSource, vertices: number, wanted: string[] | null): Table {
  const columns = columnsOf(source, namesIn(source, wanted));
  const last = columns[columns.length - 1];
  const width = last === undefined ? 0 : last.offset + last.itemSize;
  const table = { columns, width, rows: new Float64Array(width * vertices) };
  for (const [i, part] of source.parts.entries()) {
    const end = source.parts[i + 1]?.firstVertex ?? vertices;
    for (const column of columns) fill(table, column, part, end, source.vertices);
  }
  return table;
}

const isTinted = ({ tint }: SourcePart): boolean => tint !== null;

function namesIn({ parts }: MeshSource, wanted: string[] | null): string[] {
  const names = new Set(parts.flatMap(({ geometry }) => Object.keys(geometry.attributes)));
  if (parts.some(isTinted)) names.add('color');
  if (wanted === null) return [...names].filter((name) => !never.includes(name));
  for (const name of wanted) {
    const problem = never.includes(name)
      ? 'it belongs to the old surface only'
      : 'none of the geometries has it';
    if (never.includes(name) || !names.has(name)) {
      throw new KdManifoldError('INVALID_OPTION', `attributes: "${name}": ${problem}`);
    }
  }
  return [...new Set(wanted)];
}

function columnsOf({ parts }: MeshSource, names: string[]): Column[] {
  let offset = 0;
  return names.map((name) => {
    const found = new Set(
      parts.map(({ geometry }) => geometry.attributes[name] as RawAttribute | undefined),
    );
    found.delete(undefined);
    const attributes = [...found] as RawAttribute[];
    const tinted = name === 'color' && parts.some(isTinted);
    const itemSize = Math.max(tinted ? 3 : 0, ...attributes.map((own) => own.itemSize));
    const column = { name, offset, itemSize, ...wholeness(name, attributes) };
    offset += itemSize;
    return column;
  });
}

// Numbers of things are to be kept apart from quantised texture coordinates and colours.
function wholeness(
  name: string,
  attributes: RawAttribute[],
): { whole: string | null; gpuType: number | undefined } {
  const none = { whole: null, gpuType: undefined };
  const types = new Set(attributes.map(wholeType));
  if (/^(uv|color)/.test(name) || types.size === 0 || types.has(null)) return none;
  const gpuTypes = new Set(attributes.map((attribute) => attribute.gpuType));
  const [type] = types;
  const [gpuType] = gpuTypes;
  return {
    whole: types.size === 1 ? (type as string) : 'Int32Array',
    gpuType: gpuTypes.size === 1 ? gpuType : undefined,
  };
}

function fill(
  { width, rows }: Table,
  { name, offset, itemSize }: Column,
  part: SourcePart,
  end: number,
  vertices: Uint32Array | null,
): void {
  const { geometry, influences, instance, firstVertex } = part;
  const what = nameOf(part.object ?? geometry);
  const isColour = name === 'color';
  const values: Values | null =
    isColour && !part.coloured ? null : readMorphed(geometry, name, influences, what);
  const empty = isColour ? 1 : 0;
  const tint = isColour ? part.tint : null;
  for (let v = firstVertex; v < end; ++v) {
    const vertex = vertices === null ? v : (vertices[v] as number);
    const item = values?.perInstances ? Math.floor(instance / values.perInstances) : vertex;
    if (values !== null && item >= values.count) {
      refuse(what, `attribute "${name}" has ${values.count} items, but number ${item} is used`);
    }
    for (let c = 0; c < itemSize; ++c) {
      const has = values !== null && c < values.itemSize;
      const value = has ? (values.array[item * values.itemSize + c] as number) : empty;
      rows[v * width + offset + c] = c < 3 ? value * (tint?.[c] ?? 1) : value;
    }
  }
}
