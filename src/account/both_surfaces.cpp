// SPDX-License-Identifier: MIT
// Takes both surfaces over.
#include "account/both_surfaces.h"

#include <algorithm>

#include "mesh/check_indices.h"
#include "mesh/check_positions.h"
#include "mesh/polygons.h"
#include "mesh/scale.h"

namespace kdm {
namespace {

// A surface stays within its tolerance but at creases and where it is thin.
constexpr double kTolerances = 4;
// As a rule it stays within this many.
constexpr double kPromised = 1.5;

void take_triangles(const Mesh& mesh, TriangleSet& to) {
  Polygons(mesh).for_each_triangle([&](Index face, const Triangle& t) {
    to.triangles.push_back(t);
    to.faces.push_back(face);
  });
}

}  // namespace

BothSurfaces::BothSurfaces(const Mesh& mesh, const GridData& grid, const Mesh& out)
    : grid_(grid), keys_(mesh.source_faces), sources_(out.source_faces) {
  for (const Mesh* m : {&mesh, &out}) {
    check_indices(*m);
    check_positions(*m);
  }
  take_triangles(mesh, input);
  take_triangles(out, result);
  ScaledPositions scaled_input = scale_to_one(mesh.positions, input.triangles);
  const int exponent = scaled_input.exponent;
  unit = std::ldexp(1.0, exponent);
  input.positions = std::move(scaled_input.positions);
  result.positions = scaled(out.positions, -exponent);
  const auto distance_of = [&](double tolerances, double sewings) {
    const double widened = std::max(tolerances * grid.tolerance * grid.lattice.step,
                                    sewings * grid.input.sewing_distance);
    return (widened + grid.simplified + grid.thickness) / unit;
  };
  reach = distance_of(kTolerances, 2);
  allowed = distance_of(kPromised, 1);
  told_apart = input_tells() ? reach / kTolerances : reach;
  leave_out_flat();
  match();
}

// Leaves out what has no area where positions are rounded to the lattice.
void BothSurfaces::leave_out_flat() {
  const double step = grid_.lattice.step / unit;
  Index kept = 0;
  for (Index t = 0; t < input.size(); ++t) {
    const Vec3 a = input.corner(t, 0);
    const Vec3 b = input.corner(t, 1);
    const Vec3 c = input.corner(t, 2);
    const double longest =
        std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
    const double doubled = input.doubled_area(t).norm();
    if (!(doubled > longest * step)) continue;  // lower than a step of the lattice
    input_area += doubled / 2;
    input.triangles[kept] = input.triangles[t];
    input.faces[kept++] = input.faces[t];
  }
  input.triangles.resize(kept);
  input.faces.resize(kept);
}

void BothSurfaces::match() {
  // Keys are numbers of faces as a rule; larger ones go without.
  const std::size_t size = std::max<std::size_t>(input.triangles.size(), keys_.size());
  result_of_face_.assign(size, kNone);
  input_of_key_.assign(size, kNone);
  for (Index t = 0; t < result.size(); ++t) {
    const Index key = result_key(t);
    if (key < size) result_of_face_[key] = t;
  }
  for (Index t = 0; t < input.size(); ++t) {
    const Index key = input_key(t);
    if (key < size) input_of_key_[key] = t;
  }
}

bool BothSurfaces::inside(int winding) const {
  switch (grid_.inside) {
    case InsideRule::kOdd:
      return winding % 2 != 0;
    case InsideRule::kNonzero:
      return winding != 0;
    default:
      return (grid_.input.flipped ? -winding : winding) > 0;
  }
}

bool BothSurfaces::is_inner(Index triangle, const Vec3& place) {
  if (grid_.sheet || grid_.thickness > 0 || result.winding(place) <= 0) return false;
  if (!input_tells()) return true;
  const Vec3 aside = reach / 16 * normalized_or_zero(input.doubled_area(triangle));
  return input_inside(place + aside) && input_inside(place - aside);
}

bool BothSurfaces::is_cut_off(Index triangle, const Vec3& place) {
  if (grid_.sheet || grid_.thickness > 0 || !input_tells()) return false;
  constexpr double kBeside = 4;  // lattice units: rounding moves faces on each other less far apart
  const double step = grid_.lattice.step / unit;
  const Vec3 aside = kBeside * step * normalized_or_zero(input.doubled_area(triangle));
  return !input_inside(place + aside) && !input_inside(place - aside);
}

}  // namespace kdm
