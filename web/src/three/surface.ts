// SPDX-License-Identifier: MIT
// The drawn triangles of one mesh in its own space. Instances share it.
import type { Material, Mesh } from 'three';
import type { Skipped } from './collect.js';
import { cornersOf, drawnTriangles, type Drawn } from './drawn.js';
import { nameOf, refuse } from './kinds.js';
import { posedPositions } from './pose.js';

/** Triangles that have only the vertices that they use. */
export interface Surface {
  /** Per corner: the number of its vertex in `vertices`. */
  corners: Uint32Array;
  /** Per triangle: the number of its material in the mesh's own array. */
  materials: Uint32Array;
  /** The vertices of the geometry that are used. */
  vertices: Uint32Array;
  /** Their positions, three numbers each. */
  positions: Float64Array;
}

/** Takes only the vertices that are used: the others may be anything. */
export function surfaceOf(
  mesh: Mesh | null,
  geometry: Mesh['geometry'],
  influences: ArrayLike<number> | null,
  { corners, materials }: Drawn,
  what: string,
): Surface {
  const numbers = new Int32Array(geometry.getAttribute('position').count).fill(-1);
  const vertices = new Uint32Array(Math.min(corners.length, numbers.length));
  const own = new Uint32Array(corners.length);
  let used = 0;
  for (let i = 0; i < corners.length; ++i) {
    const vertex = corners[i] as number;
    if ((numbers[vertex] as number) < 0) {
      vertices[used] = vertex;
      numbers[vertex] = used++;
    }
    own[i] = numbers[vertex] as number;
  }
  const kept = vertices.slice(0, used);
  const positions = posedPositions(mesh, geometry, influences, kept, what);
  return { corners: own, materials, vertices: kept, positions };
}

/** Lists what is drawn of a mesh, and notes what is not. */
export function drawnOf(mesh: Mesh, onlyVisible: boolean, skipped: Skipped[]): Drawn | null {
  const { geometry, material } = mesh;
  const what = nameOf(mesh);
  const skip = (reason: string): null => {
    skipped.push({ object: mesh, name: what, reason });
    return null;
  };
  if (geometry.getAttribute('position') === undefined) {
    if (Object.keys(geometry.attributes).length === 0) return skip('its geometry is empty');
    refuse(what, 'its geometry has no attribute "position"');
  }
  const shows = (one: Material | undefined): boolean => one?.visible !== false || !onlyVisible;
  if (!Array.isArray(material)) {
    if (!shows(material)) return skip('its material is not visible');
    const drawn = drawnTriangles(geometry, null, what);
    return drawn.corners.length === 0 ? skip('no triangle of it is drawn') : drawn;
  }
  const materials: (Material | undefined)[] = material;
  const groups = geometry.groups.filter(({ materialIndex = 0 }, i) => {
    const own = materials[materialIndex];
    if (own === undefined) skip(`group ${i}: there is no material ${materialIndex}`);
    else if (!shows(own)) skip(`group ${i}: material ${materialIndex} is not visible`);
    return own !== undefined && shows(own);
  });
  const drawn = drawnTriangles(geometry, groups, what);
  if (drawn.corners.length === 0) return skip('no triangle of it is drawn with its materials');
  noteUngrouped(mesh, skip);
  return drawn;
}

// With several materials only what is in a group is drawn.
function noteUngrouped({ geometry }: Mesh, skip: (reason: string) => null): void {
  const { start, count } = geometry.drawRange;
  const first = Math.max(start, 0);
  const corners = Math.max(Math.min(start + count, cornersOf(geometry)) - first, 0);
  const grouped = new Uint8Array(corners);
  for (const group of geometry.groups) {
    grouped.fill(
      1,
      Math.max(group.start - first, 0),
      Math.max(group.start + group.count - first, 0),
    );
  }
  const left = grouped.reduce((sum, one) => sum - one, corners);
  if (left > 0) skip(`${left} corners of triangles are in no group, so no material draws them`);
}
