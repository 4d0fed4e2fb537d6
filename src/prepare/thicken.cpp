// SPDX-License-Identifier: MIT
// Makes a shell from pieces: triangles that are joined across sides with an opposite. Every corner
// of a triangle belongs to a fan, which are the triangles round the corner's vertex up to where the
// piece ends. Each fan gives two vertices of the shell, one on either side of the surface; so the
// shell is closed, whatever vertices the fans share.
//
// The shell is the sum of prisms, one a triangle. Where a prism would turn over, its triangle
// becomes a piece of its own. So all prisms count positively, and their union is the set of the
// points whose winding number is positive.
#include "kdmanifold/thicken.h"

#include <cmath>
#include <new>
#include <utility>

#include "geometry/angle.h"
#include "geometry/triangle.h"
#include "kdmanifold/error.h"
#include "mesh/check_indices.h"
#include "mesh/check_positions.h"
#include "mesh/edge_sides.h"
#include "mesh/marks.h"
#include "mesh/polygons.h"
#include "mesh/scale.h"
#include "mesh/topology.h"
#include "prepare/edit_faces.h"
#include "prepare/neighbours.h"
#include "prepare/non_manifold_edges.h"
#include "prepare/thicken_faces.h"
#include "prepare/weld.h"
#include "text/compose.h"

namespace kdm {
namespace {

// Limits how far a vertex goes at sharp edges: as a multiple of half the thickness.
constexpr double kMostMitre = 2;
// A piece ends at an edge if the normals of its two triangles have a lesser cosine.
constexpr double kCutCosine = -0.1;
// A fan that goes on for at least this angle, in radians, is the end of a slit and not of a piece.
constexpr double kLeastSlitAngle = 4.7;
// Pieces that end elsewhere than at a rim of the surface reach this part of the thickness further,
// so that their shells overlap.
constexpr double kOverlap = 1.0 / 4;

struct Faces {
  std::vector<Triangle> triangles;
  std::vector<Index> source;  // per triangle: the input's number of its face
};

// Cuts quads in two, and leaves out triangles with a repeated point.
Faces welded_faces(const Mesh& mesh, const Weld& weld) {
  Faces faces;
  Polygons(mesh).for_each_triangle([&](Index face, const Triangle& c) {
    const Triangle t = {weld.point_of[c[0]], weld.point_of[c[1]], weld.point_of[c[2]]};
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;
    faces.triangles.push_back(t);
    faces.source.push_back(mesh.source_faces.empty() ? face : mesh.source_faces[face]);
  });
  return faces;
}

// Leaves out copies, and turns neighbours to agree.
Faces oriented_faces(const Faces& all, const std::vector<Vec3>& points) {
  const NeighbourDirections directions = orient_neighbours(
      all.triangles, points, build_topology(all.triangles, static_cast<Index>(points.size())));
  Faces faces;
  for (std::size_t t = 0; t < all.triangles.size(); ++t) {
    if (directions.copy_of[t] != kNone) continue;
    const Triangle& c = all.triangles[t];
    faces.triangles.push_back(directions.must_turn.test(t) ? Triangle{c[0], c[2], c[1]} : c);
    faces.source.push_back(all.source[t]);
  }
  return faces;
}

// The two vertices of a fan: `middle + out` on the front of the surface, `middle - out` on the
// back.
struct Offset {
  Vec3 middle;
  Vec3 out;
};

class Thickener {
 public:
  // `points` and `thickness` must be scaled so that coordinates are about 1. `opposite` says which
  // sides are joined.
  Thickener(const std::vector<Triangle>& triangles, const std::vector<Vec3>& points,
            std::vector<SideId> opposite, double thickness)
      : triangles_(triangles),
        points_(points),
        thickness_(thickness),
        opposite_(std::move(opposite)),
        rim_(3 * triangles.size()) {
    for (const Triangle& t : triangles_) {
      normals_.push_back(unit_normal(points_[t[0]], points_[t[1]], points_[t[2]]));
    }
    find_ends();
  }

  bool has_area() const {
    for (const Vec3& n : normals_) {
      if (n != Vec3::Zero()) return true;
    }
    return false;
  }

  void run() {
    do {
      make_fans();
    } while (cut_off_turned() > 0);
  }

