// SPDX-License-Identifier: MIT
// What scans and careless modellers do to a mesh: holes, faces turned over, faces doubled.
import type { MeshInput } from 'kdmanifold';

// Of every so many faces in a row, how many are damaged, and how.
const period = 2600;
const hole = 190;
const turned = { from: 1000, to: 1500 };
const doubled = { from: 1800, to: 1900 };

/** The same surface in bad order; needs a mesh with indices, of which neighbours are near. */
export function damage({ positions, indices }: MeshInput): MeshInput {
  const faces: number[] = [];
  for (let corner = 0; corner < (indices?.length ?? 0); corner += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => indices?.[corner + k]) as [number, number, number];
    const place = (corner / 3) % period;
    // Holes have ragged rims: now and then a face stays.
    if (place < hole && place % 64 > 12) continue;
    const over = place >= turned.from && place < turned.to;
    faces.push(a, ...(over ? [c, b] : [b, c]));
    if (place >= doubled.from && place < doubled.to) faces.push(a, b, c);
  }
  return { positions, indices: Uint32Array.from(faces) };
}
