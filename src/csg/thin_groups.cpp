// SPDX-License-Identifier: MIT
// Joins thin parts to groups by what they meet.
#include "csg/thin_groups.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "construct/body_search.h"
#include "geometry/triangle_distance.h"
#include "mesh/box_tree.h"
#include "mesh/boxes.h"
#include "mesh/disjoint_sets.h"
#include "mesh/groups.h"
#include "mesh/joined.h"
#include "mesh/measure.h"
#include "mesh/pinches.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

// Parts belong together if they are no further apart than this share of their thickness.
constexpr double kNearShare = 0.25;
// How far parts that are not thin must lie from a group, in tolerances, as for thin parts that meet
// nothing.
constexpr double kApart = 2;
// How many cells as long as their parts are thick all groups may take together.
constexpr double kMostStretches = 10000;
// A square rod of some length has the area of so many squares of its mean thickness, which is half
// a side, for each stretch as long as a side.
constexpr double kSquaresOfStretch = 16;

struct Part {
  Measure measure;
  Box bounds;
  double thickness = 0;  // the mean one; 0: the part is not thin, or it is patched

  bool thin() const { return thickness > 0; }
};

// Parts that are near to each other.
struct PartSet {
  bool meets = false;  // some part meets others, or itself
  bool stays = false;
  double area = 0;
  double thickness = std::numeric_limits<double>::infinity();  // the least one
  Index group = kNone;

  bool wanted() const { return meets && !stays; }
  double stretches() const { return area / (kSquaresOfStretch * thickness * thickness); }
};

Box widened(Box box, double by) {
  box.min.array() -= by;
  box.max.array() += by;
  return box;
}

// Makes meshes of some triangles, over no more points than these have.
class MeshMaker {
 public:
  explicit MeshMaker(const InputFaces& faces)
      : faces_(faces), number_(faces.points.size(), kNone) {}

  Mesh make(std::span<const TriangleId> triangles) {
    Mesh mesh;
    for (const TriangleId t : triangles) {
      Triangle triangle = faces_.triangles[t];
      for (Index& corner : triangle) {
        Index& vertex = number_[corner];
        if (vertex == kNone) {
          vertex = static_cast<Index>(mesh.positions.size());
          mesh.positions.push_back(faces_.points[corner]);
        }
        corner = vertex;
      }
      mesh.triangles.push_back(triangle);
      mesh.source_faces.push_back(faces_.source_faces[t]);
    }
    for (const TriangleId t : triangles) {
      for (const PointId p : faces_.triangles[t]) number_[p] = kNone;
    }
    return mesh;
  }

 private:
  const InputFaces& faces_;
  std::vector<Index> number_;  // per point, of the mesh at hand
};

class ThinGroupSearch {
 public:
  ThinGroupSearch(const InputFaces& faces, double tolerance)
      : faces_(faces), tolerance_(tolerance), part_of_(find_parts(faces.topology)) {
    part_of_.resize(faces.triangles.size(), 0);  // it is empty if there is but one part
    measure_parts();
    for (TriangleId t = 0; t < part_of_.size(); ++t) {
      if (part(t).thin()) thin_triangles_.push_back(t);
    }
  }

  ThinGroups run() {
    ThinGroups result;
    result.some_inside_out = std::any_of(parts_.begin(), parts_.end(),
                                         [](const Part& part) { return part.measure.volume < 0; });
    if (thin_triangles_.empty()) return result;
    MeshMaker maker(faces_);
    const Marks meeting = find_meeting(maker);
    if (!meeting.any()) return result;
    DisjointSets joined = join_near();
    const std::vector<Index> set_of = number_sets(joined, parts_.size());
    std::vector<PartSet> sets = make_sets(meeting, set_of, joined.count());
    result.group_of.assign(parts_.size(), kNone);
    for (Index p = 0; p < parts_.size(); ++p) {
      PartSet& set = sets[set_of[p]];
      if (!set.wanted()) continue;
      if (set.group == kNone) {
        set.group = static_cast<Index>(result.groups.size());
        result.groups.push_back({0, {}, set.thickness});
      }
      result.group_of[p] = set.group;
      ++result.groups[set.group].parts;
    }
    const Groups triangles(result.groups.size(), [&](const auto& put) {
      for (const TriangleId t : thin_triangles_) {
        if (result.group_of[part_of_[t]] != kNone) put(result.group_of[part_of_[t]], t);
      }
    });
    for (Index group = 0; group < result.groups.size(); ++group) {
      result.groups[group].mesh = maker.make(triangles.of(group));
    }
    result.part_of = std::move(part_of_);
    return result;
  }