  // Makes the shell, which is closed and consistently oriented by construction: the sides of the
  // triangles within a piece pair off on either side of the surface; where a piece ends, a wall of
  // two triangles pairs with the sides above and below it and, at its ends, with the next walls.
  // Only the wanted triangles get a shell; they must be joined to no others.
  Mesh shell(const std::vector<Index>& source, const Marks& wanted) const {
    Mesh mesh;
    std::vector<Index> number(offsets_.size(), kNone);  // of a fan's first vertex
    for (SideId corner = 0; corner < fan_.size(); ++corner) {
      Index& first = number[fan_[corner]];
      if (first != kNone || !wanted.test(triangle_of(corner))) continue;
      const Offset& o = offsets_[fan_[corner]];
      first = static_cast<Index>(mesh.positions.size());
      mesh.positions.push_back(o.middle + o.out);
      mesh.positions.push_back(o.middle - o.out);
    }
    const auto upper = [&](SideId corner) { return number[fan_[corner]]; };
    const auto lower = [&](SideId corner) { return number[fan_[corner]] + 1; };
    const auto add = [&](TriangleId triangle, Index a, Index b, Index c) {
      mesh.triangles.push_back({a, b, c});
      mesh.source_faces.push_back(source[triangle]);
    };
    for (TriangleId t = 0; t < triangles_.size(); ++t) {
      if (!wanted.test(t)) continue;
      add(t, upper(3 * t), upper(3 * t + 1), upper(3 * t + 2));
      add(t, lower(3 * t + 2), lower(3 * t + 1), lower(3 * t));
      for (SideId side = 3 * t; side < 3 * t + 3; ++side) {
        if (opposite_[side] != kNone) continue;
        const SideId end = next_side(side);
        add(t, upper(end), upper(side), lower(side));
        add(t, upper(end), lower(side), lower(end));
      }
    }
    return mesh;
  }

 private:
  // Where a side starts. Sides stand for the corners that they start from.
  const Vec3& point(SideId corner) const {
    return points_[triangles_[triangle_of(corner)][corner_of(corner)]];
  }

  // Finds the rim of the surface, and where pieces end within it.
  void find_ends() {
    EdgeSides(triangles_, static_cast<Index>(points_.size()))
        .for_each_edge([&](Index, std::span<const EdgeSide> edge) {
          if (edge.size() == 1) rim_.set(edge[0].side);
        });
    for (SideId side = 0; side < opposite_.size(); ++side) {
      if (opposite_[side] != kNone && cosine_across(side) < kCutCosine) cut(side);
    }
  }

  double cosine_across(SideId side) const {
    return normals_[triangle_of(side)].dot(normals_[triangle_of(opposite_[side])]);
  }

  // Ends the piece at a side.
  void cut(SideId side) {
    opposite_[opposite_[side]] = kNone;
    opposite_[side] = kNone;
  }

  void make_fans() {
    fan_.assign(opposite_.size(), kNone);
    offsets_.clear();
    for (SideId corner = 0; corner < opposite_.size(); ++corner) {
      if (fan_[corner] != kNone) continue;
      // Go back to where the fan begins, unless it goes all the way round.
      SideId first = corner;
      while (opposite_[first] != kNone && next_side(opposite_[first]) != corner)
        first = next_side(opposite_[first]);
      if (opposite_[first] != kNone) first = corner;
      make_offset(first);
    }
  }

  // Returns the unit vector that leads out of a side's triangle, in its plane, if a piece ends
  // there; zero within a piece and at the rim of the surface.
  Vec3 beyond(SideId side) const {
    if (opposite_[side] != kNone || rim_.test(side)) return Vec3::Zero();
    const Vec3 along = point(next_side(side)) - point(side);
    return normalized_or_zero(along.cross(normals_[triangle_of(side)]));
  }

  // Adds the two vertices of the fan that begins with corner `first`: they lie away from the
  // surface along the mean of the fan's normals, weighted by the angles at the corner.
  void make_offset(SideId first) {
    const auto number = static_cast<Index>(offsets_.size());
    Vec3 sum = Vec3::Zero();
    double angles = 0;
    SideId corner = first;
    SideId last = first;
    do {
      fan_[corner] = number;
      const double angle = angle_between(point(next_side(corner)) - point(corner),
                                         point(previous_side(corner)) - point(corner));
      const Vec3& normal = normals_[triangle_of(corner)];
      if (normal != Vec3::Zero()) {  // a triangle without area has none
        sum += angle * normal;
        angles += angle;
      }
      last = corner;
      corner = opposite_[previous_side(corner)];
    } while (corner != kNone && corner != first);
    Offset offset{point(first), Vec3::Zero()};
    // The mean cosine between the normals and their mean is length / angles. Its inverse keeps the
    // vertices half the thickness away from the triangles.
    const double length = sum.norm();
    if (length > 0) {
      offset.out = sum / length * (thickness_ / 2) * std::min(angles / length, kMostMitre);
    }
    if (corner == kNone && angles < kLeastSlitAngle) {  // the end of a slit stays where it is
      const Vec3 out = mitred(beyond(first), beyond(previous_side(last)));
      offset.middle += kOverlap * thickness_ * out;
    }
    offsets_.push_back(offset);
  }

