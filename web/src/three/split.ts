// SPDX-License-Identifier: MIT
// A manifold mesh has one vertex at a seam or a crease, a geometry one for each side of it.

/** The vertices of a geometry. */
export interface Split {
  /** Per new vertex: the first corner that uses it. */
  made: Uint32Array;
  /** Per corner: its new vertex. */
  index: Uint32Array;
}

/**
 * Makes new vertices: corners share one if they share a vertex and are the same.
 *
 * @param vertexOf - The vertex of each corner.
 * @param vertices - How many there are.
 * @param same - Whether the second of two corners may use the vertex that was made for the first.
 */
export function splitVertices(
  vertexOf: ArrayLike<number>,
  vertices: number,
  same: (made: number, corner: number) => boolean,
): Split {
  const count = vertexOf.length;
  const made = new Uint32Array(count);
  const next = new Int32Array(count).fill(-1); // per new vertex: another one at the same place
  const newest = new Int32Array(vertices).fill(-1); // per vertex
  const index = new Uint32Array(count);
  let used = 0;
  for (let corner = 0; corner < count; ++corner) {
    const vertex = vertexOf[corner] as number;
    let found = newest[vertex] as number;
    while (found >= 0 && !same(made[found] as number, corner)) found = next[found] as number;
    if (found < 0) {
      found = used++;
      made[found] = corner;
      next[found] = newest[vertex] as number;
      newest[vertex] = found;
    }
    index[corner] = found;
  }
  return { made: made.slice(0, used), index };
}
