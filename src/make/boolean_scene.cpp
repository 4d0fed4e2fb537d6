// SPDX-License-Identifier: MIT
// Boolean operations on solids that are moved.
#include "kdmanifold/boolean_scene.h"

#include <utility>

#include "csg/solids_builder.h"
#include "kdmanifold/error.h"
#include "kdmanifold/options.h"
#include "make/make_solids.h"
#include "make/step_shares.h"
#include "mesh/progress.h"
#include "text/compose.h"

namespace kdm {

struct BooleanScene::Data {
  SolidsBuilder builder;
  MakeOptions options;
};

BooleanScene::BooleanScene(const Expression& expression, const std::vector<Operand>& operands,
                           const MakeOptions& options) {
  check_options(options.extract);
  check_for_solids(options);
  static_cast<void>(reduces(options));
  SolidsBuilder builder(operands, expression, options.build, SolidsBuilder::Builds::kAgain);
  data_ = std::make_unique<Data>(Data{std::move(builder), options});
}

BooleanScene::BooleanScene(BooleanScene&&) noexcept = default;
BooleanScene& BooleanScene::operator=(BooleanScene&&) noexcept = default;
BooleanScene::~BooleanScene() = default;

void BooleanScene::place(Index operand, const Transform& transform) {
  const std::size_t operands = data_->builder.operands();
  if (operand >= operands) {
    throw Error(
        ErrorCode::kInvalidOption,
        compose("operand: there is none of number {}, but {}, counted from 0", operand, operands));
  }
  data_->builder.place(operand, transform);
}

MadeManifold BooleanScene::make_in_steps(const StepProgress& progress) {
  return make_solids(data_->builder, data_->options, progress);
}

BooleanMesh BooleanScene::make(const Progress& progress) {
  MadeManifold made = make_in_steps(shares_of(progress));
  report_progress(progress, 1.0, "done");
  return BooleanMesh{std::move(static_cast<MadeMesh&>(made)), made.grid.operands()};
}

BooleanMesh BooleanScene::update(Index operand, const Transform& transform,
                                 const Progress& progress) {
  place(operand, transform);
  return make(progress);
}

}  // namespace kdm
