// SPDX-License-Identifier: MIT
// What goes in and what comes out. Options and reports have files of their own.
import type { OwnFloat32Array, OwnFloat64Array, OwnUint32Array } from './outside-types.js';
import type {
  ExtractReport,
  GridStats,
  InputReport,
  LostArea,
  MeshError,
  OutputReport,
  ReduceReport,
  SimplifyReport,
} from './reports.js';

export type {
  AnalyzeOptions,
  BuildOptions,
  ExtractOptions,
  ReduceOptions,
  ReductionOptions,
  SimplifyOptions,
} from './options.js';
export type {
  Deviation,
  ExtractReport,
  GridStats,
  InputReport,
  LostArea,
  MeshDefects,
  MeshError,
  MeshPart,
  MeshReport,
  OutputReport,
  ReduceReport,
  SelfIntersections,
  SimplifyReport,
} from './reports.js';

/** Numbers of vertices or faces, in whatever array. */
export type WholeNumbers =
  | Uint32Array
  | Uint16Array
  | Uint8Array
  | Uint8ClampedArray
  | Int32Array
  | Int16Array
  | Int8Array
  | readonly number[];

/** A mesh as the caller has it. */
export interface MeshInput {
  /** Coordinates, three per vertex. */
  positions: Float32Array | Float64Array | readonly number[];
  /** Vertex numbers, three per triangle, counter-clockwise seen from outside. Without them every
   * three positions are a triangle; vertices of exactly equal position are joined anyway. */
  indices?: WholeNumbers | null;
  /** One number per triangle that `sourceFaces` of the result refers to; else the triangle's own. */
  sourceFaces?: WholeNumbers | null;
}

/** A mesh that may also have quads, as `Grid.extract` gives on request. */
export interface PolygonMeshInput extends MeshInput {
  /** Vertex numbers, four per quad. */
  quads?: WholeNumbers | null;
  /** Unit normals for shading, three numbers per corner of a triangle, then of a quad. */
  cornerNormals?: Float32Array | readonly number[] | null;
  /** Of a Boolean operation's result: the operand behind each face, as `Mesh.sourceOperands`. */
  sourceOperands?: WholeNumbers | null;
}

/** A mesh as the library gives it: copies that the caller owns. */
export interface Mesh {
  /** Coordinates, three per vertex. */
  positions: OwnFloat32Array;
  /** Vertex numbers, three per triangle, counter-clockwise seen from outside. */
  indices: OwnUint32Array;
  /** Vertex numbers, four per quad; only with the option `quads`, and only if there are any. */
  quads?: OwnUint32Array;
  /** The input face behind each face: one entry a triangle, then one a quad. */
  sourceFaces: OwnUint32Array;
  /**
   * The operand whose face each entry of `sourceFaces` names; only after Boolean operations. 4294967295 stands for the
   * box in which a complement was taken.
   */
  sourceOperands?: OwnUint32Array;
  /**
   * Unit normals for shading, nine numbers per triangle (three per corner), then twelve per quad; only
   * with the option `normals`. Vertices on a crease are not doubled: `kdmanifold/three` does that.
   */
  cornerNormals?: OwnFloat32Array;
}

/** A mesh from a file, or thickened; positions as precise as they are known. */
export interface ParsedMesh {
  /** Coordinates, three per vertex. */
  positions: OwnFloat64Array;
  /** Vertex numbers, three per triangle. */
  indices: OwnUint32Array;
  /** The face (from 0) of the file, or of the surface, that each triangle was made from. */
  sourceFaces: OwnUint32Array;
}

/** A mesh from a file, and what its reader says about it. */
export interface FileMesh extends ParsedMesh {
  /** What was skipped or assumed; empty if nothing was. */
  warnings: Warning[];
}

/** The file formats that are read and written. */
export type MeshFormat = 'obj' | 'stl' | 'ply' | 'off';

/**
 * Told how far a long call is: the fraction done (0 to 1, never falling) and the name of the step.
 * Returning `false` stops the call, which then fails with `ABORTED`.
 */
export type ProgressCallback = (fraction: number, phase: string) => boolean | void;

/** What a long synchronous call takes besides. */
export interface ProgressOptions {
  /** Called at bounded intervals, on the thread that works. */
  onProgress?: ProgressCallback;
}

