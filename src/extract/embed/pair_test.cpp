// SPDX-License-Identifier: MIT
// Tests pairs exactly, after quick tests that decide most of them.
#include "extract/embed/pair_test.h"

#include <cmath>

#include "geometry/exact_sign.h"
#include "geometry/triangle_triangle.h"

namespace kdm {
namespace {

// The exact test takes coordinates of about one. The scale is a power of two, so it rounds nothing.
double scale_for(const Lattice& lattice) {
  int exponent = 0;
  std::frexp(lattice.origin.cwiseAbs().maxCoeff() + lattice.step * kLatticeSize, &exponent);
  return std::ldexp(1.0, -exponent);
}

}  // namespace

PairTest::PairTest(const GridView& view) : view_(view), scale_(scale_for(view.grid.lattice)) {}

void PairTest::update(const DualMesh& mesh) {
  rounded_positions_.resize(mesh.position.size());
  boxes_.resize(mesh.triangles());
}

void PairTest::read_corners(const DualMesh& mesh, TriangleId t) {
  const Triangle numbers = corner_numbers(mesh, t);
  for (const VertexId v : numbers) {
    rounded_positions_[v] = scale_ * single_precision(view_.grid.lattice, mesh.position[v]);
  }
  const auto [a, b, c] = corners(numbers);
  boxes_[t] = small_box(a, b, c);
}

CachedTriangle PairTest::cached(const DualMesh& mesh, TriangleId t) const {
  const Triangle numbers = corner_numbers(mesh, t);
  return {numbers, corners(numbers)};
}

bool PairTest::meet(const DualMesh& mesh, const CachedTriangle& triangle, TriangleId other,
                    TestedFans& fans) const {
  if (!triangle.box().meets(boxes_[other])) return false;
  const Triangle numbers = corner_numbers(mesh, other);
  const VertexId shared = triangle.shared_corner(numbers);
  if (shared != kNone
          ? fan_is_simple(mesh, shared, fans)
          : triangle.surely_apart(rounded_positions_[numbers[0]], rounded_positions_[numbers[1]],
                                  rounded_positions_[numbers[2]])) {
    return false;
  }
  return TriangleCrossing<RealKernel>::test(triangle.corners(), triangle.numbers(),
                                            corners(numbers), numbers);
}

bool PairTest::has_no_area(const DualMesh& mesh, TriangleId t) const {
  const auto [a, b, c] = corners(corner_numbers(mesh, t));
  return !has_area(a, b, c);
}

// Tells whether, seen from some direction, the triangles round the vertex lie beside each other,
// all turned the right way: then no two of them meet but in the vertex and the sides they share. If
// not, they may or may not meet.
bool PairTest::fan_is_simple(const DualMesh& mesh, VertexId v, TestedFans& fans) const {
  if (!fans.tested.test_and_set(v)) {
    fans.simple.set(v, find_if_fan_is_simple(mesh, v, fans.around));
  }
  return fans.simple.test(v);
}

// Looks along the sum of the normals of the hits round the vertex.
bool PairTest::find_if_fan_is_simple(const DualMesh& mesh, VertexId v,
                                     std::vector<OuterSide>& around) const {
  if (mesh.on_boundary(v)) return false;
  Vec3 normal = Vec3::Zero();
  around.clear();
  const Vec3& apex = mesh.position[v];
  for (const HalfEdgeId h : mesh.ring(v)) {
    normal += view_.grid.plane_of(mesh.hit[h / 3]).normal;
    around.emplace_back(mesh.position[mesh.end_vertex(h)] - apex,
                        mesh.position[mesh.vertex[previous_in_triangle(h)]] - apex);
  }
  return is_simple_fan(around, normal);
}

}  // namespace kdm
