// SPDX-License-Identifier: MIT
// Types of reports, keys of their parts. Made by scripts/generate-options.mjs, not by hand.

import type { OwnFloat64Array, OwnUint32Array } from './outside-types.js';

/** What the grid was built from. */
export interface InputReport {
  /** After joining vertices of exactly equal position. */
  vertices: number;
  /** Triangles of the input. */
  triangles: number;
  /** Every edge is used equally often in both directions. */
  closed: boolean;
  /** Edges with one face. */
  boundaryEdges: number;
  /**
   * Closed rounds of the edges at which the surface ends: those with one face, and faces without a
   * neighbour that runs against them along the edge. `repair`: once the surface is sewn and turned.
   */
  boundaryLoops: number;
  /** Edges with three or more faces. */
  nonManifoldEdges: number;
  /** Faces without area once positions are rounded; they take no part. */
  degenerateFaces: number;
  /** Faces that lie back to back in pairs; they take no part. */
  cancelledFaces: number;
  /** `repair`, `odd`: faces over the same corners as others; they take no part. */
  duplicateFaces: number;
  /** `repair`: pairs of boundary edges, no further apart than the tolerance, that were joined. */
  sewnEdges: number;
  /** `repair`: faces that were turned to agree with their neighbours and look outwards. */
  turnedFaces: number;
  /**
   * `repair`: closed parts that were inside out and have been turned, their faces counting as
   * turned too. Cavities are none. 0 if the whole input was inside out (`flipped`).
   */
  turnedParts: number;
  /**
   * `repair`: false if so many closed parts overlap that nobody has looked which lie in which; then
   * none was turned by itself.
   */
  nestingKnown: boolean;
  /** Parts joined by edges. */
  components: number;
  /** `repair`: holes that were closed by patches over their corners. */
  patchedHoles: number;
  /** `repair`: area of these patches. In square model units. */
  patchArea: number;
  /** `repair`: parts that were left out because they bound nothing. */
  lostParts: number;
  /** `repair`: area of these parts. In square model units. */
  lostArea: number;
  /** `repair`: area of the largest of them. In square model units. */
  largestLost: number;
  /** `repair`: parts that bound nothing and were given a thickness. */
  thickenedParts: number;
  /**
   * Parts that were built by themselves. `repair`: those that neither sewing nor patches close,
   * beside others that are closed. `repair`, `positive`: thin parts that cross or touch each other,
   * which their union replaces.
   */
  rebuiltParts: number;
  /** What the tolerance was for these parts, at most. In model units. */
  rebuildingTolerance: number;
  /**
   * `repair`: distance up to which boundary edges were joined: the tolerance, or more where most of
   * them lie further from their partners; 0 if none was joined. In model units.
   */
  sewingDistance: number;
  /** Parts that hold next to no area and lie far from the rest; `extent` leaves them out. */
  strayParts: number;
  /**
   * The length that a relative tolerance is a fraction of: the diagonal of the bounding box,
   * without stray parts. In model units.
   */
  extent: number;
  /** The input was inside out and has been turned. */
  flipped: boolean;
  /** The step to which positions were rounded for decisions. In model units. */
  latticeStep: number;
}

