// SPDX-License-Identifier: MIT
// Evaluates expressions, with two values or three.
#include "inside/solid_function.h"

namespace kdm {

using Kind = Expression::Kind;

SolidFunction::SolidFunction(const Expression& expression, std::span<const Index> solid_of_operand)
    : nodes_(expression.nodes().begin(), expression.nodes().end()), values_(nodes_.size()) {
  for (Expression::Node& node : nodes_) {
    if (node.kind == Kind::kOperand) node.first = solid_of_operand[node.first];
  }
}

// Values are sets of the two bits, so that a complement exchanges them.
SolidFunction::Values SolidFunction::combine(Kind kind, Values a, Values b) {
  switch (kind) {
    case Kind::kUnion:
      return static_cast<Values>((a & b & kFalse) | ((a | b) & kTrue));
    case Kind::kIntersection:
      return static_cast<Values>((a & b & kTrue) | ((a | b) & kFalse));
    case Kind::kExclusive:
      if (a == kBoth || b == kBoth) return kBoth;
      return a == b ? kFalse : kTrue;
    case Kind::kComplement:
    case Kind::kOperand:
      break;
  }
  return static_cast<Values>(a >> 1 | (a & kFalse) << 1);
}

bool SolidFunction::value(const Marks& inside) {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Expression::Node& node = nodes_[i];
    if (node.kind == Kind::kOperand) {
      values_[i] = inside.test(node.first) ? kTrue : kFalse;
    } else {
      values_[i] = combine(node.kind, values_[node.first],
                           node.second == kNone ? kBoth : values_[node.second]);
    }
  }
  return values_.back() == kTrue;
}

void SolidFunction::keep_relevant(const Marks& inside, Marks& open) {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Expression::Node& node = nodes_[i];
    if (node.kind == Kind::kOperand) {
      values_[i] = open.test(node.first) ? kBoth : inside.test(node.first) ? kTrue : kFalse;
    } else {
      values_[i] = combine(node.kind, values_[node.first],
                           node.second == kNone ? kBoth : values_[node.second]);
    }
  }
  // A node matters if the nodes that it is a part of do, and if it has no certain value.
  open.clear_all();
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    const Expression::Node& node = nodes_[i];
    if (values_[i] != kBoth) {
      // Its parts, which come before it, matter no more than it does.
      if (node.kind == Kind::kOperand) continue;
      values_[node.first] = kFalse;
      if (node.second != kNone) values_[node.second] = kFalse;
    } else if (node.kind == Kind::kOperand) {
      open.set(node.first);
    }
  }
}

}  // namespace kdm
