// SPDX-License-Identifier: MIT
// Prepares the operands of an expression, each by itself, and builds the grid of the result.
#include "csg/solids_builder.h"

#include <algorithm>
#include <new>
#include <utility>

#include "construct/exact_parts.h"
#include "construct/grid_of_surface.h"
#include "csg/prepare_operand.h"
#include "inside/make_inside_model.h"
#include "inside/solids_model.h"
#include "kdmanifold/error.h"
#include "kdmanifold/options.h"
#include "mesh/boxes.h"
#include "mesh/progress.h"
#include "split/cell_surface.h"
#include "text/compose.h"

namespace kdm {
namespace {

// The twelve triangles of a box.
Mesh box_mesh(const Box& box) {
  Mesh mesh;
  for (unsigned corner = 0; corner < 8; ++corner) {
    mesh.positions.emplace_back(((corner & 1) != 0 ? box.max : box.min)[0],
                                ((corner & 2) != 0 ? box.max : box.min)[1],
                                ((corner & 4) != 0 ? box.max : box.min)[2]);
  }
  for (Index axis = 0; axis < 3; ++axis) {
    const Index w = 1u << axis;
    const Index u = 1u << (axis + 1) % 3;
    const Index v = 1u << (axis + 2) % 3;
    mesh.triangles.insert(mesh.triangles.end(), {{0, u + v, u}, {0, v, u + v}});
    mesh.triangles.insert(mesh.triangles.end(), {{w, w + u, w + u + v}, {w, w + u + v, w + v}});
  }
  return mesh;
}

// Marks the operands that the expression names.
Marks named_operands(const Expression& expression, std::size_t operands) {
  Marks named(operands);
  for (const Expression::Node& node : expression.nodes()) {
    if (node.kind != Expression::Kind::kOperand) continue;
    if (node.first >= operands) {
      throw Error(ErrorCode::kInvalidOption,
                  compose("expression: it names operand {}, but there are {}, counted from 0",
                          node.first, operands));
    }
    named.set(node.first);
  }
  return named;
}

void check_for_solids(const BuildOptions& options) {
  for (const auto& [name, size] : {std::pair("minimum_thickness", options.minimum_thickness),
                                   std::pair("minimum_gap", options.minimum_gap)}) {
    if (size == 0) continue;
    throw Error(ErrorCode::kInvalidOption, compose("`{}`: not for Boolean operations", name));
  }
}

// Tells whether the expression holds for points far away from all operands.
bool holds_far_away(const Expression& expression) {
  const std::vector<Index> operands(expression.operands(), 0);
  return SolidFunction(expression, operands).value(Marks(1));
}

// A solid by itself is no more than a mesh, and comes out like one. `tolerance` is in lattice
// units.
std::unique_ptr<InsideModel> model_of(const JoinedSolids& joined, SolidFunction function,
                                      SolidStates& states, BuildOptions options, double tolerance) {
  Marks inside(joined.rules.size());
  inside.set(0);
  if (!joined.surface.several_solids() && function.value(inside)) {
    options.inside = joined.rules[0];
    return make_inside_model(joined.surface, options, tolerance);
  }
  return make_solids_model(joined.surface, states, tolerance);
}

// Returns the triangles of a surface in model units.
Mesh mesh_of(const Surface& surface) {
  Mesh mesh;
  for (std::size_t t = 0; t < surface.corners.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const PointId p = surface.corners[t][i];
      if (p >= mesh.positions.size()) mesh.positions.resize(p + 1, Vec3::Zero());
      mesh.positions[p] = surface.lattice.to_model(to_vec3(surface.triangles[t][i]));
    }
  }
  mesh.triangles = surface.corners;
  return mesh;
}

}  // namespace

SolidsBuilder::SolidsBuilder(std::vector<Operand> operands, Expression expression,
                             const BuildOptions& options, Builds builds)
    : operands_(std::move(operands)),
      expression_(std::move(expression)),
      options_(options),
      again_(builds == Builds::kAgain),
      prepared_(operands_.size()),
      moved_(operands_.size()) {
  check_options(options);
  check_for_solids(options);
  named_ = named_operands(expression_, operands_.size());
}

void SolidsBuilder::place(Index operand, const Transform& transform) {
  operands_[operand].transform = transform;
  prepared_[operand].reset();
  moved_.set(operand);
}

