// SPDX-License-Identifier: MIT
#include "construct/exact_parts.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "construct/body_search.h"
#include "geometry/exact_sign.h"
#include "geometry/triangle_distance.h"
#include "mesh/box_tree.h"
#include "mesh/boxes.h"
#include "mesh/pinches.h"
#include "mesh/sides.h"
#include "prepare/input_faces.h"

namespace kdm {
namespace {

// How far parts that stay must lie from those that are taken out, in tolerances: what becomes of
// them may lie off by more than one.
constexpr double kApart = 2;

Vec3 in_single_precision(const Vec3& p) { return p.cast<float>().cast<double>(); }

// Decides body after body. A body is a part with the cavities in it.
class ExactBodies {
 public:
  ExactBodies(const Surface& surface, SolidStates& states, double tolerance, const Bodies& bodies)
      : surface_(surface),
        states_(states),
        apart_(kApart * tolerance),
        bodies_(bodies),
        exact_(bodies.thin),
        bounds_(bodies.parts()) {}

  // Returns which bodies can be taken out.
  Marks run() {
    leave_out_misplaced();
    leave_out_patched();
    leave_out_joined();
    if (exact_.any()) leave_out_meeting();
    if (exact_.any()) leave_out_near();
    return exact_;
  }

  // Tells whether the part bounds the solid where it meets no other; without `run`, false.
  bool bounds_solid(Index part) const { return bounds_.test(part); }

  // Returns the triangles of these bodies.
  Mesh mesh_of(const Marks& wanted) const {
    Mesh mesh;
    std::size_t triangles = 0;
    for (TriangleId t = 0; t < surface_.triangles.size(); ++t)
      triangles += wanted.test(body_of(t)) ? 1 : 0;
    mesh.triangles.reserve(triangles);
    mesh.source_faces.reserve(triangles);
    std::vector<Index> number(surface_.points.size(), kNone);
    for (TriangleId t = 0; t < surface_.triangles.size(); ++t) {
      if (!wanted.test(body_of(t))) continue;
      Triangle triangle = surface_.corners[t];
      for (Index& corner : triangle) {
        Index& vertex = number[corner];
        if (vertex == kNone) {
          vertex = static_cast<Index>(mesh.positions.size());
          mesh.positions.push_back(in_single_precision(surface_.points[corner]));
        }
        corner = vertex;
      }
      mesh.triangles.push_back(triangle);
      mesh.source_faces.push_back(surface_.source_faces[t]);
      if (surface_.has_operands()) {
        mesh.source_operands.push_back(surface_.operand_of_solid[surface_.solid_of[t]]);
      }
    }
    mesh.positions.shrink_to_fit();
    return mesh;
  }

 private:
  Index body_of(TriangleId t) const { return bodies_.body_of_part[bodies_.part_of[t]]; }
  bool is_exact(TriangleId t) const { return exact_.test(body_of(t)); }

  // What closes a hole may cross anything.
  void leave_out_patched() {
    for (TriangleId t = 0; t < surface_.triangles.size(); ++t) {
      const Index source = surface_.source_faces[t];
      if (source == kPatch || source == kNone) exact_.clear(body_of(t));
    }
  }

  // Leaves out bodies with edges of more than two faces, and with vertices of more than one fan.
  void leave_out_joined() {
    const Marks pinched = find_pinched(surface_.corners, static_cast<Index>(surface_.points.size()),
                                       surface_.topology);
    for (TriangleId t = 0; t < pinched.size(); ++t) {
      if (pinched.test(t)) exact_.clear(body_of(t));
    }
  }

  // Leaves out bodies that do not bound the solid all over.
  void leave_out_misplaced() {
    std::vector<Index> solid(bodies_.parts(), 0);
    if (surface_.has_operands()) {
      for (TriangleId t = 0; t < surface_.triangles.size(); ++t) {
        solid[bodies_.part_of[t]] = surface_.solid_of[t];
      }
    }
    const auto state_in = [&](Index part, int state) {
      const int sign = bodies_.sign[part];
      return sign == 0 ? state : states_.after(state, solid[part], sign < 0);
    };
    std::vector<int> state(bodies_.parts(), 0);  // round each part
    for (const Enclosure& pair : bodies_.enclosures) {
      state[pair.inner] = state_in(pair.outer, state[pair.inner]);
    }
    for (Index part = 0; part < bodies_.parts(); ++part) {
      const bool inside_before = states_.is_inside(state[part]);
      const bool inside_behind = states_.is_inside(state_in(part, state[part]));
      bounds_.set(part, inside_before != inside_behind);
      const bool turned = inside_behind != (bodies_.sign[part] > 0);
      if (!bounds_.test(part) || turned) exact_.clear(bodies_.body_of_part[part]);
    }
  }

  // Leaves out bodies that cross or touch, and those with coordinates or triangles that are nothing
  // in single precision.
  void leave_out_meeting() {
    const Mesh mesh = mesh_of(exact_);
    for (const Vec3& p : mesh.positions) {
      if (!p.allFinite()) return exact_.clear_all();
    }
    const SelfIntersections meeting = find_self_intersections(mesh);
    std::vector<TriangleId> numbers;  // of the mesh's triangles
    for (TriangleId t = 0; t < surface_.triangles.size(); ++t) {
      if (is_exact(t)) numbers.push_back(t);
    }
    for (const Index face : meeting.faces) exact_.clear(body_of(numbers[face]));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const auto [a, b, c] = mesh.triangles[i];
      if (!has_area(mesh.positions[a], mesh.positions[b], mesh.positions[c])) {
        exact_.clear(body_of(numbers[i]));
      }
    }
  }

