// SPDX-License-Identifier: MIT
// Options: types, legal values. Made by scripts/generate-options.mjs, not by hand.

import type { OptionTable } from './option-spec.js';

/** How a mesh becomes a grid. */
export interface BuildOptions {
  /**
   * How cells are split:
   * - `adaptive` (default): until the surface is met within the tolerance and its topology is
   *   resolved
   * - `octree`: the same, but at midpoints, x, y, z in turn
   * - `feature`: the same, but through or near features of the cell (paper 5.1.2 (2))
   * - `median`: median of triangle centres, until every triangle is hit by a grid edge (paper 5.1.2
   *   (1))
   * - `uniform`: midpoints in turn, to the full depth wherever a cell meets the surface
   */
  strategy?: 'adaptive' | 'octree' | 'feature' | 'median' | 'uniform';
  /**
   * How far the result may be from the input, in model units. Of `adaptive`, `octree` and
   * `feature`. 0, the default: the relative tolerance counts instead.
   */
  tolerance?: number;
  /**
   * The same, relative to the model's size, in diagonals of the bounding box. Default 0.001. 0: all
   * that is not flat is split down to the depth limit.
   */
  relativeTolerance?: number;
  /**
   * Limit of the tree's depth, from 1 to 60. Three levels halve a cell in each axis. Left out: 60,
   * or 18 for uniform, 64 cells an axis.
   */
  depth?: number;
  /**
   * Resolution of `uniform` and `octree`: cells along the longest side, from 1 to 500000. Not
   * together with `depth` and the tolerances. Left out: what the depth and the tolerance say.
   */
  cells?: number;
  /**
   * Which winding numbers are inside:
   * - `repair` (default): `positive` if the surface is closed, once its parts that are inside out
   *   are turned; any other becomes a solid: it is sewn and turned, patches over their corners
   *   close its holes, and small parts that bound nothing are left out; where much bounds nothing,
   *   the generalised winding number tells inside from outside
   * - `positive`: above 0, the union of overlapping and nested shells; closed input only, taken as
   *   its parts are turned
   * - `odd`: odd numbers, so that a part within another is a cavity however it is turned; closed
   *   input only
   * - `nonzero`: all but 0; closed input only
   * - `sheet`: there is no inside: all of the surface is kept, as it is turned, and open surfaces
   *   stay open; the result is a manifold with boundary. Any mesh will do; it comes apart where
   *   neighbours are turned against each other
   */
  inside?: 'repair' | 'positive' | 'odd' | 'nonzero' | 'sheet';
  /**
   * `repair`: winding numbers above this are inside, from 0 to below 1. Above 0 there are no
   * patches, and it holds for closed parts as well. Lower values close wider gaps, and let what
   * bulges over the gaps bulge further. 0, the default: patches close holes; for parts that these
   * do not close, what keeps most of their area, at most 0.5.
   */
  windingThreshold?: number;
  /**
   * `repair`: holes wider than this are refused, in model units. The width of a hole is the
   * diagonal of its bounding box. The error is `NOT_CLOSED`. 0, the default: all are closed.
   */
  largestHole?: number;
  /**
   * How hits are linked where a face of the grid has more than two:
   * - `trace` (default): as the input's surface crosses the face
   * - `hermite`: by the least deviation from the hits' tangents
   * - `inside`: the two hits at the ends of an inside stretch of the outline (paper 2.1)
   * - `outside`: the two hits at the ends of an outside stretch of the outline (paper 2.1)
   */
  pairing?: 'trace' | 'hermite' | 'inside' | 'outside';
  /**
   * Build a shell of this thickness around the surface, which may be open, in model units. The
   * report's `input` is that of the shell, unless only sheets get one. 0, the default: the input
   * itself is built.
   */
  thicken?: number;
  /**
   * `thicken`: what gets a thickness:
   * - `all` (default): all of it, whatever it bounds
   * - `sheets`: parts that bound nothing, also fins and ribs on solids, which stay as they are; of
   *   `repair`
   */
  thickenWhat?: 'all' | 'sheets';
  /**
   * Leave out what of the solid is thinner than this, in model units. Up to 0.6 times as much stays
   * where it ends in something thicker, and edges of less than 54 degrees become blunt. Measured as
   * exactly as the tolerance. 0, the default: nothing.
   */
  minimumThickness?: number;
  /**
   * Fill gaps, holes and cavities that are narrower than this, in model units. In the same way,
   * after `minimumThickness`. 0, the default: none.
   */
  minimumGap?: number;
  /**
   * The box over which the grid is laid, its lowest and its highest corner, in model units. It must
   * hold the model. Grids over the same box can be merged. One that is much larger than the model
   * costs precision: positions are decided in steps of a millionth of its longest side. Left out:
   * the model's own bounding box.
   */
  box?: readonly number[];
}