  // Returns the vector that leads one unit beyond two sides of a piece's outline, given the unit
  // vectors that lead out of each. If one of them is zero, it is the other one.
  static Vec3 mitred(const Vec3& a, const Vec3& b) {
    const Vec3 sum = a + b;
    const double square = sum.squaredNorm();
    if (a == Vec3::Zero() || b == Vec3::Zero() || !(square > 0)) return sum;
    return sum / std::sqrt(square) * std::min(2 / std::sqrt(square), kMostMitre);
  }

  // Tells whether a triangle's prism turns over somewhere. Between its faces on the back (s = -1)
  // and the front (s = 1) of the surface, the prism's cross-section has the area, doubled and seen
  // along the triangle's normal, of a + b s + c s^2, which must be positive everywhere.
  bool turns_over(TriangleId t) const {
    const Offset& p = offsets_[fan_[3 * t]];
    const Offset& q = offsets_[fan_[3 * t + 1]];
    const Offset& r = offsets_[fan_[3 * t + 2]];
    const Vec3& n = normals_[t];
    if (n == Vec3::Zero()) return false;
    const Vec3 u = q.middle - p.middle;
    const Vec3 v = r.middle - p.middle;
    const Vec3 du = q.out - p.out;
    const Vec3 dv = r.out - p.out;
    const double a = u.cross(v).dot(n);
    const double b = (u.cross(dv) + du.cross(v)).dot(n);
    const double c = du.cross(dv).dot(n);
    if (!(a - std::abs(b) + c > 0)) return true;
    return c > 0 && std::abs(b) < 2 * c && !(4 * a * c > b * b);
  }

  // Makes pieces of their own of triangles whose prisms turn over, and returns how many sides were
  // cut. The prism of a piece of one triangle has parallel edges and does not turn over.
  Index cut_off_turned() {
    Index cuts = 0;
    for (TriangleId t = 0; t < triangles_.size(); ++t) {
      if (!turns_over(t)) continue;
      for (SideId side = 3 * t; side < 3 * t + 3; ++side) {
        if (opposite_[side] == kNone) continue;
        cut(side);
        ++cuts;
      }
    }
    return cuts;
  }

  const std::vector<Triangle>& triangles_;
  const std::vector<Vec3>& points_;
  double thickness_;
  std::vector<SideId> opposite_;  // per side; kNone where a piece ends
  std::vector<Vec3> normals_;     // per triangle; zero if it has no area
  Marks rim_;                     // sides at which the surface itself ends
  std::vector<Index> fan_;        // per corner
  std::vector<Offset> offsets_;   // per fan
};

}  // namespace

Mesh thicken(const Mesh& mesh, double thickness) try {
  if (!(thickness > 0 && std::isfinite(thickness))) {
    throw Error(ErrorCode::kInvalidOption,
                compose("thickness is {}; it must be a finite number above 0", thickness));
  }
  check_positions(mesh);
  check_indices(mesh);
  const std::size_t faces = mesh.triangles.size() + mesh.quads.size();
  if (!mesh.source_faces.empty() && mesh.source_faces.size() != faces) {
    throw Error(ErrorCode::kInvalidMesh, compose("source_faces has {} entries for {} faces",
                                                 mesh.source_faces.size(), faces));
  }
  const Weld weld = weld_positions(mesh.positions);
  std::vector<Vec3> points;
  points.reserve(weld.first_of.size());
  for (const Index first : weld.first_of) points.push_back(mesh.positions[first]);
  const Faces all = welded_faces(mesh, weld);
  const auto [places, exponent] = scale_to_one(points, all.triangles);
  const Faces surface = oriented_faces(all, places);
  Topology topology = build_topology(surface.triangles, static_cast<Index>(places.size()));
  pair_straightest(surface.triangles, places, topology);
  Thickener thickener(surface.triangles, places, std::move(topology.opposite),
                      std::ldexp(thickness, -exponent));
  if (!thickener.has_area()) {
    throw Error(ErrorCode::kInvalidMesh, "no face of the mesh has an area");
  }
  thickener.run();
  Marks all_of_it;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) all_of_it.push_back(true);
  Mesh shell = thickener.shell(surface.source, all_of_it);
  shell.positions = scaled(shell.positions, exponent);
  return shell;
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, "there is not enough memory to thicken the surface");
}

void thicken_faces(InputFaces& faces, const Marks& wanted, double thickness) {
  const auto [places, exponent] = scale_to_one(faces.points, faces.triangles);
  Thickener thickener(faces.triangles, places, faces.topology.opposite,
                      std::ldexp(thickness, -exponent));
  thickener.run();
  const Mesh shell = thickener.shell(faces.source_faces, wanted);
  drop_faces(faces, wanted);
  const auto first = static_cast<Index>(faces.points.size());
  for (const Vec3& p : scaled(shell.positions, exponent)) faces.points.push_back(p);
  for (const Triangle& t : shell.triangles) {
    faces.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  faces.source_faces.insert(faces.source_faces.end(), shell.source_faces.begin(),
                            shell.source_faces.end());
}

}  // namespace kdm
