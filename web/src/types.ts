// SPDX-License-Identifier: MIT
// What goes in and what comes out. The ranges and defaults of options are in options.ts.

/** A mesh as the caller has it. */
export interface MeshInput {
  /** Coordinates, three per vertex. */
  positions: Float32Array | Float64Array;
  /** Vertex numbers, three per triangle, counter-clockwise seen from outside. Without them every
   * three positions are a triangle; vertices of exactly equal position are joined anyway. */
  indices?: Uint16Array | Uint32Array | null;
  /** One number per triangle that `sourceFaces` of the result refers to; else the triangle's own. */
  sourceFaces?: Uint32Array | null;
}

/** A mesh that may also have quads, as `Grid.extract` gives on request. */
export interface PolygonMeshInput extends MeshInput {
  /** Vertex numbers, four per quad. */
  quads?: Uint32Array | null;
  /** Unit normals for shading, three numbers per corner of a triangle, then of a quad. */
  cornerNormals?: Float32Array | null;
}

/** A mesh as the library gives it: copies that the caller owns. */
export interface Mesh {
  /** Coordinates, three per vertex. */
  positions: Float32Array<ArrayBuffer>;
  /** Vertex numbers, three per triangle, counter-clockwise seen from outside. */
  indices: Uint32Array<ArrayBuffer>;
  /** Vertex numbers, four per quad; only with the option `quads`, and only if there are any. */
  quads?: Uint32Array<ArrayBuffer>;
  /** The input face behind each face: one entry a triangle, then one a quad. */
  sourceFaces: Uint32Array<ArrayBuffer>;
  /**
   * Unit normals for shading, nine numbers per triangle (three per corner), then twelve per quad; only
   * with the option `normals`. Vertices on a crease are not doubled: `kdmanifold/three` does that.
   */
  cornerNormals?: Float32Array<ArrayBuffer>;
}

/** A mesh from a file, or thickened; positions as precise as they are known. */
export interface ParsedMesh {
  /** Coordinates, three per vertex. */
  positions: Float64Array<ArrayBuffer>;
  /** Vertex numbers, three per triangle. */
  indices: Uint32Array<ArrayBuffer>;
  /** The face (from 0) of the file, or of the surface, that each triangle was made from. */
  sourceFaces: Uint32Array<ArrayBuffer>;
}

/** The file formats that are read and written. */
export type MeshFormat = 'obj' | 'stl' | 'ply' | 'off';

/**
 * Told how far a long call is: the fraction done (0 to 1, never falling) and the name of the step.
 * Returning `false` stops the call, which then fails with `ABORTED`.
 */
export type ProgressCallback = (fraction: number, phase: string) => boolean | void;

/** How a mesh becomes a grid. */
export interface BuildOptions {
  /**
   * How cells are split:
   * - `adaptive` (default): until the surface is met within the tolerance and its topology resolved
   * - `octree`: the same, but at midpoints, x, y, z in turn
   * - `feature`: the same, but through or near features of the cell (paper 5.1.2 (2))
   * - `median`: median of triangle centres, until every triangle is hit by a grid edge
   * - `uniform`: midpoints to the full depth wherever a cell meets the surface
   */
  strategy?: 'adaptive' | 'octree' | 'feature' | 'median' | 'uniform';
  /**
   * `adaptive`, `octree`, `feature`: how far the result may be from the input, in the model's units. At 0
   * (default) `relativeTolerance` counts instead.
   */
  tolerance?: number;
  /**
   * The same as a fraction of the diagonal of the input's bounding box, default 0.001. At 0 all
   * that is not flat is split down to the depth limit.
   */
  relativeTolerance?: number;
  /**
   * Limit of the tree's depth, 1 to 60; three levels halve a cell in each axis. Left out: 18 for
   * `uniform` (64 cells an axis), else 60, a safety net.
   */
  depth?: number;
  /**
   * Which winding numbers are inside:
   * - `repair` (default): `positive` if the surface is closed and consistently oriented; any other
   *   becomes a solid by its generalised winding number: holes are closed, faces turned back
   * - `positive`: above 0, the union of overlapping and nested shells
   * - `odd`: odd ones
   * - `nonzero`: all but 0
   * - `sheet`: there is no inside; all of the surface is kept, as it is turned, and open surfaces stay
   *   open: the result is a manifold with boundary. Any mesh will do; it comes apart where neighbours
   *   are turned against each other
   */
  inside?: 'repair' | 'positive' | 'odd' | 'nonzero' | 'sheet';
  /**
   * With `repair`: winding numbers above this are inside. Not negative, below 1; 0, the default, stands for
   * the one up to 0.5 that keeps most of the input's area. Lower closes wider gaps, and lets what bulges
   * over them bulge further.
   */
  windingThreshold?: number;
  /**
   * With `repair`: holes wider than this (the diagonal of their bounding box, the model's units) are not
   * closed but refused with `NOT_CLOSED`. Not negative, default 0, which closes all.
   */
  largestHole?: number;
  /**
   * How hits are linked where a minimal face carries more than two:
   * - `trace` (default): as the input's surface crosses the face
   * - `hermite`: by the least deviation from the hits' tangents
   * - `inside`, `outside`: the two fixed rules of the paper, for comparison
   */
  pairing?: 'trace' | 'hermite' | 'inside' | 'outside';
  /**
   * Takes the input for a surface that bounds nothing, which may be open, and builds the shell of this
   * thickness around it, in model units (see `KdManifold.thicken`). Not negative; default 0: the input
   * itself. The report's `input` is that of the shell.
   */
  thicken?: number;
}

