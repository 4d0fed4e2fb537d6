// SPDX-License-Identifier: MIT
// Levels of detail of a result: the result itself, reduced further and further.
import { simplifyMesh, type Mesh, type ProgressCallback, type Warning } from 'kdmanifold';

/** One level; the last is the result itself. */
export interface Level {
  mesh: Mesh;
  triangles: number;
  /** The largest distance measured between it and the result, in model units; null: not yet known. */
  apart: number | null;
}

// Two steps halve the number of triangles. A tetrahedron has 4.
const step = Math.SQRT1_2;
const fewest = 4;

/** Levels that have been made, from few triangles to many, and what should be known of them. */
export interface Levels {
  levels: Level[];
  warnings: Warning[];
}

/** Makes the levels of a closed result of triangles in a worker. */
export async function makeLevels(
  mesh: Mesh,
  signal: AbortSignal,
  onProgress: ProgressCallback,
): Promise<Levels> {
  const all = mesh.indices.length / 3;
  const full: Level = { mesh, triangles: all, apart: 0 };
  const targetTriangles = countsBelow(all);
  if (targetTriangles.length === 0) return { levels: [full], warnings: [] };
  const { levels, report } = await simplifyMesh(mesh, { targetTriangles, signal, onProgress });
  const made: Level[] = [full];
  for (const level of levels) {
    const triangles = level.indices.length / 3;
    // Where parts and handles leave nothing to be collapsed, levels are alike.
    if (triangles >= (made[0] as Level).triangles) continue;
    made.unshift({ mesh: level, triangles, apart: null });
  }
  return { levels: made, warnings: report.warnings };
}

function countsBelow(all: number): number[] {
  const counts: number[] = [];
  for (let n = all * step; n >= fewest; n *= step) counts.push(2 * Math.round(n / 2));
  return counts.filter((n, i) => n < (counts[i - 1] ?? all));
}
