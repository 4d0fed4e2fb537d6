// SPDX-License-Identifier: MIT
// Which triangles of a geometry three.js draws, and with which of the materials.
import type { BufferGeometry } from 'three';
import { refuse } from './kinds.js';

/** Triangles by the vertices of their corners, three each. */
export interface Drawn {
  corners: Uint32Array;
  /** Per triangle: the group's `materialIndex`, or 0. */
  materials: Uint32Array;
}

interface Stretch {
  start: number;
  count: number;
  materialIndex?: number | undefined;
}

/** How many corners there are, drawn or not. */
export const cornersOf = (geometry: BufferGeometry): number =>
  geometry.getIndex()?.count ?? geometry.getAttribute('position').count;

/** Calls `visit` for the first corner of each triangle of the stretches within the draw range. */
function visitTriangles(
  geometry: BufferGeometry,
  stretches: Stretch[],
  what: string,
  visit: (corner: number, material: number) => void,
): void {
  const { drawRange } = geometry;
  const count = cornersOf(geometry);
  for (const stretch of stretches) {
    const first = Math.max(stretch.start, drawRange.start, 0);
    const end = Math.min(stretch.start + stretch.count, drawRange.start + drawRange.count, count);
    if (!(end > first)) continue;
    if ((end - first) % 3 !== 0) {
      const which = geometry.getIndex() === null ? 'vertices' : 'indices';
      refuse(what, `${end - first} ${which} are to be drawn, which is not a multiple of 3`);
    }
    for (let corner = first; corner < end; corner += 3) visit(corner, stretch.materialIndex ?? 0);
  }
}

/** Per corner: the material of the triangle that starts there; -1: none does. */
function firstCorners(
  geometry: BufferGeometry,
  groups: Stretch[] | null,
  what: string,
): Int32Array {
  const starts = new Int32Array(cornersOf(geometry)).fill(-1);
  // Of groups that overlap the last one counts: it is drawn over the others.
  visitTriangles(geometry, groups ?? [{ start: 0, count: Infinity }], what, (corner, material) => {
    starts[corner] = material;
  });
  return starts;
}

/**
 * Lists what is drawn: what lies in the draw range and in one of the groups. `groups` null: the draw
 * range alone counts, as with a single material.
 */
export function drawnTriangles(
  geometry: BufferGeometry,
  groups: Stretch[] | null,
  what: string,
): Drawn {
  const starts = firstCorners(geometry, groups, what);
  let triangles = 0;
  for (const material of starts) if (material >= 0) ++triangles;
  const drawn: Drawn = {
    corners: new Uint32Array(3 * triangles),
    materials: new Uint32Array(triangles),
  };
  const index = geometry.getIndex()?.array ?? null;
  const vertices = geometry.getAttribute('position').count;
  for (let corner = 0, t = 0; corner < starts.length; ++corner) {
    if ((starts[corner] as number) < 0) continue;
    drawn.materials[t] = starts[corner] as number;
    for (let k = 0; k < 3; ++k) {
      const vertex = index === null ? corner + k : (index[corner + k] as number);
      if (!(vertex < vertices)) {
        refuse(what, `index[${corner + k}] is ${vertex}, but there are only ${vertices} vertices`);
      }
      drawn.corners[3 * t + k] = vertex;
    }
    ++t;
  }
  return drawn;
}

/**
 * The `materialIndex` of each triangle of a geometry that stands alone, from `firstCorner` on; 0 where
 * no group is.
 */
export function groupMaterials(
  geometry: BufferGeometry,
  firstCorner: number,
  triangles: number,
): Uint32Array {
  const materials = new Uint32Array(triangles);
  for (const { start, count, materialIndex } of geometry.groups) {
    const first = Math.max(Math.ceil((start - firstCorner) / 3), 0);
    materials.fill(materialIndex ?? 0, first, Math.ceil((start + count - firstCorner) / 3));
  }
  return materials;
}