/** How a grid becomes a mesh. */
export interface ExtractOptions {
  /** Join the two triangles of an edge where four leaves meet to one quad (default false). */
  quads?: boolean;
  /**
   * Split vertices that lie further than this from a plane they stand for, in model units, so that a
   * leaf can hold several features (paper 2.3.1). Not negative; more than the model's size: never.
   * Default 0: where they are further off than the grid's tolerance and 0.3 times the way to their hits, but
   * never with `quads`.
   */
  splitError?: number;
  /**
   * Where a vertex goes if the best place for it lies outside of its cell:
   * - `constrained` (default): to the best place within the cell
   * - `projection`: to the point of the cell that is nearest to the best place
   */
  position?: 'constrained' | 'projection';
  /**
   * Flip edges of triangles that are folded over their neighbours, where that lays them flat, and of thin ones (an
   * angle below two degrees), where that makes their smallest angle twice as wide (default true). Takes away most
   * self-intersections and most thin triangles. Not with `quads`.
   */
  unfold?: boolean;
  /**
   * Put a vertex where an edge passes from one leaf to another further from the surface than this, in model
   * units. Not negative; more than the model's size: never. Default 0: the grid's tolerance. Not with `quads`.
   */
  linkError?: number;
  /**
   * Which parts are kept:
   * - `all` (default): all but crumbs, slivers thinner than the tolerance beside holes that were closed
   * - `outer`: only those that lie in no other: no cavities, and nothing within cavities
   * - `largest`: only the one that encloses most, without its cavities
   */
  parts?: 'all' | 'outer' | 'largest';
  /**
   * What the result must be as an index mesh:
   * - `manifold` (default): 2-manifold; vertices keep apart what would share an edge, parts without volume go
   * - `embedded`: the same, and no two triangles cross or touch but where they share vertices; holds for the
   *   32-bit positions. Not with `quads`
   * - `off`: the raw dual surface, whose half-edges are manifold but not its vertex numbers
   */
  strict?: 'off' | 'manifold' | 'embedded';
  /** Give every corner of the faces a normal for shading, from the input's (default false). */
  normals?: boolean;
  /**
   * With `normals`: where neighbouring faces turn by more than this there is a crease, and their corners
   * keep different normals; degrees, 0 (all but flat parts) to 180 (no crease at all), default 30.
   */
  creaseAngle?: number;
}

/** What a long synchronous call takes besides. */
export interface ProgressOptions {
  /** Called at bounded intervals, on the thread that works. */
  onProgress?: ProgressCallback;
}

/** What the grid was built from. */
export interface InputReport {
  /** After joining vertices of exactly equal position. */
  vertices: number;
  triangles: number;
  /** Every edge is used equally often in both directions. */
  closed: boolean;
  boundaryEdges: number;
  /** Of the edges at which the surface ends. */
  boundaryLoops: number;
  /** Edges with three or more faces. */
  nonManifoldEdges: number;
  /** Faces without area on the lattice; they take no part. */
  degenerateFaces: number;
  /** Faces that lie back to back in pairs; they take no part. */
  cancelledFaces: number;
  /** `repair`: further faces over the same corners; they take no part. */
  duplicateFaces: number;
  /** `repair`: pairs of boundary edges, no further apart than the tolerance, that were joined. */
  sewnEdges: number;
  /** `repair`: faces that were turned to agree and look outwards. */
  turnedFaces: number;
  /** Parts joined by edges. */
  components: number;
  /** The input was inside out and has been turned. */
  flipped: boolean;
  /** What positions were rounded to for decisions, in the model's units. */
  latticeStep: number;
}