  // Leaves out bodies that are near to parts that stay, or hold some; as long as there are any,
  // since what was left out stays as well.
  void leave_out_near() {
    std::vector<Box> boxes;
    std::vector<TriangleId> numbers;
    for (TriangleId t = 0; t < surface_.triangles.size(); ++t) {
      if (!is_exact(t)) continue;
      const auto c = corners(t);
      boxes.push_back(box_of(c[0], c[1], c[2]));
      numbers.push_back(t);
    }
    const BoxTree tree(boxes);
    Marks done(exact_.size());  // bodies that stay, all of whose triangles were looked at
    for (bool again = true; again;) {
      again = leave_out_holders();
      const Marks exact_before = exact_;
      for (TriangleId t = 0; t < surface_.triangles.size(); ++t) {
        if (exact_before.test(body_of(t)) || done.test(body_of(t))) continue;
        again = leave_out_near_triangle(t, tree, numbers) || again;
      }
      for (Index body = 0; body < exact_.size(); ++body) done.set(body, !exact_before.test(body));
    }
  }

  bool leave_out_near_triangle(TriangleId t, const BoxTree& tree,
                               const std::vector<TriangleId>& numbers) {
    const auto own = corners(t);
    Box box = box_of(own[0], own[1], own[2]);
    box.min.array() -= apart_;
    box.max.array() += apart_;
    bool found = false;
    tree.for_each_meeting(box, [&](Index i) {
      if (!is_exact(numbers[i])) return;
      if (squared_distance(own, corners(numbers[i])) > apart_ * apart_) return;
      exact_.clear(body_of(numbers[i]));
      found = true;
    });
    return found;
  }

  // Leaves out bodies whose material holds parts that stay.
  bool leave_out_holders() {
    bool found = false;
    std::size_t i = 0;
    const std::vector<Enclosure>& pairs = bodies_.enclosures;
    while (i < pairs.size()) {
      const Index inner = pairs[i].inner;
      const std::size_t first = i;
      while (i < pairs.size() && pairs[i].inner == inner) ++i;
      if (exact_.test(bodies_.body_of_part[inner])) continue;
      for (std::size_t k = first; k < i; ++k) {
        const Index body = bodies_.body_of_part[pairs[k].outer];
        int winding = 0;  // of this body round the part that stays
        for (std::size_t n = first; n < i; ++n) {
          if (bodies_.body_of_part[pairs[n].outer] == body) winding += bodies_.sign[pairs[n].outer];
        }
        if (winding == 0 || !exact_.test(body)) continue;
        exact_.clear(body);
        found = true;
      }
    }
    return found;
  }

  std::array<Vec3, 3> corners(TriangleId t) const {
    const Triangle& c = surface_.corners[t];
    return {surface_.points[c[0]], surface_.points[c[1]], surface_.points[c[2]]};
  }

  const Surface& surface_;
  SolidStates& states_;
  double apart_;
  const Bodies& bodies_;
  Marks exact_;   // per body
  Marks bounds_;  // per part
};

// Takes the marked triangles out of the surface. They are whole parts, so no side loses its
// opposite.
void take_out(const Marks& marked, Surface& surface) {
  std::vector<TriangleId> number(marked.size(), kNone);
  TriangleId kept = 0;
  Marks degenerate;
  std::vector<SideId>& opposite = surface.topology.opposite;
  for (TriangleId t = 0; t < marked.size(); ++t) {
    if (marked.test(t)) continue;
    number[t] = kept;
    surface.triangles[kept] = surface.triangles[t];
    surface.corners[kept] = surface.corners[t];
    surface.planes[kept] = surface.planes[t];
    surface.source_faces[kept] = surface.source_faces[t];
    if (surface.has_operands()) surface.solid_of[kept] = surface.solid_of[t];
    degenerate.push_back(surface.degenerate.test(t));
    for (SideId i = 0; i < 3; ++i) opposite[3 * kept + i] = opposite[3 * t + i];
    ++kept;
  }
  surface.triangles.resize(kept);
  surface.corners.resize(kept);
  surface.planes.resize(kept);
  surface.source_faces.resize(kept);
  if (surface.has_operands()) surface.solid_of.resize(kept);
  surface.degenerate = std::move(degenerate);
  opposite.resize(3 * std::size_t{kept});
  const auto renumber = [&](SideId& side) {
    if (side != kNone) side = 3 * number[triangle_of(side)] + side % 3;
  };
  for (SideId& side : opposite) renumber(side);
  for (SideId& side : surface.topology.non_manifold_sides) renumber(side);
}

}  // namespace

ExactParts take_exact_parts(Surface& surface, SolidStates& states, const BuildOptions& options) {
  ExactParts result;
  if (surface.has_rims() || !goes_by_tolerance(options)) return result;
  const double tolerance = tolerance_of(options, surface.extent);
  const std::optional<Bodies> bodies = find_thin_bodies(surface, tolerance);
  if (!bodies) return result;
  ExactBodies search(surface, states, tolerance, *bodies);
  const Marks exact = search.run();
  for (Index part = 0; part < bodies->parts(); ++part) {
    const Index body = bodies->body_of_part[part];
    if (exact.test(body)) {
      ++result.parts;
    } else if (bodies->thin.test(body) && search.bounds_solid(part)) {
      ++result.inexact;
    }
  }
  if (result.parts == 0) return result;
  result.mesh = search.mesh_of(exact);
  Marks taken;
  for (const Index part : bodies->part_of) taken.push_back(exact.test(bodies->body_of_part[part]));
  take_out(taken, surface);
  surface.topology.components -= result.parts;
  surface.part_of = find_parts(surface.topology);
  return result;
}

}  // namespace kdm
