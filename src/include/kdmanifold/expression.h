// SPDX-License-Identifier: MIT
// Boolean expressions over solids: which points are in the result, given the operands they are in.
#pragma once

#include <span>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// A Boolean expression over operands, which it names by their numbers from 0 on. Make expressions
/// from numbers by the functions below, e.g. `difference(0, union_of({1, 2}))`.
class Expression {
 public:
  /// What a node stands for.
  enum class Kind : std::uint8_t { kOperand, kUnion, kIntersection, kExclusive, kComplement };

  /// A node of the tree. Its parts are nodes before it.
  struct Node {
    Kind kind;
    Index first;   ///< its first part; of an operand, the operand's number
    Index second;  ///< its second part; kNone if there is none
  };

  /// Stands for an operand.
  Expression(Index operand) : nodes_{{Kind::kOperand, operand, kNone}} {}  // NOLINT: is meant to be

  /// Joins two expressions by a kind that has two parts.
  Expression(Kind kind, const Expression& first, const Expression& second);
  /// Stands for all points that are not in `of`.
  static Expression complement_of(const Expression& of);

  /// The nodes; the last one is the whole.
  std::span<const Node> nodes() const { return nodes_; }
  /// Returns the number of the highest operand plus one.
  Index operands() const;

 private:
  void append(const Expression& part);

  std::vector<Node> nodes_;
};

/// What is in one of the solids at least.
Expression union_of(const Expression& a, const Expression& b);
/// See above. All lists need one part at least, or `kInvalidOption` is thrown.
Expression union_of(std::span<const Expression> parts);
inline Expression union_of(std::initializer_list<Expression> parts) {
  return union_of(std::span(parts.begin(), parts.size()));
}

/// What is in all solids.
Expression intersection(const Expression& a, const Expression& b);
Expression intersection(std::span<const Expression> parts);  ///< see above
inline Expression intersection(std::initializer_list<Expression> parts) {
  return intersection(std::span(parts.begin(), parts.size()));
}

/// What is in the first solid and in none of the others.
Expression difference(const Expression& a, const Expression& b);
Expression difference(std::span<const Expression> parts);  ///< see above
inline Expression difference(std::initializer_list<Expression> parts) {
  return difference(std::span(parts.begin(), parts.size()));
}

/// What is in an odd number of the solids.
Expression symmetric_difference(const Expression& a, const Expression& b);
Expression symmetric_difference(std::span<const Expression> parts);  ///< see above
inline Expression symmetric_difference(std::initializer_list<Expression> parts) {
  return symmetric_difference(std::span(parts.begin(), parts.size()));
}

/// What is not in the solid. Where the whole expression holds for points far away, as that of a
/// complement does, the result is what lies of it in the bounding box of all operands.
Expression complement(const Expression& a);

}  // namespace kdm