/** How a grid becomes a mesh. */
export interface ExtractOptions {
  /**
   * Split vertices that lie further than this from a plane they stand for, in model units. A cell
   * can then hold several features (paper 2.3.1). More than the model's size: never. 0 splits where
   * vertices are further off than the grid's tolerance and 0.3 times the way to the furthest of
   * their hits, but never with `quads`. 0, the default: where a cell has two features.
   */
  splitError?: number;
  /**
   * Where vertices go whose best place lies outside of their cell. The best place is where the sum
   * of squared distances to the planes of the hits is least (paper 2.2.1):
   * - `constrained` (default): to the best place within the cell
   * - `projection`: to the point of the cell that is nearest to the best place
   */
  position?: 'constrained' | 'projection';
  /**
   * Make quads where four cells meet. The two triangles of such an edge are joined: everywhere on a
   * uniform grid. Quads need not be planar. Default false.
   */
  quads?: boolean;
  /**
   * Flip edges of triangles that are folded over or thin. Folded over their neighbours, where that
   * lays them flat; thin with an angle below two degrees, where that makes their smallest angle
   * twice as wide. Takes away most self-intersections and most thin triangles. Not with `quads`.
   * Default true.
   */
  unfold?: boolean;
  /**
   * Put vertices where edges pass between cells further than this from the surface, in model units.
   * More than the model's size: never. Not with `quads`. 0, the default: the grid's tolerance.
   */
  linkError?: number;
  /**
   * Which parts of the result are kept. Sheets keep all:
   * - `all` (default): all but crumbs, slivers thinner than the tolerance beside holes that were
   *   closed
   * - `outer`: only those that lie in no other: no cavities, and nothing within cavities
   * - `largest`: only the one that encloses most, without its cavities
   */
  parts?: 'all' | 'outer' | 'largest';
  /**
   * Leave out parts of the result smaller than this, in model units. The size is the diagonal of
   * the bounding box. What lies in them goes too; parts within cavities count. Not for sheets. 0,
   * the default: none.
   */
  dropParts?: number;
  /**
   * Fill cavities of the result smaller than this, in model units. The size is the diagonal of the
   * bounding box. What lies in them becomes solid too. Not for sheets. 0, the default: none.
   */
  dropCavities?: number;
  /**
   * Close tunnels and cut bridges of the result smaller than this, in model units. The size is the
   * length of the shortest closed path round a bridge or along the wall of a tunnel: of a round
   * hole its circumference. It is closed or cut at its narrowest place. Not for sheets, nor with
   * `quads`, nor with `strict` off. 0, the default: none.
   */
  dropHandles?: number;
  /**
   * What the result must be as an index mesh:
   * - `off`: the raw dual surface, whose half-edges are manifold but not its vertex numbers
   * - `manifold`: 2-manifold: vertices are added where two parts of the surface would share an
   *   edge, parts without volume are dropped
   * - `embedded` (default): the same, and no two triangles cross or touch but where they share
   *   vertices, none is without area; holds for the 32-bit coordinates, so vertices may be told by
   *   their positions alone, as in STL files. With `quads` as `manifold`
   */
  strict?: 'off' | 'manifold' | 'embedded';
  /**
   * Give the corners of faces normals for shading (of the files, OBJ and GLB have them). Unit
   * normals, from the input's normals at the hits. Vertices on a crease are not doubled. Default
   * false.
   */
  normals?: boolean;
  /**
   * `normals`: they differ where faces turn by more than this, in degrees from 0 to 180. At 0 they
   * differ at all edges but in flat parts, at 180 nowhere. Default 30.
   */
  creaseAngle?: number;
}

