// SPDX-License-Identifier: MIT
// Pairs points on a circle without crossings, by a dynamic programme over intervals: to pair the
// first point of an interval with another one leaves two intervals that are independent.
#include "link/matching.h"

#include <limits>

#include "geometry/assert.h"

namespace kdm {
namespace {

// Returns each point's partner. `choice[i * (count + 1) + n]` is the partner of point i when only
// the n points from i on are paired, or kNone if it is left alone then.
std::vector<Index> partners_of(const std::vector<Index>& choice, Index count) {
  const std::size_t row = count + 1;
  std::vector<Index> partner(count, kNone);
  std::vector<std::pair<Index, Index>> open{{0, count}};  // first point and number of points
  while (!open.empty()) {
    const auto [i, length] = open.back();
    open.pop_back();
    if (length == 0) continue;
    const Index j = choice[i * row + length];
    if (j == kNone) {
      open.emplace_back(i + 1, length - 1);
      continue;
    }
    partner[i] = j;
    partner[j] = i;
    open.emplace_back(i + 1, j - i - 1);
    open.emplace_back(j + 1, i + length - j - 1);
  }
  return partner;
}

}  // namespace

std::vector<Index> match_without_crossings(Index count,
                                           const std::function<double(Index, Index)>& cost) {
  KDM_ASSERT(count % 2 == 0, "an even number of hits lies round a minimal face");
  // best[i][n]: least cost of pairing the n points from i on; choice: partner of i in it.
  const std::size_t row = count + 1;
  std::vector<double> best((count + 1) * row, 0.0);
  std::vector<Index> choice((count + 1) * row, kNone);
  for (Index length = 2; length <= count; length += 2) {
    for (Index i = 0; i + length <= count; ++i) {
      double least = std::numeric_limits<double>::infinity();
      for (Index n = 2; n <= length; n += 2) {
        const Index j = i + n - 1;
        const double total =
            cost(i, j) + best[(i + 1) * row + n - 2] + best[(j + 1) * row + length - n];
        if (total < least || n == 2) {
          least = total;
          choice[i * row + length] = j;
        }
      }
      best[i * row + length] = least;
    }
  }
  return partners_of(choice, count);
}

std::vector<Index> match_brackets(const std::vector<bool>& opens) {
  const auto count = static_cast<Index>(opens.size());
  // Read from the point of least depth on, no bracket closes before it has opened.
  Index first = 0;
  int depth = 0;
  int least = 0;
  for (Index i = 0; i < count; ++i) {
    depth += opens[i] ? 1 : -1;
    if (depth < least) {
      least = depth;
      first = i + 1;
    }
  }
  KDM_ASSERT(depth == 0, "as many hits lead one way across a minimal face as the other");
  std::vector<Index> partner(count, kNone);
  std::vector<Index> open;
  for (Index n = 0; n < count; ++n) {
    const Index i = (first + n) % count;
    if (opens[i]) {
      open.push_back(i);
      continue;
    }
    partner[i] = open.back();
    partner[open.back()] = i;
    open.pop_back();
  }
  return partner;
}

namespace {

constexpr Index kCubicLimit = 256;  // points, with which cubic time is 3 million steps

// Pairs each point with the last one before it that has no partner, if these two may be paired.
std::vector<Index> match_like_brackets(Index count,
                                       const std::function<bool(Index, Index)>& may_pair) {
  std::vector<Index> partner(count, kNone);
  std::vector<Index> open;
  for (Index i = 0; i < count; ++i) {
    if (!open.empty() && may_pair(open.back(), i)) {
      partner[i] = open.back();
      partner[open.back()] = i;
      open.pop_back();
    } else {
      open.push_back(i);
    }
  }
  return partner;
}

// The price of a pairing. Fewer points left without partner always make it lower; the cost decides
// between pairings that leave equally many.
struct Price {
  Index alone = 0;
  double cost = 0;

  Price operator+(const Price& other) const { return {alone + other.alone, cost + other.cost}; }
  bool operator<(const Price& other) const {
    return alone != other.alone ? alone < other.alone : cost < other.cost;
  }
};

}  // namespace

std::vector<Index> match_some(Index count, const std::function<bool(Index, Index)>& may_pair,
                              const std::function<double(Index, Index)>& cost) {
  if (count > kCubicLimit) return match_like_brackets(count, may_pair);
  // best[i][n]: least price of the n points from i on; choice: partner of i in it.
  const std::size_t row = count + 1;
  std::vector<Price> best((count + 1) * row);
  std::vector<Index> choice((count + 1) * row, kNone);
  for (Index length = 1; length <= count; ++length) {
    for (Index i = 0; i + length <= count; ++i) {
      Price least = Price{1, 0} + best[(i + 1) * row + length - 1];
      for (Index j = i + 1; j < i + length; ++j) {
        if (!may_pair(i, j)) continue;
        const Price price = Price{0, cost(i, j)} + best[(i + 1) * row + j - i - 1] +
                            best[(j + 1) * row + i + length - j - 1];
        if (!(price < least)) continue;
        least = price;
        choice[i * row + length] = j;
      }
      best[i * row + length] = least;
    }
  }
  return partners_of(choice, count);
}

}  // namespace kdm
