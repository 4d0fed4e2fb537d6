// SPDX-License-Identifier: MIT
// Every corner belongs to a fan: the triangles round its vertex up to where the piece ends. Each
// fan gives two vertices; so the shell is closed whatever the fans share. The shell is the sum of a
// prism a triangle: where one would turn over, its triangle becomes a piece of its own, so that all
// count positively and their union is what has a positive winding number.
#include "kdmanifold/thicken.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <new>

#include "geometry/angle.h"
#include "kdmanifold/error.h"
#include "mesh/check_indices.h"
#include "mesh/check_positions.h"
#include "mesh/polygons.h"
#include "mesh/scale.h"
#include "mesh/topology.h"
#include "prepare/crowded_edges.h"
#include "prepare/neighbours.h"
#include "prepare/weld.h"

namespace kdm {
namespace {

constexpr double kMitre = 2;          // how much further than half the thickness vertices may go
constexpr double kFoldCosine = -0.1;  // of the angle between normals beyond which a piece ends
constexpr double kSlit = 4.7;         // radians: fans that go on further are ends of slits
constexpr double kOverlap = 1.0 / 4;  // of the thickness, at ends of pieces that are no rims

struct Faces {
  std::vector<Triangle> triangles;
  std::vector<Index> source;
};

// Quads cut in two; without faces that have a repeated corner.
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

// Without copies, neighbours turned to agree.
Faces oriented_faces(const Faces& all, const std::vector<Vec3>& points) {
  const NeighbourDirections directions = orient_neighbours(all.triangles, points);
  Faces faces;
  for (std::size_t t = 0; t < all.triangles.size(); ++t) {
    if (directions.copy_of[t] != kNone) continue;
    const Triangle& c = all.triangles[t];
    faces.triangles.push_back(directions.flip[t] != 0 ? Triangle{c[0], c[2], c[1]} : c);
    faces.source.push_back(all.source[t]);
  }
  return faces;
}

// What becomes of a vertex of one fan: `middle` + `out` on one side, `middle` - `out` on the other.
struct Offset {
  Vec3 middle;
  Vec3 out;
};

class Thickener {
 public:
  /// `points` and `thickness` scaled to one.
  Thickener(const std::vector<Triangle>& triangles, const std::vector<Vec3>& points,
            double thickness)
      : triangles_(triangles),
        points_(points),
        thickness_(thickness),
        rim_(3 * triangles.size(), 0) {
    for (const Triangle& t : triangles_) {
      const Vec3 cross = (points_[t[1]] - points_[t[0]]).cross(points_[t[2]] - points_[t[0]]);
      const double length = cross.norm();
      normals_.push_back(length > 0 ? Vec3(cross / length) : Vec3(Vec3::Zero()));
    }
    join_sides();
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

  /// Closed and consistently oriented by construction: sides of pieces pair off on either side of
  /// the surface, and walls pair with them and, at the two ends of each fan, with each other.
  Mesh shell(const std::vector<Index>& source) const {
    Mesh mesh;
    for (const Offset& o : offsets_) {
      mesh.positions.push_back(o.middle + o.out);
      mesh.positions.push_back(o.middle - o.out);
    }
    const auto upper = [&](Index corner) { return 2 * fan_[corner]; };
    const auto lower = [&](Index corner) { return 2 * fan_[corner] + 1; };
    const auto add = [&](Index triangle, Index a, Index b, Index c) {
      mesh.triangles.push_back({a, b, c});
      mesh.source_faces.push_back(source[triangle]);
    };
    for (Index t = 0; t < triangles_.size(); ++t) {
      add(t, upper(3 * t), upper(3 * t + 1), upper(3 * t + 2));
      add(t, lower(3 * t + 2), lower(3 * t + 1), lower(3 * t));
      for (Index side = 3 * t; side < 3 * t + 3; ++side) {
        if (twin_[side] != kNone) continue;
        const Index end = next(side);
        add(t, upper(end), upper(side), lower(side));
        add(t, upper(end), lower(side), lower(end));
      }
    }
    return mesh;
  }

 private:
  static Index next(Index side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static Index previous(Index side) { return side % 3 == 0 ? side + 2 : side - 1; }
  const Vec3& point(Index corner) const { return points_[triangles_[corner / 3][corner % 3]]; }

  void join_sides() {
    Topology topology = build_topology(triangles_, static_cast<Index>(points_.size()));
    pair_straightest(triangles_, points_, topology);
    twin_ = std::move(topology.twin);
    EdgeSides(triangles_, static_cast<Index>(points_.size()))
        .for_each_edge([&](Index, std::span<const EdgeSide> edge) {
          if (edge.size() == 1) rim_[edge[0].side] = 1;
        });
    for (Index side = 0; side < twin_.size(); ++side) {
      if (twin_[side] != kNone && cosine_across(side) < kFoldCosine) cut(side);
    }
  }

  double cosine_across(Index side) const {
    return normals_[side / 3].dot(normals_[twin_[side] / 3]);
  }

  void cut(Index side) {
    twin_[twin_[side]] = kNone;
    twin_[side] = kNone;
  }

  void make_fans() {
    fan_.assign(twin_.size(), kNone);
    offsets_.clear();
    for (Index corner = 0; corner < twin_.size(); ++corner) {
      if (fan_[corner] != kNone) continue;
      // Back to where the piece begins, if it does not go all the way round.
      Index first = corner;
      while (twin_[first] != kNone && next(twin_[first]) != corner) first = next(twin_[first]);
      if (twin_[first] != kNone) first = corner;
      make_offset(first);
    }
  }

  // A side of the fan's outline: outwards in the plane of its triangle, nothing on rims.
  Vec3 beyond(Index side) const {
    if (twin_[side] != kNone || rim_[side] != 0) return Vec3::Zero();
    const Vec3 along = point(next(side)) - point(side);
    const Vec3 outwards = along.cross(normals_[side / 3]);
    const double length = outwards.norm();
    return length > 0 ? Vec3(outwards / length) : Vec3(Vec3::Zero());
  }

  void make_offset(Index first) {
    const auto number = static_cast<Index>(offsets_.size());
    Vec3 sum = Vec3::Zero();
    double angles = 0;
    Index corner = first;
    Index last = first;
    do {
      fan_[corner] = number;
      const double angle = angle_between(point(next(corner)) - point(corner),
                                         point(previous(corner)) - point(corner));
      // Without an area there is no normal to weigh.
      if (normals_[corner / 3] != Vec3::Zero()) {
        sum += angle * normals_[corner / 3];
        angles += angle;
      }
      last = corner;
      corner = twin_[previous(corner)];
    } while (corner != kNone && corner != first);
    Offset offset{point(first), Vec3::Zero()};
    // The mean cosine between the normals and theirs is length / angles.
    const double length = sum.norm();
    if (length > 0)
      offset.out = sum / length * (thickness_ / 2) * std::min(angles / length, kMitre);
    // The end of a slit stays where it is.
    if (corner == kNone && angles < kSlit) {
      const Vec3 out = mitred(beyond(first), beyond(previous(last)));
      offset.middle += kOverlap * thickness_ * out;
    }
    offsets_.push_back(offset);
  }

  // As far beyond both of two lines, given by unit vectors, or zero.
  static Vec3 mitred(const Vec3& a, const Vec3& b) {
    const Vec3 sum = a + b;
    const double square = sum.squaredNorm();
    if (a == Vec3::Zero() || b == Vec3::Zero() || !(square > 0)) return sum;
    return sum / std::sqrt(square) * std::min(2 / std::sqrt(square), kMitre);
  }

  // Twice the area of the layer at s of half the thickness, seen along the normal, is a + b s + c
  // s^2.
  bool turns_over(Index t) const {
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

  // A triangle by itself has parallel sides: it does not turn over.
  Index cut_off_turned() {
    Index cuts = 0;
    for (Index t = 0; t < triangles_.size(); ++t) {
      if (!turns_over(t)) continue;
      for (Index side = 3 * t; side < 3 * t + 3; ++side) {
        if (twin_[side] == kNone) continue;
        cut(side);
        ++cuts;
      }
    }
    return cuts;
  }

  const std::vector<Triangle>& triangles_;
  const std::vector<Vec3>& points_;
  double thickness_;
  std::vector<Vec3> normals_;
  std::vector<Index> twin_;
  std::vector<char> rim_;        // of each side: the surface ends there
  std::vector<Index> fan_;       // of each corner
  std::vector<Offset> offsets_;  // of each fan
};

}  // namespace

Mesh thicken(const Mesh& mesh, double thickness) try {
  if (!(thickness > 0 && std::isfinite(thickness))) {
    throw Error(ErrorCode::kInvalidOption,
                fmt::format("thickness is {}; it must be a finite number above 0", thickness));
  }
  check_positions(mesh);
  check_indices(mesh);
  const std::size_t faces = mesh.triangles.size() + mesh.quads.size();
  if (!mesh.source_faces.empty() && mesh.source_faces.size() != faces) {
    throw Error(ErrorCode::kInvalidMesh, fmt::format("source_faces has {} entries for {} faces",
                                                     mesh.source_faces.size(), faces));
  }
  const Weld weld = weld_positions(mesh.positions);
  std::vector<Vec3> points;
  points.reserve(weld.first_of.size());
  for (const Index first : weld.first_of) points.push_back(mesh.positions[first]);
  const Faces all = welded_faces(mesh, weld);
  const auto [places, exponent] = scale_to_one(points, all.triangles);
  const Faces surface = oriented_faces(all, places);
  Thickener thickener(surface.triangles, places, std::ldexp(thickness, -exponent));
  if (!thickener.has_area()) {
    throw Error(ErrorCode::kInvalidMesh, "no face of the mesh has an area");
  }
  thickener.run();
  Mesh shell = thickener.shell(surface.source);
  shell.positions = scaled(shell.positions, exponent);
  return shell;
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, "there is not enough memory to thicken the surface");
}

}  // namespace kdm
