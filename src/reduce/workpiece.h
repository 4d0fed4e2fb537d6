// SPDX-License-Identifier: MIT
// The mesh while it is reduced, with what its steps are held against.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "reduce/crossing_guard.h"
#include "reduce/half_edges.h"
#include "reduce/reference.h"
#include "reduce/samples.h"
#include "reduce/shape.h"
#include "reduce/space_blocks.h"
#include "reduce/true_creases.h"

namespace kdm {

/// Parts of the mesh that are further from the reference than this many times the error are taken
/// for surface that the reference lacks. What is extracted within the error is nearer.
inline constexpr double kForeign = 2;

/// The distance that is kept between the mesh and a reference, both ways.
struct KeptDistance {
  const Reference* reference;    ///< must outlive this
  Samples samples;               ///< points of the reference and of the mesh
  double error;                  ///< the largest distance anywhere
  std::vector<double> limits;    ///< per vertex: the largest distance round it (see local_limits.h)
  std::vector<TriangleId> near;  ///< per vertex: the reference's triangle that was found near it
  std::shared_ptr<const TrueCreases> creases;  ///< of the reference
};

/// What steps may change of a workpiece that is a part of another one: what is wholly in a box.
struct StepsWithin {
  Box box;      ///< of a block of space (see space_blocks.h)
  Marks fixed;  ///< per vertex: lies beyond, so nothing at it may change
};

/// The mesh. Coordinates are of about 1.
struct Workpiece {
  /// Without `watched`, no step may let triangles meet; with it only steps that change triangles
  /// at marked vertices are looked at, and, if a distance is kept, those that leave or undo a fold.
  Workpiece(HalfEdges half_edges, std::vector<Vec3> points, std::optional<KeptDistance> kept,
            std::optional<Marks> watched = {})
      : mesh(std::move(half_edges)),
        positions(std::move(points)),
        joined_to(positions.size(), kNone),
        distance(std::move(kept)),
        guarded(std::move(watched)) {
    if (!guarded || guarded->any() || distance) guard.emplace(mesh, positions);
    faces.reserve(mesh.triangles());
    for (TriangleId t = 0; t < mesh.triangles(); ++t) faces.push_back(shape_of_face(t));
  }
  Workpiece(const Workpiece&) = delete;  // the guard refers to the mesh
  Workpiece& operator=(const Workpiece&) = delete;

  /// Tells whether the edge lies between triangles of two groups.
  bool is_border(SideId h) const {
    const SideId back = mesh.opposite(h);
    return !groups.empty() && back != kNone && groups[triangle_of(h)] != groups[triangle_of(back)];
  }

  /// Tells whether the edge lies on a rim or between triangles of two groups.
  bool is_line(SideId h) const { return mesh.opposite(h) == kNone || is_border(h); }

  /// Tells whether no step may change anything at the vertex.
  bool is_fixed(VertexId v) const { return within && within->fixed.test(v); }
  /// Tells whether no step may change the edge.
  bool is_edge_fixed(SideId h) const { return is_fixed(mesh.start(h)) || is_fixed(mesh.end(h)); }
  /// Tells whether no step may move the vertex: it or one that an edge joins it with is fixed.
  bool is_held(VertexId v) const {
    if (!within) return false;
    bool found = is_fixed(v);
    mesh.for_each_neighbour(v, [&](VertexId w) { found = found || is_fixed(w); });
    return found;
  }
  /// Tells whether a step may put a vertex to the point.
  bool may_hold(const Vec3& p) const { return !within || holds(within->box, p); }

  /// Makes known that a triangle's corners are others now, or elsewhere, or that it is gone.
  void changed(TriangleId t) {
    if (!mesh.is_removed(t)) faces[t] = shape_of_face(t);
    if (guard) guard->changed(t);
  }

  HalfEdges mesh;
  std::vector<Vec3> positions;           // per vertex
  std::vector<FaceShape> faces;          // per triangle that is there
  std::vector<VertexId> joined_to;       // per vertex that is gone: the one it was joined to
  std::optional<KeptDistance> distance;  // none: the number of triangles alone decides
  std::optional<CrossingGuard> guard;    // none: nothing is guarded
  std::optional<Marks> guarded;          // per vertex; none: all are guarded
  std::vector<Index> groups;             // per triangle; empty: there are none to keep
  std::optional<StepsWithin> within;     // none: everything may change

 private:
  FaceShape shape_of_face(TriangleId t) const {
    const Triangle c = mesh.corners(t);
    return face_shape(positions[c[0]], positions[c[1]], positions[c[2]]);
  }
};

}  // namespace kdm
