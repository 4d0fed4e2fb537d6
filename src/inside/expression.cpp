// SPDX-License-Identifier: MIT
// Puts expressions together.
#include "kdmanifold/expression.h"

#include <algorithm>

#include "kdmanifold/error.h"

namespace kdm {
namespace {

// Joins the parts from the left to the right.
Expression join(std::span<const Expression> parts,
                Expression (*two)(const Expression&, const Expression&)) {
  if (parts.empty()) {
    throw Error(ErrorCode::kInvalidOption, "expression: an operation needs one operand at least");
  }
  Expression whole = parts[0];
  for (std::size_t i = 1; i < parts.size(); ++i) whole = two(whole, parts[i]);
  return whole;
}

}  // namespace

Expression::Expression(Kind kind, const Expression& first, const Expression& second)
    : nodes_(first.nodes_) {
  const auto end_of_first = static_cast<Index>(nodes_.size() - 1);
  append(second);
  nodes_.push_back({kind, end_of_first, static_cast<Index>(nodes_.size() - 1)});
}

Expression Expression::complement_of(const Expression& of) {
  Expression whole = of;
  whole.nodes_.push_back({Kind::kComplement, static_cast<Index>(whole.nodes_.size() - 1), kNone});
  return whole;
}

void Expression::append(const Expression& part) {
  const auto shift = static_cast<Index>(nodes_.size());
  for (Node node : part.nodes_) {
    if (node.kind != Kind::kOperand) node.first += shift;
    if (node.second != kNone) node.second += shift;
    nodes_.push_back(node);
  }
}

Index Expression::operands() const {
  Index count = 0;
  for (const Node& node : nodes_) {
    if (node.kind == Kind::kOperand) count = std::max(count, node.first + 1);
  }
  return count;
}

Expression union_of(const Expression& a, const Expression& b) {
  return {Expression::Kind::kUnion, a, b};
}
Expression union_of(std::span<const Expression> parts) { return join(parts, union_of); }

Expression intersection(const Expression& a, const Expression& b) {
  return {Expression::Kind::kIntersection, a, b};
}
Expression intersection(std::span<const Expression> parts) { return join(parts, intersection); }

Expression difference(const Expression& a, const Expression& b) {
  return intersection(a, complement(b));
}
Expression difference(std::span<const Expression> parts) { return join(parts, difference); }

Expression symmetric_difference(const Expression& a, const Expression& b) {
  return {Expression::Kind::kExclusive, a, b};
}
Expression symmetric_difference(std::span<const Expression> parts) {
  return join(parts, symmetric_difference);
}

Expression complement(const Expression& a) { return Expression::complement_of(a); }

}  // namespace kdm