/** The size of a grid. */
export interface GridStats {
  /** Nodes of the kd-tree. */
  cells: number;
  /** Cells that are not split. */
  leaves: number;
  /** Intersections of the surface with grid edges. */
  hits: number;
  /** Depth of the deepest leaf. */
  depth: number;
  /** The grid was built as a `sheet`: results may have a boundary. */
  sheet: boolean;
  /** Memory that the grid holds. In bytes. */
  bytes: number;
  /** The tolerance that was asked for; 0: none. In model units. */
  askedTolerance: number;
  /**
   * How far the result may be from the input: the tolerance that was asked for, or a wider one
   * where a surface to be repaired would have taken beyond all measure. For strategies without a
   * tolerance: the one that extraction goes by. Of a grid by itself that was built for a reduced
   * result: 0.8 times it. In model units.
   */
  tolerance: number;
  /**
   * How far the surface may have moved as the grid was simplified, which comes on top of the
   * tolerance; 0: it was not. In model units.
   */
  simplified: number;
  /**
   * `repair`: winding numbers above this are inside; 0 where the surface is closed and none had to
   * be asked for.
   */
  windingThreshold: number;
  /**
   * `adaptive`, `octree`, `feature`: no leaf was given up and no face was guessed; the result of an
   * embedded input then has its topology. The other strategies do not look: false.
   */
  topologyResolved: boolean;
  /** Leaves given up at the depth limit or below the least size of a cell. */
  unresolvedLeaves: number;
  /**
   * Centres of these leaves, three coordinates each: of all, or, of more than 1,000, of every
   * second, fourth and so on. Saved grids do not keep them. In model units.
   */
  unresolvedPositions: OwnFloat64Array;
  /**
   * `adaptive`, `octree`, `feature`: parts about as thin as the tolerance that meet no others; they
   * are taken over just as they are in the input, or as they were rebuilt.
   */
  exactParts: number;
  /** Triangles of these parts. */
  exactTriangles: number;
  /** Further thin parts, whose thickness may differ in the result. */
  thinParts: number;
  /** Faces between leaves with more than two hits. */
  ambiguousFaces: number;
  /** Ambiguous faces that a trace of the input could not decide. */
  guessedFaces: number;
  /** Hits of no input face, where holes were closed. */
  inventedHits: number;
  /**
   * Area of the surface that is thinner than `minimumThickness`, and gone. In square model units.
   */
  thinArea: number;
  /**
   * Area of the surface that bounds gaps narrower than `minimumGap`, which are filled. In square
   * model units.
   */
  narrowArea: number;
}

/** How a mesh was made of a grid. */
export interface ExtractReport {
  /** Closed walks along the boundary; only sheets have one. */
  boundaryLoops: number;
  /** Parts without volume that were left out. */
  droppedPillows: number;
  /** Vertices added to keep edges apart. */
  insertedVertices: number;
  /** Vertices added for further features of a cell. */
  splitVertices: number;
  /** Vertices added between cells and at hits. */
  linkVertices: number;
  /** Edges flipped, of triangles that were folded over or thin. */
  flippedEdges: number;
  /** `embedded`: hits that got vertices so that nothing crosses. */
  refinedHits: number;
  /** Parts left out because of the option `parts`. */
  droppedParts: number;
  /** Parts left out because of `dropParts`, with what lay in them. */
  smallParts: number;
  /** Volume taken away with them. In cubic model units. */
  smallPartsVolume: number;
  /** Cavities filled because of `dropCavities`, with what lay in them. */
  smallCavities: number;
  /** Volume filled with them. In cubic model units. */
  smallCavitiesVolume: number;
  /** Handles removed because of `dropHandles`. */
  smallHandles: number;
  /**
   * Handles smaller than `dropHandles` that are still there, since nothing closes them without
   * meeting the surface.
   */
  keptHandles: number;
  /** Slivers beside closed holes that were left out. */
  droppedCrumbs: number;
  /**
   * Area of the faces that stand for no input face but close a hole; their source face is
   * 4294967295. In square model units.
   */
  inventedArea: number;
  /**
   * `embedded`: pairs of triangles that still cross or touch, and triangles without area; 0 unless
   * parts of the surface nearer to each other than 32 bits tell apart are in each other's way, or
   * sheets cross. Otherwise null: nobody has looked.
   */
  crossings: number | null;
}

/** How a grid was simplified. */
export interface SimplifyReport {
  /** Splits that were removed from the grid. */
  removedSplits: number;
  /** Nodes of the kd-tree before. */
  cellsBefore: number;
  /** Nodes that are left. */
  cells: number;
  /** Intersections of the surface with grid edges before. */
  hitsBefore: number;
  /** Intersections that are left. */
  hits: number;
  /**
   * The largest root mean square distance of merged hits from the plane that fits them best (the
   * paper's on-metric). In model units.
   */
  planeError: number;
  /**
   * How far the surface may now be from what it was when the grid was built: what all calls have
   * been allowed. In model units.
   */
  allowedError: number;
  /** Thin bodies that went, each with the cavities in it. */
  removedParts: number;
  /** Thin cavities that were filled. */
  filledCavities: number;
  /** Closed surfaces that bounded these bodies and cavities. */
  removedSurfaces: number;
  /** Handles that these surfaces had. */
  removedHandles: number;
}