/** How a mesh gets fewer triangles. */
export interface ReductionOptions {
  /**
   * Collapse edges as long as the result stays within the tolerance. The grid is then built at 0.8
   * times the tolerance, and the result is embedded whatever `strict` says. Left out where `quads`,
   * `strict` off, a `strategy` without tolerance or a tolerance of 0 excludes it; asked for beside
   * one of these, it is refused. Default true.
   */
  reduce?: boolean;
  /**
   * How many triangles are to be left; several numbers, each smaller than the one before, make
   * several levels: for -o name.obj the files name.1.obj, name.2.obj and so on. The tolerance
   * counts too, so that there may be more. Left out: as few as the distance allows.
   */
  targetTriangles?: number | readonly number[];
  /**
   * Remove splits of the grid as long as its surface stays this near to what it was (paper section
   * 4), which makes saved grids smaller, in model units. The distance comes on top of the
   * tolerance. For few triangles alone, `reduce` does far more. 0, the default: none.
   */
  simplify?: number;
  /**
   * With `simplify`: bodies go from the grid into which no ball fits that is wider than this, each
   * with the cavities in it, in model units. Nothing is cut off a body that stays;
   * `minimumThickness` does so. 0, the default: none.
   */
  removeMaterial?: number;
  /**
   * With `simplify`: cavities are filled into which no ball fits that is wider than this, once thin
   * bodies have gone, in model units. Tunnels, and gaps that lead outside, stay open; `minimumGap`
   * closes them. 0, the default: none.
   */
  addMaterial?: number;
}

/** How far a mesh is reduced. */
export interface ReduceOptions {
  /**
   * How far result and mesh may be apart, in model units. 0, the default: without limit,
   * `targetTriangles` decides.
   */
  error?: number;
  /**
   * How many triangles are to be left; several numbers, each smaller than the one before, make
   * several levels. The error counts too, so that there may be more. Left out: as few as the
   * distance allows.
   */
  targetTriangles?: number | readonly number[];
}

/** How far a grid is simplified. */
export interface SimplifyOptions {
  /**
   * How far the surface may be, either way, from what it was when the grid was built, in model
   * units. What calls before have used up counts. Default 0.
   */
  surfaceError?: number;
  /**
   * The paper's on-metric as a further limit: the root mean square distance of merged hits from the
   * plane that fits them best, in model units. 0, the default: no limit.
   */
  planeError?: number;
  /**
   * Bodies go into which no ball fits that is wider than this, each with the cavities in it, in
   * model units. Nothing is cut off a body that stays. 0, the default: none.
   */
  removedMaterial?: number;
  /**
   * Cavities are filled into which no ball fits that is wider than this, once thin bodies have
   * gone, in model units. Tunnels, and gaps that lead outside, stay open. 0, the default: none.
   */
  addedMaterial?: number;
}

/** What `KdManifold.analyze` looks for. */
export interface AnalyzeOptions {
  /**
   * Look for self-intersections too. Takes several times as long as all the rest, and far longer
   * where many faces overlap that are no copies of each other. Default false.
   */
  selfIntersections?: boolean;
}