/** Something that came out otherwise than one may take for granted. */
export interface Warning {
  /** For programs: the first three are of files, the rest of results. */
  code:
    | 'FACES_SKIPPED'
    | 'FACETS_MISCOUNTED'
    | 'NOT_READ'
    | 'AREA_LOST'
    | 'FAR_FROM_INPUT'
    | 'PARTS_LOST'
    | 'PARTS_DROPPED'
    | 'CAVITIES_FILLED'
    | 'HANDLES_REMOVED'
    | 'HANDLES_KEPT'
    | 'THIN_REMOVED'
    | 'GAPS_FILLED'
    | 'TOLERANCE_WIDENED'
    | 'TOPOLOGY_UNRESOLVED'
    | 'TRIANGLES_CROSS'
    | 'PARTS_TURNED'
    | 'NESTING_UNKNOWN'
    | 'SEWN_FAR'
    | 'HOLES_CLOSED'
    | 'WINDING_THRESHOLD'
    | 'STRAY_PARTS'
    | 'THIN_PARTS'
    | 'THIN_PARTS_EXACT';
  /** For people, with numbers. */
  message: string;
}

/** Groups of faces that stay apart. */
export interface GroupOptions {
  /**
   * The group of each face of the input, such as the number of its material: one for each number that `sourceFaces` of
   * the result may have. Edges are then collapsed along the lines between groups, never across, and each triangle of the
   * result has a source of the group that it is in. The lines stay within the tolerance of where the surface has them
   * that is reduced: a sound mesh's own, or those of the grid, whose triangles are each of one group. Left out: groups do
   * not count.
   */
  keepGroups?: WholeNumbers;
}

/**
 * One level of detail, with how far it is from the input: from the grid's own surface where there is none at hand (a
 * loaded grid, `Grid.extract`, `thicken`), or where `simplifyMesh` without `error` had to make the mesh anew. Measured
 * at all vertices and at some 4,000 points spread evenly over the area of either surface: in between, the largest
 * distance may be a little more. What the grid's surface had lost before is left out; `report.lost` tells of it.
 */
export interface Level extends Mesh {
  error: MeshError;
}

/** What `Grid.extract` gives. */
export interface ExtractedMesh extends Mesh {
  /** How it was made, and what one should know before one trusts it, the gravest first. */
  report: ExtractReport & { warnings: Warning[] };
  /** Only with the option `reduce`: one mesh for each of `targetTriangles`. The result is the last one. */
  levels?: Level[];
  /** Only with the option `reduce`: how it was reduced. */
  reduce?: ReduceReport;
}

/** What `KdManifold.simplifyMesh` gives. */
export interface Simplified {
  /** The last level, if there are several. */
  mesh: Mesh;
  /** One mesh for each of `targetTriangles`. */
  levels: Level[];
  report: ReduceReport & {
    /** The mesh was not closed, not 2-manifold or met itself, and was made anew first. */
    rebuilt: boolean;
    /** What one should know of that, the gravest first. */
    warnings: Warning[];
  };
}

/** What `Grid.compare` finds. */
export interface Account {
  /** What of the input the result does not come near. */
  lost: LostArea;
  /** How far the two are apart; null unless it was asked for. */
  error: MeshError | null;
  /** `AREA_LOST`, if more than a thousandth of the input's area is lost. */
  warnings: Warning[];
}

/** What `Grid.compare` is told. */
export interface CompareOptions {
  /** Measure how far the two are apart; takes longer than all the rest. Default false. */
  error?: boolean;
}

/** The account of one conversion. */
export interface Report {
  input: InputReport;
  /** Of Boolean operations: what each operand is; `input` has the sums. */
  operands?: InputReport[];
  grid: GridStats;
  output: OutputReport;
  /** How the grid was simplified; null: it was not. */
  simplify: SimplifyReport | null;
  /** How the result was reduced; null: it was not. */
  reduce: ReduceReport | null;
  /** What of the input the result does not come near. Not of Boolean operations. */
  lost?: LostArea;
  /** How far result and input are apart; null without the option `check`. Not of Boolean operations. */
  error?: MeshError | null;
  /** What one should know before one trusts the mesh, the gravest first. */
  warnings: Warning[];
  /** Wall-clock time of the steps. */
  seconds: { build: number; simplify: number; extract: number; reduce: number };
  /** Size of the WebAssembly heap, which never shrinks: the most that any call so far needed. */
  peakBytes: number;
  /** Who did it: a worker, or (`main`) the thread that called, which could do nothing else meanwhile. */
  thread: 'worker' | 'main';
  /** How many threads shared the work. */
  threads: number;
}

/** What `simplifyMesh` gives. */
export interface Simplification extends Simplified {
  report: Simplified['report'] &
    Pick<Report, 'peakBytes' | 'thread' | 'threads'> & { seconds: number };
}

/** What `makeManifold` and `boolean` give. */
export interface Conversion {
  /** The result; the last level, if there are several. */
  mesh: Mesh;
  /** One mesh for each of `targetTriangles`. */
  levels: Level[];
  report: Report;
}