/** How a mesh was reduced. */
export interface ReduceReport {
  /** Triangles of the mesh that was reduced. */
  trianglesBefore: number;
  /** Triangles that are left, of the last level. */
  triangles: number;
  /** Edges that were collapsed. */
  collapses: number;
  /** Edges that were flipped, at creases that the reference does not have. */
  flips: number;
}

/** What of the input the result does not come near. */
export interface LostArea {
  /** Area of the input that the result does not come near. In square model units. */
  area: number;
  /** Pieces of it, joined by vertices. */
  parts: number;
  /** Area of the largest piece. In square model units. */
  largest: number;
  /** `area` as a fraction of the input's whole area. */
  share: number;
  /**
   * Not in `area`: what lies within the solid, so that the inside rule drops it. Where the input is
   * closed, only walls with solid on both sides. In square model units.
   */
  innerArea: number;
  /** The input's triangles that are lost, in whole or part. */
  faces: OwnUint32Array;
}

/** How far points of one surface are from another. */
export interface Deviation {
  /** Of all vertices and points that were looked at. In model units. */
  largest: number;
  /** Root of the mean square over the area. In model units. */
  rms: number;
}

/** How far a result and its input are apart. */
export interface MeshError {
  /** How far the result's points are from the input; those of what closes holes count too. */
  toInput: Deviation;
  /**
   * How far the input's points are from the result, without what lies within the solid, more than a
   * tolerance deep.
   */
  toOutput: Deviation;
}

/**
 * What can be said about a mesh; two faces meet where they use the same vertex numbers. Degenerate
 * faces are counted and take no part in anything else.
 */
export interface MeshReport {
  /** Positions, also those that no face uses. */
  vertices: number;
  /** Faces with three corners. */
  triangles: number;
  /** Faces with four corners. */
  quads: number;
  /** Positions that no face uses. */
  unreferencedVertices: number;
  /** Edges with one face. */
  boundaryEdges: number;
  /** Closed rounds of boundary edges; those that touch in a vertex count apart. */
  boundaryLoops: number;
  /** Edges with three or more faces. */
  nonManifoldEdges: number;
  /** Edges whose two faces run the same way along them. */
  misorientedEdges: number;
  /** Vertices whose faces do not form one fan; the ends of non-manifold edges are among them. */
  nonManifoldVertices: number;
  /** Faces with a repeated vertex. */
  degenerateFaces: number;
  /** Faces over the same vertices as an earlier one. */
  duplicateFaces: number;
  /** Parts joined by edges. */
  components: number;
  /** Referenced vertices - edges + faces: 2 for a sphere, less 2 for every handle. */
  eulerCharacteristic: number;
  /** There is no edge with one face, and at least one face. */
  closed: boolean;
  /**
   * Closed, and every edge and every vertex is that of a surface, consistently oriented; no face is
   * degenerate or double.
   */
  twoManifold: boolean;
  /** The same, but there may be a boundary, as sheets have. */
  manifold: boolean;
  /**
   * Signed, positive where normals point outwards; means nothing unless the mesh is closed and
   * oriented. In cubic model units.
   */
  volume: number;
  /** A quad counts as its two triangles at the corners 0 and 2. In square model units. */
  area: number;
  /** Bounding box of the referenced vertices. In model units. */
  bounds: { min: Float64Array; max: Float64Array };
}