/** The size of a grid. */
export interface GridStats {
  /** Nodes of the kd-tree. */
  cells: number;
  leaves: number;
  /** Intersections of the surface with grid edges. */
  hits: number;
  /** Built as a `sheet`: results may have a boundary. */
  sheet: boolean;
  /** Depth of the deepest leaf. */
  depth: number;
  /** Memory that the grid holds. */
  bytes: number;
  /**
   * In the model's units: what was asked for, or more where a surface to be repaired would have
   * taken beyond all measure. Of strategies that ask for none, what extraction goes by.
   */
  tolerance: number;
  /** `repair`: winding numbers above it are inside; 0 where the surface is closed and none had to be asked for. */
  windingThreshold: number;
  /**
   * `adaptive` and `octree`: no leaf was given up and no face was guessed; the result of an embedded
   * input then has its topology. The others do not look: false.
   */
  topologyResolved: boolean;
  /** Leaves given up at the depth limit or below the size floor. */
  unresolvedLeaves: number;
  /** Minimal faces with more than two hits. */
  ambiguousFaces: number;
  /** Of these, the ones that a trace of the input could not decide. */
  guessedFaces: number;
  /** Hits of no input face, where holes were closed. */
  inventedHits: number;
}

/** What strictness cost. */
export interface ExtractReport {
  /** Parts without volume that were left out. */
  droppedPillows: number;
  /** Vertices added to keep edges apart. */
  insertedVertices: number;
  /** Vertices added for further features of a leaf. */
  splitVertices: number;
  /** Vertices added between leaves and at hits. */
  linkVertices: number;
  /** Edges of triangles that were folded over or thin. */
  flippedEdges: number;
  /** `embedded`: hits that got vertices so that nothing crosses. */
  refinedHits: number;
  /**
   * `embedded`: pairs of triangles that still cross or touch; 0 unless parts of the surface nearer to each other
   * than 32 bits tell apart are in each other's way, or sheets cross. Else null: nobody has looked.
   */
  crossings: number | null;
  /** Parts left out as `parts` asks. */
  droppedParts: number;
  /** Slivers beside closed holes that were left out. */
  droppedCrumbs: number;
  /** Area of the faces that are of no input face but close it; their source face is 4294967295. */
  inventedArea: number;
  /** Closed walks along the boundary; only sheets have one. */
  boundaryLoops: number;
}

/** What `Grid.extract` gives. */
export interface ExtractedMesh extends Mesh {
  report: ExtractReport;
}

/** What can be said about a mesh; two faces meet where they use the same vertex numbers. */
export interface MeshReport {
  /** Positions, also unreferenced ones. */
  vertices: number;
  triangles: number;
  quads: number;
  unreferencedVertices: number;
  /** Edges with one face. */
  boundaryEdges: number;
  /** Closed rounds of boundary edges; those that touch in a vertex count apart. */
  boundaryLoops: number;
  /** Edges with three or more faces. */
  nonManifoldEdges: number;
  /** Edges whose two faces run the same way along it. */
  misorientedEdges: number;
  /** Vertices whose faces do not form one fan. */
  nonManifoldVertices: number;
  /** Faces with a repeated vertex. */
  degenerateFaces: number;
  /** Faces over the same vertices as an earlier one. */
  duplicateFaces: number;
  /** Parts joined by edges. */
  components: number;
  /** Referenced vertices - edges + faces. */
  eulerCharacteristic: number;
  /** No edge with one face, and at least one face. */
  closed: boolean;
  /** Closed, and none of the faults above. */
  twoManifold: boolean;
  /** The same, but there may be a boundary. */
  manifold: boolean;
  /** Signed; positive where normals point outwards. */
  volume: number;
  area: number;
  bounds: { min: Float64Array; max: Float64Array };
}

/** Faces that cross or touch others where they share no vertex or edge. */
export interface SelfIntersections {
  /** Pairs of triangles; a quad counts as its two at the corners 0 and 2. */
  pairs: number;
  /** The faces that are part of one, ascending: triangles first, then quads. */
  faces: Uint32Array<ArrayBuffer>;
}

/** What `KdManifold.analyze` looks for. */
export interface AnalyzeOptions {
  /**
   * Look for self-intersections too (default false): takes several times as long as all the rest, and far
   * longer where many faces overlap that are no copies of each other.
   */
  selfIntersections?: boolean;
}

