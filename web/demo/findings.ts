// SPDX-License-Identifier: MIT
// What is wrong with an input, kind by kind, and what is new in a result; where to paint it.
import type { Mesh, MeshDefects, MeshInput, Report } from 'kdmanifold';

/** The kinds of defects that the page tells apart, in the order in which it names them. */
export const defectKinds = [
  'open',
  'crowded',
  'pinched',
  'disagreeing',
  'flipped',
  'doubled',
  'degenerate',
  'crossing',
] as const;
export type DefectKind = (typeof defectKinds)[number];

/**
 * `invented`: faces of a result that are of no input face; `lost`: faces of the input that the result does not come
 * near; `unresolved`: places where the topology was given up.
 */
export type Kind = DefectKind | 'invented' | 'lost' | 'unresolved';

/** One kind of thing, found at least once. */
export interface Finding<K extends Kind = Kind> {
  kind: K;
  /** Edges, vertices or faces. */
  count: number;
  shape: 'lines' | 'faces' | 'points';
  /** Ends of lines, corners of triangles, or points: three numbers each. */
  positions: Float32Array<ArrayBuffer>;
}

/** What is known of an input apart from its defects. */
export interface Summary {
  parts: number;
  openParts: number;
  insideOutParts: number;
  /** Hollows; null: too many parts overlap for them to be told. */
  cavities: number | null;
  /** Handles; null where a part is no oriented surface. */
  tunnels: number | null;
  holes: number;
  closed: boolean;
}

export function summaryOf(defects: MeshDefects): Summary {
  const { parts, boundaryLoops, balanced, nestingKnown } = defects;
  const handles = parts.map(({ genus }) => genus);
  return {
    parts: parts.length,
    openParts: parts.filter((part) => !part.closed).length,
    insideOutParts: parts.filter((part) => part.insideOut).length,
    cavities: nestingKnown ? parts.filter((part) => part.cavity).length : null,
    tunnels: handles.includes(null) ? null : handles.reduce<number>((sum, n) => sum + Number(n), 0),
    holes: boundaryLoops.length,
    closed: balanced,
  };
}

/** All kinds but the crossings. */
export function findingsOf(mesh: MeshInput, defects: MeshDefects): Finding<DefectKind>[] {
  const { nonManifoldEdges, nonManifoldVertices } = defects;
  // Where edges have too many faces, so have their ends: no need to say it twice.
  const ends = new Set(nonManifoldEdges);
  const pinched = nonManifoldVertices.filter((vertex) => !ends.has(vertex));
  const degenerate = [...defects.degenerateFaces, ...defects.zeroAreaFaces];
  const list: Finding<DefectKind>[] = [
    lines('open', mesh, defects.boundaryEdges),
    lines('crowded', mesh, nonManifoldEdges),
    { kind: 'pinched', count: pinched.length, shape: 'points', positions: gather(mesh, pinched) },
    lines('disagreeing', mesh, defects.misorientedEdges),
    faces('flipped', mesh, defects.flippedFaces),
    faces('doubled', mesh, defects.duplicateFaces),
    // They have no area to be seen by.
    {
      ...lines('degenerate', mesh, outlines(mesh, degenerate)),
      count: degenerate.length,
    },
  ];
  return list.filter(({ count }) => count > 0);
}

/** The kind that takes longest to find. */
export function crossingsOf(mesh: MeshInput, crossing: Uint32Array): Finding<DefectKind>[] {
  return crossing.length === 0 ? [] : [faces('crossing', mesh, crossing)];
}

/** Faces of the input that are missing from the result, in whole or part. */
export function lostOf(mesh: MeshInput, { lost }: Report): Finding[] {
  return !lost || lost.faces.length === 0 ? [] : [faces('lost', mesh, lost.faces)];
}

/** Where the topology was given up; of very many places a part is shown. */
export function unresolvedOf({ grid }: Report): Finding[] {
  const { unresolvedLeaves: count, unresolvedPositions } = grid;
  if (count === 0) return [];
  const positions = Float32Array.from(unresolvedPositions);
  return [{ kind: 'unresolved', count, shape: 'points', positions }];
}

/** Faces of a result that close holes of its input; of quads there are none. */
export function inventedOf(mesh: Mesh): Finding[] {
  const invented: number[] = [];
  for (let t = 0; t < mesh.indices.length / 3; ++t) {
    if (mesh.sourceFaces[t] === noFace) invented.push(t);
  }
  return invented.length === 0 ? [] : [faces('invented', mesh, invented)];
}

const noFace = 0xffffffff;

function lines<K extends Kind>(kind: K, mesh: MeshInput, ends: ArrayLike<number>): Finding<K> {
  return { kind, count: ends.length / 2, shape: 'lines', positions: gather(mesh, ends) };
}

function faces<K extends Kind>(kind: K, mesh: MeshInput, list: ArrayLike<number>): Finding<K> {
  const corners = cornersOf(mesh, list);
  return { kind, count: list.length, shape: 'faces', positions: gather(mesh, corners) };
}

function cornersOf({ indices }: MeshInput, list: ArrayLike<number>): Uint32Array {
  const corners = new Uint32Array(3 * list.length);
  for (let i = 0; i < corners.length; ++i) {
    const corner = 3 * at(list, Math.floor(i / 3)) + (i % 3);
    corners[i] = indices ? at(indices, corner) : corner;
  }
  return corners;
}

function outlines(mesh: MeshInput, list: ArrayLike<number>): Uint32Array {
  const corners = cornersOf(mesh, list);
  const ends = new Uint32Array(2 * corners.length);
  for (let i = 0; i < corners.length; ++i) {
    ends[2 * i] = at(corners, i);
    ends[2 * i + 1] = at(corners, i % 3 === 2 ? i - 2 : i + 1);
  }
  return ends;
}

function gather({ positions }: MeshInput, vertices: ArrayLike<number>): Float32Array<ArrayBuffer> {
  const gathered = new Float32Array(3 * vertices.length);
  for (let i = 0; i < gathered.length; ++i) {
    gathered[i] = at(positions, 3 * at(vertices, Math.floor(i / 3)) + (i % 3));
  }
  return gathered;
}

const at = (array: ArrayLike<number>, i: number): number => array[i] as number;