/** The part of a report about the result. */
export interface OutputReport {
  /** Positions, also those that no face uses. */
  vertices: number;
  /** Faces with three corners. */
  triangles: number;
  /** Faces with four corners. */
  quads: number;
  /** Parts joined by edges. */
  components: number;
  /** Referenced vertices - edges + faces: 2 for a sphere, less 2 for every handle. */
  eulerCharacteristic: number;
  /**
   * Closed, and every edge and every vertex is that of a surface, consistently oriented; no face is
   * degenerate or double.
   */
  twoManifold: boolean;
  /** The same, but there may be a boundary, as sheets have. */
  manifold: boolean;
  /** There is no edge with one face, and at least one face. */
  closed: boolean;
  /** Closed walks along the boundary; only sheets have one. */
  boundaryLoops: number;
  /**
   * Signed, positive where normals point outwards; means nothing unless the mesh is closed and
   * oriented. In cubic model units.
   */
  volume: number;
  /** A quad counts as its two triangles at the corners 0 and 2. In square model units. */
  area: number;
  /** Parts without volume that were left out. */
  droppedPillows: number;
  /** Vertices added to keep edges apart. */
  insertedVertices: number;
  /** Vertices added for further features of a cell. */
  splitVertices: number;
  /** Vertices added between cells and at hits. */
  linkVertices: number;
  /** Edges flipped, of triangles that were folded over or thin. */
  flippedEdges: number;
  /** `embedded`: hits that got vertices so that nothing crosses. */
  refinedHits: number;
  /** Parts left out because of the option `parts`. */
  droppedParts: number;
  /** Parts left out because of `dropParts`, with what lay in them. */
  smallParts: number;
  /** Volume taken away with them. In cubic model units. */
  smallPartsVolume: number;
  /** Cavities filled because of `dropCavities`, with what lay in them. */
  smallCavities: number;
  /** Volume filled with them. In cubic model units. */
  smallCavitiesVolume: number;
  /** Handles removed because of `dropHandles`. */
  smallHandles: number;
  /**
   * Handles smaller than `dropHandles` that are still there, since nothing closes them without
   * meeting the surface.
   */
  keptHandles: number;
  /** Slivers beside closed holes that were left out. */
  droppedCrumbs: number;
  /**
   * Area of the faces that stand for no input face but close a hole; their source face is
   * 4294967295. In square model units.
   */
  inventedArea: number;
  /**
   * `embedded`: pairs of triangles that still cross or touch, and triangles without area; 0 unless
   * parts of the surface nearer to each other than 32 bits tell apart are in each other's way, or
   * sheets cross. Otherwise null: nobody has looked.
   */
  crossings: number | null;
}

/** Faces that cross or touch others where they share no vertex or edge. */
export interface SelfIntersections {
  /** Pairs of triangles; a quad counts as its two triangles at the corners 0 and 2. */
  pairs: number;
  /** The faces that are part of a pair, ascending: triangles first, then quads. */
  faces: OwnUint32Array;
}

/** Faces joined by edges, as far as they are not degenerate. */
export interface MeshPart {
  /** The lowest of its faces. */
  firstFace: number;
  /** Number of its faces. */
  faces: number;
  /** Closed rounds of boundary edges. */
  boundaryLoops: number;
  /** Every edge is used equally often in both directions: the part bounds something. */
  closed: boolean;
  /**
   * Handles; null where the part is no oriented surface, because it has misoriented edges or edges
   * with three or more faces. Boundary loops count as if each were closed by a disk.
   */
  genus: number | null;
  /** Area of its faces. In square model units. */
  area: number;
  /**
   * Signed, positive where normals point outwards; 0 for parts that are not closed. In cubic model
   * units.
   */
  volume: number;
  /**
   * The smallest (its number in `parts`) of the closed parts that hold this closed part; null if
   * there is none. Parts that cross each other do not hold one another.
   */
  inside: number | null;
  /** Turned inwards within parts that are turned outwards: a hollow. */
  cavity: boolean;
  /** Turned inwards without being a cavity, or within parts that are turned inwards themselves. */
  insideOut: boolean;
}

/**
 * What is wrong with a mesh, with the faces, edges and vertices at fault. Vertices of exactly equal
 * position count as one: in lists the lowest of them stands for all. Faces are numbered as given,
 * triangles first, then quads. Faces and vertices ascend; edges, two vertices each, do so by the
 * lower, then by the higher vertex. Faces with a repeated vertex are in `degenerateFaces` and play
 * no part in any other list.
 */
