// SPDX-License-Identifier: MIT
// Tells from the solids that a point lies in whether it lies in the result of an expression.
#pragma once

#include <vector>

#include "kdmanifold/expression.h"
#include "mesh/marks.h"

namespace kdm {

/// A Boolean function of "the point lies in solid k".
class SolidFunction {
 public:
  /// `solid_of_operand` says which solid each operand of the expression is: operands may be the
  /// same.
  SolidFunction(const Expression& expression, std::span<const Index> solid_of_operand);

  /// Returns the function's value for a point in the marked solids and in no other.
  bool value(const Marks& inside);

  /// Given the solids that a point lies in, of some `open` ones it is not known: unmarks those
  /// among them that make no difference, whatever holds for the other open ones.
  void keep_relevant(const Marks& inside, Marks& open);

 private:
  // What is known of a node: the values it may have.
  enum Values : unsigned char { kFalse = 1, kTrue = 2, kBoth = 3 };
  static Values combine(Expression::Kind kind, Values a, Values b);

  std::vector<Expression::Node> nodes_;  // operands are solids
  std::vector<Values> values_;           // per node, scratch
};

}  // namespace kdm