/** @internal */
export const buildOptions: OptionTable<BuildOptions> = {
  strategy: {
    flag: '--strategy',
    kind: 'choice',
    words: ['adaptive', 'octree', 'feature', 'median', 'uniform'],
    default: 'adaptive',
  },
  tolerance: { flag: '--tolerance', kind: 'number', least: 0, default: 0 },
  relativeTolerance: { flag: '--relative-tolerance', kind: 'number', least: 0, default: 0.001 },
  depth: { flag: '--depth', kind: 'integer', least: 1, most: 60 },
  cells: { flag: '--cells', kind: 'integer', least: 1, most: 500000 },
  inside: {
    flag: '--inside',
    kind: 'choice',
    words: ['repair', 'positive', 'odd', 'nonzero', 'sheet'],
    default: 'repair',
  },
  windingThreshold: { flag: '--winding-threshold', kind: 'number', least: 0, below: 1, default: 0 },
  largestHole: { flag: '--largest-hole', kind: 'number', least: 0, default: 0 },
  pairing: {
    flag: '--pairing',
    kind: 'choice',
    words: ['trace', 'hermite', 'inside', 'outside'],
    default: 'trace',
  },
  thicken: { flag: '--thicken', kind: 'number', least: 0, default: 0 },
  thickenWhat: { flag: '--thicken-what', kind: 'choice', words: ['all', 'sheets'], default: 'all' },
  minimumThickness: { flag: '--minimum-thickness', kind: 'number', least: 0, default: 0 },
  minimumGap: { flag: '--minimum-gap', kind: 'number', least: 0, default: 0 },
  box: { flag: '--box', kind: 'box' },
};

/** @internal */
export const extractOptions: OptionTable<ExtractOptions> = {
  splitError: { flag: '--split-error', kind: 'number', least: 0, default: 0 },
  position: {
    flag: '--position',
    kind: 'choice',
    words: ['constrained', 'projection'],
    default: 'constrained',
  },
  quads: { flag: '--quads', kind: 'boolean', default: false },
  unfold: { flag: '--no-unfold', kind: 'boolean', default: true },
  linkError: { flag: '--link-error', kind: 'number', least: 0, default: 0 },
  parts: { flag: '--parts', kind: 'choice', words: ['all', 'outer', 'largest'], default: 'all' },
  dropParts: { flag: '--drop-parts', kind: 'number', least: 0, default: 0 },
  dropCavities: { flag: '--drop-cavities', kind: 'number', least: 0, default: 0 },
  dropHandles: { flag: '--drop-handles', kind: 'number', least: 0, default: 0 },
  strict: {
    flag: '--strict',
    kind: 'choice',
    words: ['off', 'manifold', 'embedded'],
    default: 'embedded',
  },
  normals: { flag: '--normals', kind: 'boolean', default: false },
  creaseAngle: { flag: '--crease-angle', kind: 'number', least: 0, most: 180, default: 30 },
};

/** @internal */
export const reductionOptions: OptionTable<ReductionOptions> = {
  reduce: { flag: '--no-reduce', kind: 'boolean', default: true },
  targetTriangles: { flag: '--target-triangles', kind: 'numbers', least: 1 },
  simplify: { flag: '--simplify', kind: 'number', least: 0, default: 0 },
  removeMaterial: { flag: '--remove-material', kind: 'number', least: 0, default: 0 },
  addMaterial: { flag: '--add-material', kind: 'number', least: 0, default: 0 },
};

/** @internal */
export const reduceOptions: OptionTable<ReduceOptions> = {
  error: { flag: '--error', kind: 'number', least: 0, default: 0 },
  targetTriangles: { flag: '--target-triangles', kind: 'numbers', least: 1 },
};

/** @internal */
export const simplifyOptions: OptionTable<SimplifyOptions> = {
  surfaceError: { flag: '--surface-error', kind: 'number', least: 0, default: 0 },
  planeError: { flag: '--plane-error', kind: 'number', least: 0, default: 0 },
  removedMaterial: { flag: '--removed-material', kind: 'number', least: 0, default: 0 },
  addedMaterial: { flag: '--added-material', kind: 'number', least: 0, default: 0 },
};

/** @internal */
export const analyzeOptions: OptionTable<AnalyzeOptions> = {
  selfIntersections: { flag: '--self-intersections', kind: 'boolean', default: false },
};