export interface MeshDefects {
  /** What `describe` says once vertices of equal position are joined: the counts. */
  report: MeshReport;
  /**
   * There are faces, and every edge is used equally often in both directions. Of other meshes
   * `buildGrid` makes a solid by `repair` only.
   */
  balanced: boolean;
  /** Edges with one face, two vertices each, in the order in which the face has them. */
  boundaryEdges: OwnUint32Array;
  /**
   * The vertices of each closed round of boundary edges, in the direction of the faces where these
   * agree. Boundary edges that form none (they end on non-manifold edges) are left out.
   */
  boundaryLoops: OwnUint32Array[];
  /** Edges with three or more faces, two vertices each, the lower one first. */
  nonManifoldEdges: OwnUint32Array;
  /** Edges whose two faces run the same way along them, two vertices each, the lower one first. */
  misorientedEdges: OwnUint32Array;
  /** Vertices whose faces do not form one fan. */
  nonManifoldVertices: OwnUint32Array;
  /** Faces with a repeated vertex. */
  degenerateFaces: OwnUint32Array;
  /** Faces of different vertices that lie exactly on one line. */
  zeroAreaFaces: OwnUint32Array;
  /** Faces over the same vertices as a face before. */
  duplicateFaces: OwnUint32Array;
  /**
   * Faces turned against their neighbours, or with their whole part inwards, as far as volume and
   * what can be seen from outside tell: those that the inside rule `repair` turns.
   */
  flippedFaces: OwnUint32Array;
  /**
   * Only if asked for: pairs of triangles that cross, touch or lie on each other in that way; a
   * quad counts as its two triangles at the corners 0 and 2.
   */
  selfIntersections: number;
  /**
   * Only if asked for: faces that cross or touch others where they share no vertex or edge, and
   * faces that lie on each other.
   */
  selfIntersectingFaces: OwnUint32Array;
  /** One entry a face: its number in `parts`; 4294967295 for degenerate faces. */
  partOf: OwnUint32Array;
  /** The parts, in order of their first faces. */
  parts: MeshPart[];
  /**
   * False: thousands of closed parts overlap, so that nobody has looked which lie in which;
   * `inside` is then null, `cavity` and `insideOut` false for all.
   */
  nestingKnown: boolean;
}

/** @internal In order. */
export const outputKeys = [
  'vertices',
  'triangles',
  'quads',
  'components',
  'eulerCharacteristic',
  'twoManifold',
  'manifold',
  'closed',
  'boundaryLoops',
  'volume',
  'area',
  'droppedPillows',
  'insertedVertices',
  'splitVertices',
  'linkVertices',
  'flippedEdges',
  'refinedHits',
  'droppedParts',
  'smallParts',
  'smallPartsVolume',
  'smallCavities',
  'smallCavitiesVolume',
  'smallHandles',
  'keptHandles',
  'droppedCrumbs',
  'inventedArea',
  'crossings',
] as const;

/** @internal What --check looks for. */
export const checkKeys = [
  'twoManifold',
  'manifold',
  'closed',
  'boundaryEdges',
  'nonManifoldEdges',
  'misorientedEdges',
  'nonManifoldVertices',
  'degenerateFaces',
  'duplicateFaces',
] as const;

/** @internal What --stats counts. */
export const defectKeys = [
  'boundaryEdges',
  'boundaryLoops',
  'nonManifoldEdges',
  'misorientedEdges',
  'nonManifoldVertices',
  'degenerateFaces',
  'zeroAreaFaces',
  'duplicateFaces',
  'flippedFaces',
  'selfIntersections',
  'selfIntersectingFaces',
  'openParts',
  'insideOutParts',
  'cavities',
  'genus',
  'area',
  'volume',
  'nestingKnown',
] as const;

/** @internal The fields of `MeshPart` in order, and their types. */
export const partKeys = [
  ['firstFace', 'integer'],
  ['faces', 'integer'],
  ['boundaryLoops', 'integer'],
  ['closed', 'boolean'],
  ['genus', 'integer or null'],
  ['area', 'number'],
  ['volume', 'number'],
  ['inside', 'integer or null'],
  ['cavity', 'boolean'],
  ['insideOut', 'boolean'],
] as const;
