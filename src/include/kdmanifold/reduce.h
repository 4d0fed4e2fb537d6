// SPDX-License-Identifier: MIT
// Reduces a mesh to fewer triangles: within a distance of the surface that it stands for, to a
// number of triangles, or to several numbers one after the other.
#pragma once

#include <vector>

#include "kdmanifold/deviation.h"
#include "kdmanifold/mesh.h"
#include "kdmanifold/progress.h"

namespace kdm {

/// What `reduce` can be told. One of the two must be given.
struct ReduceOptions {
  /// The largest distance between the result and the reference, either way, in model units. 0: no
  /// limit, `target_triangles` decides.
  double error = 0;
  /// How many triangles are to be left; several numbers, each smaller than the one before, make
  /// several levels of detail. Empty: as few as `error` allows.
  std::vector<Index> target_triangles = {};
  /// Groups that are to stay apart, such as those of materials: the group of each face of the
  /// reference, by the numbers that `source_faces` of the mesh has; without these, of each face of
  /// the mesh. Lines between triangles of different groups, of which those without a source are
  /// one, are then reduced along themselves alone: with `error` they stay within it of what they
  /// were, both ways. The sources of the result are of the groups that its triangles are in. Empty:
  /// groups do not count.
  std::vector<Index> keep_groups = {};
};

/// What was done.
struct ReduceReport {
  Index triangles_before = 0;  ///< of the mesh that was given, quads counting as two
  Index triangles = 0;         ///< that are left, of the last level
  Index collapses = 0;         ///< edges that were collapsed
  Index flips = 0;  ///< edges that were flipped, at creases that the reference does not have
};

/// One level of detail, with how far it and the reference are apart. This is measured as `compare`
/// does, at all vertices and at some 4,000 points spread evenly over the area of either surface: in
/// between, the largest distance may be a little more. With `error`, parts of the reference that
/// are further than twice that from the mesh that was given count as lost, not as far away.
struct ReducedLevel : Mesh {
  MeshError error;  ///< `to_input`: of the level from the reference; `to_output`: of this from it
};

/// A reduced mesh. If several numbers of triangles were asked for it is the last level.
struct ReducedMesh : Mesh {
  ReduceReport report;
  /// One mesh for each of `target_triangles`, as far as `error` and the topology, which stays as it
  /// is, allow. Empty if there is none.
  std::vector<ReducedLevel> levels;
};

/// Collapses edges, the cheapest first: where the sum of squared distances to the planes of the
/// triangles that a vertex stands for, times their areas, stays least (M. Garland, P. Heckbert,
/// 1997); without `error` that sum is divided by the root of the area. Every step is taken only if
/// the mesh stays 2-manifold with the same parts and Euler characteristic, no triangle meets
/// another one where they share neither vertex nor edge, none is turned over, and, with `error`,
/// new triangles are near to the reference and the reference is near to them. The latter is tested
/// at points: vertices, middles of edges and of triangles.
///
/// `mesh` must be 2-manifold; a sheet may have a boundary, of which edges are collapsed along it
/// alone, so that it keeps its loops. What meets itself already may
/// go on doing so. `reference` is what the distance counts from, e.g. the input that `mesh` was
/// made from; parts of `mesh` that are further than `error` from it, such as closed holes, count as
/// part of it. `source_faces` are those of the reference's triangles that are nearest to the
/// result's (kNone stays). Quads are cut along their first diagonal. New vertices have 32-bit
/// coordinates.
///
/// Throws `kInvalidMesh` if a mesh is unusable or `mesh` is not 2-manifold, `kInvalidOption`,
/// `kAborted` and `kOutOfMemory`.
ReducedMesh reduce(const Mesh& mesh, const Mesh& reference, const ReduceOptions& options,
                   const Progress& progress = {});

}  // namespace kdm