/** Faces joined by edges, as far as they are not degenerate. */
export interface MeshPart {
  /** The lowest of its faces. */
  firstFace: number;
  faces: number;
  boundaryLoops: number;
  /** Every edge is used equally often in both directions: the part bounds something. */
  closed: boolean;
  /**
   * Handles; null where the part is no oriented surface, because it has misoriented edges or edges with
   * three or more faces. Boundary loops count as if each were closed by a disk.
   */
  genus: number | null;
  area: number;
  /** Signed, positive where normals point outwards; of closed parts, else 0. */
  volume: number;
  /** Among the closed parts that hold this closed part, the smallest (its number in `parts`); or null. */
  inside: number | null;
  /** Turned inwards within parts that are turned outwards: a hollow. */
  cavity: boolean;
  /** Turned inwards without being a cavity, or within parts that are turned inwards themselves. */
  insideOut: boolean;
}

/**
 * What is wrong with a mesh, with the faces, edges and vertices at fault. Vertices of exactly equal position
 * count as one: in lists the lowest of them stands for all. Faces are numbered as given, triangles first,
 * then quads. Faces and vertices ascend; edges, two vertices each, do so by the lower, then by the higher one.
 * Faces with a repeated vertex are in `degenerateFaces` and play no part in any other list.
 */
export interface MeshDefects {
  /** What `describe` says once vertices of equal position are joined: the counts. */
  report: MeshReport;
  /** There are faces, and every edge is used equally often in both directions, as `buildGrid` wants solids. */
  balanced: boolean;
  /** Edges with one face, two numbers each, in the order in which the face has them. */
  boundaryEdges: Uint32Array<ArrayBuffer>;
  /** Edges with three or more faces, two numbers each. */
  nonManifoldEdges: Uint32Array<ArrayBuffer>;
  /** Edges whose two faces run the same way along it, two numbers each. */
  misorientedEdges: Uint32Array<ArrayBuffer>;
  /**
   * The vertices of each closed round of boundary edges, in the direction of the faces where these agree.
   * Boundary edges that form none (they end on non-manifold edges) are left out.
   */
  boundaryLoops: Uint32Array<ArrayBuffer>[];
  /** Vertices whose faces do not form one fan. */
  nonManifoldVertices: Uint32Array<ArrayBuffer>;
  /** Faces with a repeated vertex. */
  degenerateFaces: Uint32Array<ArrayBuffer>;
  /** Faces of different vertices that lie exactly on one line. */
  zeroAreaFaces: Uint32Array<ArrayBuffer>;
  /** Faces over the same vertices as a face before. */
  duplicateFaces: Uint32Array<ArrayBuffer>;
  /**
   * Turned against their neighbours, or with their whole part inwards, as far as volume and what can be seen
   * from outside tell: those that the inside rule `repair` turns.
   */
  flippedFaces: Uint32Array<ArrayBuffer>;
  /**
   * Only if asked for: faces that cross or touch others where they share no vertex or edge, and those that
   * lie on each other.
   */
  selfIntersectingFaces: Uint32Array<ArrayBuffer>;
  /** The number of their pairs. */
  selfIntersections: number;
  /** One a face: number in `parts`; 0xffffffff for degenerate faces. */
  partOf: Uint32Array<ArrayBuffer>;
  /** In order of their first faces. */
  parts: MeshPart[];
  /**
   * False: thousands of closed parts overlap, so that nobody has looked which lie in which; `inside` is then
   * null, `cavity` and `insideOut` false for all.
   */
  nestingKnown: boolean;
}

/** The part of `Report` about the result. */
export interface OutputReport extends ExtractReport {
  vertices: number;
  triangles: number;
  quads: number;
  /** Parts joined by edges. */
  components: number;
  /** Vertices - edges + faces; 2 for a sphere, less 2 for every handle. */
  eulerCharacteristic: number;
  /** Closed, and every edge and every vertex is that of a surface, consistently oriented. */
  twoManifold: boolean;
  /** The same, but there may be a boundary: what a sheet comes out as. */
  manifold: boolean;
  closed: boolean;
  volume: number;
  area: number;
}

/** The account of one conversion. */
export interface Report {
  input: InputReport;
  grid: GridStats;
  output: OutputReport;
  /** Wall-clock time of the steps. */
  seconds: { build: number; extract: number };
  /** Size of the WebAssembly heap, which never shrinks: the most that any call so far needed. */
  peakBytes: number;
}

/** What `makeManifold` gives. */
export interface Conversion {
  mesh: Mesh;
  report: Report;
}