 private:
  void measure_parts() {
    parts_.resize(1 + *std::max_element(part_of_.begin(), part_of_.end()));
    for (TriangleId t = 0; t < part_of_.size(); ++t) {
      for (const PointId p : faces_.triangles[t])
        grow(parts_[part_of_[t]].bounds, faces_.points[p]);
    }
    for (Part& part : parts_) part.measure.centre = centre_of(part.bounds);
    for (TriangleId t = 0; t < part_of_.size(); ++t) {
      const std::array<Vec3, 3> c = corners(t);
      parts_[part_of_[t]].measure.add(c[0], c[1], c[2]);
    }
    for (Part& part : parts_) {
      const Measure& m = part.measure;
      if (is_thin(m.volume, m.area, part.bounds, tolerance_))
        part.thickness = 2 * m.volume / m.area;
    }
    for (TriangleId t = 0; t < part_of_.size(); ++t) {
      const Index source = faces_.source_faces[t];
      if (source == kPatch || source == kNone) parts_[part_of_[t]].thickness = 0;
    }
  }

  const Part& part(TriangleId t) const { return parts_[part_of_[t]]; }

  std::array<Vec3, 3> corners(TriangleId t) const {
    const auto& [a, b, c] = faces_.triangles[t];
    return {faces_.points[a], faces_.points[b], faces_.points[c]};
  }

  // Returns the boxes of the thin triangles, widened by so many thicknesses.
  std::vector<Box> thin_boxes(double by) const {
    std::vector<Box> boxes;
    boxes.reserve(thin_triangles_.size());
    for (const TriangleId t : thin_triangles_) {
      const std::array<Vec3, 3> c = corners(t);
      boxes.push_back(widened(box_of(c[0], c[1], c[2]), by * part(t).thickness));
    }
    return boxes;
  }

  // Marks thin parts that cannot be taken over as they are: in 32-bit coordinates they cross or
  // touch others, or themselves.
  Marks find_meeting(MeshMaker& maker) const {
    Mesh mesh = maker.make(thin_triangles_);
    for (Vec3& p : mesh.positions) p = p.cast<float>().cast<double>();
    Marks meeting(parts_.size());
    for (const Index face : find_self_intersections(mesh).faces) {
      meeting.set(part_of_[thin_triangles_[face]]);
    }
    const Marks pinched =
        find_pinched(faces_.triangles, static_cast<Index>(faces_.points.size()), faces_.topology);
    for (const TriangleId t : thin_triangles_) {
      if (pinched.test(t)) meeting.set(part_of_[t]);
    }
    return meeting;
  }

  DisjointSets join_near() const {
    DisjointSets sets(parts_.size());
    const std::vector<Box> boxes = thin_boxes(kNearShare);
    BoxTree(boxes).for_each_pair([&](Index i, Index j) {
      const TriangleId s = thin_triangles_[i];
      const TriangleId t = thin_triangles_[j];
      if (sets.find(part_of_[s]) == sets.find(part_of_[t])) return;
      const double near = kNearShare * std::min(part(s).thickness, part(t).thickness);
      if (squared_distance(corners(s), corners(t)) <= near * near) {
        sets.join(part_of_[s], part_of_[t]);
      }
    });
    return sets;
  }

  // Marks thin parts that are near to parts that are not thin.
  Marks find_beside_thick() const {
    const std::vector<Box> boxes = thin_boxes(0);
    const BoxTree tree(boxes);
    const double apart = kApart * tolerance_;
    Marks beside(parts_.size());
    for (TriangleId t = 0; t < part_of_.size(); ++t) {
      if (part(t).thin()) continue;
      const std::array<Vec3, 3> own = corners(t);
      tree.for_each_meeting(widened(box_of(own[0], own[1], own[2]), apart), [&](Index i) {
        const TriangleId thin = thin_triangles_[i];
        if (beside.test(part_of_[thin])) return;
        if (squared_distance(own, corners(thin)) <= apart * apart) beside.set(part_of_[thin]);
      });
    }
    return beside;
  }

  // Returns the sets of parts, with what they are as groups.
  std::vector<PartSet> make_sets(const Marks& meeting, const std::vector<Index>& set_of,
                                 Index count) const {
    std::vector<PartSet> sets(count);
    const Marks beside = find_beside_thick();
    for (Index p = 0; p < parts_.size(); ++p) {
      PartSet& set = sets[set_of[p]];
      set.meets = set.meets || meeting.test(p);
      set.stays = set.stays || beside.test(p) || !parts_[p].thin();
      set.area += parts_[p].measure.area;
      set.thickness = std::min(set.thickness, parts_[p].thickness);
    }
    std::vector<Index> shortest_first;
    for (Index i = 0; i < count; ++i) {
      if (sets[i].wanted()) shortest_first.push_back(i);
    }
    sort_by(shortest_first,
            [&](Index a, Index b) { return sets[a].stretches() < sets[b].stretches(); });
    double sum = 0;
    for (const Index i : shortest_first) {
      sum += sets[i].stretches();
      sets[i].stays = sum > kMostStretches;
    }
    return sets;
  }

  const InputFaces& faces_;
  double tolerance_;
  std::vector<Index> part_of_;  // per triangle
  std::vector<Part> parts_;
  std::vector<TriangleId> thin_triangles_;
};

}  // namespace

ThinGroups find_thin_groups(const InputFaces& faces, double tolerance) {
  return ThinGroupSearch(faces, tolerance).run();
}

}  // namespace kdm