// Returns the operands that the expression names, prepared.
std::vector<SolidFaces> SolidsBuilder::prepare(const Progress& progress) {
  const double count = static_cast<double>(operands_.size());
  std::vector<SolidFaces> solids;
  for (Index i = 0; i < operands_.size(); ++i) {
    if (!named_.test(i)) continue;
    if (!prepared_[i]) {
      prepared_[i] =
          prepare_operand(operands_[i], i, options_,
                          part_of_progress(progress, 0.1 * i / count, 0.1 * (i + 1) / count));
    }
    solids.push_back(again_ ? *prepared_[i] : std::move(*prepared_[i]));
  }
  return solids;
}

// Tells whether cells of the last grid may be cells of this one. `states` keep their numbers then.
bool SolidsBuilder::continues(const Frame& frame) const {
  return former_.complete && frame == frame_;
}

SolidsGrid SolidsBuilder::build(double share, Faces wanted, const Progress& progress) try {
  report_progress(progress, 0.0, "prepare");
  std::vector<SolidFaces> solids = prepare(progress);
  std::vector<Index> solid_of_operand(operands_.size() + 1, kNone);  // and of the box
  for (Index i = 0; i < solids.size(); ++i) solid_of_operand[solids[i].operand] = i;
  const std::size_t given = solids.size();
  Expression whole = expression_;
  if (holds_far_away(expression_)) {
    Box bounds;
    for (const SolidFaces& solid : solids) {
      grow(bounds, solid.faces.bounds.min);
      grow(bounds, solid.faces.bounds.max);
    }
    whole = intersection(expression_, static_cast<Index>(operands_.size()));
    solid_of_operand.back() = static_cast<Index>(solids.size());
    solids.push_back({prepare_faces(box_mesh(bounds), {.inside = InsideRule::kPositive}),
                      InsideRule::kPositive, kNone});
  }
  JoinedSolids joined = join_solids(solids, options_, again_ ? Rounded::kKept : Rounded::kDropped);
  for (std::size_t i = 0; i < given && again_; ++i) {
    prepared_[solids[i].operand]->rounded = std::move(solids[i].rounded);
  }
  SolidBits moved = 0;
  for (Index i = 0; i < solid_of_operand.size(); ++i) {
    Index& solid = solid_of_operand[i];
    if (solid == kNone) continue;
    solid = joined.solid_of_given[solid];
    const bool is_box = i == operands_.size();
    if ((is_box || moved_.test(i)) && solid < kMostSolidBits) moved |= SolidBits{1} << solid;
  }
  const double tolerance = share * lattice_tolerance(joined.surface, options_);
  SolidsGrid built;
  if (wanted == Faces::kToo) built.faces = mesh_of(joined.surface);
  const SolidFunction function(whole, solid_of_operand);
  SolidStates states(function, joined.rules);
  ExactParts exact = take_exact_parts(joined.surface, states, options_);
  const bool remembers = again_ && joined.surface.several_solids() &&
                         joined.rules.size() <= kMostSolidBits && exact.parts == 0;
  Frame frame;
  if (remembers) {
    frame = {joined.surface.lattice, tolerance,    has_open_sides(joined.surface),
             joined.solid_of_given,  joined.rules, joined.surface.solid_of};
  }
  const bool continued = remembers && continues(frame);
  if (!continued) {
    former_ = {};
    states_.emplace(std::move(states));
  }
  const std::unique_ptr<InsideModel> model =
      model_of(joined, function, *states_, options_, tolerance);
  std::vector<InputReport> reports(operands_.size());
  for (std::size_t i = 0; i < given; ++i) reports[solids[i].operand] = solids[i].faces.report;
  joined.surface.report = sum_of(reports);
  joined.surface.report.extent = joined.surface.extent;
  joined.surface.report.lattice_step = joined.surface.lattice.step;
  FormerCells notes;
  std::unique_ptr<GridData> grid =
      grid_of_surface(joined.surface, *model, options_, tolerance, std::move(exact), progress,
                      {continued ? &former_ : nullptr, moved, remembers ? &notes : nullptr});
  former_ = std::move(notes);
  frame_ = std::move(frame);
  moved_.clear_all();
  grid->operands = std::move(reports);
  built.grid = Grid(std::move(grid));
  return built;
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, "there is not enough memory to build the grid");
}

}  // namespace kdm
