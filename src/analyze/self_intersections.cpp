// SPDX-License-Identifier: MIT
// Finds faces that cross or touch where they share nothing. Triangles over the same three vertices
// meet the same others, so one triangle of each set is looked at and stands for all of them.
#include <algorithm>
#include <new>

#include "geometry/triangle_triangle.h"
#include "kdmanifold/error.h"
#include "kdmanifold/mesh.h"
#include "mesh/box_tree.h"
#include "mesh/boxes.h"
#include "mesh/check_indices.h"
#include "mesh/marks.h"
#include "mesh/polygons.h"
#include "mesh/same_corners.h"
#include "mesh/scale.h"
#include "mesh/sort.h"
#include "threads/share_work.h"

namespace kdm {
namespace {

using Corners = std::array<Vec3, 3>;

// So many pairs are tested at a time, and this many by one thread before it takes others.
constexpr std::size_t kMostWaiting = 1 << 16;
constexpr std::size_t kPairsPerPart = 1024;

class Search {
 public:
  explicit Search(const Mesh& mesh)
      : faces_(mesh), positions_(scale_to_one(mesh.positions).positions) {
    triangles_.reserve(mesh.triangles.size() + 2 * mesh.quads.size());
    faces_.for_each_triangle([&](Index, const Triangle& t) { triangles_.push_back(t); });
    find_sets(static_cast<Index>(mesh.positions.size()));
    for (std::size_t i = mesh.triangles.size(); i < triangles_.size(); i += 2) {
      quads_.push_back(ordered(set_of_[i], set_of_[i + 1]));
    }
    sort_up(quads_);
  }

  SelfIntersections run() {
    crossing_.assign(first_.size());
    std::vector<Box> boxes;
    boxes.reserve(first_.size());
    for (Index set = 0; set < first_.size(); ++set) {
      const auto [a, b, c] = corners(set);
      boxes.push_back(box_of(a, b, c));
      if (size_[set] > 1) look_at(set, set);
    }
    BoxTree(boxes).for_each_pair([&](Index i, Index j) { look_at(i, j); });
    look_at_waiting();

    std::size_t triangle = 0;
    for (Index face = 0; face < faces_.size(); ++face) {
      bool found = false;
      for (Index rest = faces_.corners(face) - 2; rest > 0; --rest) {
        found = crossing_.test(set_of_[triangle++]) || found;
      }
      if (found) result_.faces.push_back(face);
    }
    return std::move(result_);
  }

 private:
  static Edge ordered(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

  void find_sets(Index points) {
    set_of_.resize(triangles_.size());
    for_each_corner_set(triangles_, points, [&](std::span<const SortedCorners> set) {
      for (const SortedCorners& t : set) set_of_[t.triangle] = static_cast<Index>(first_.size());
      first_.push_back(set[0].triangle);
      size_.push_back(static_cast<Index>(set.size()));
    });
  }

  const Triangle& numbers(Index set) const { return triangles_[first_[set]]; }
  Corners corners(Index set) const {
    const Triangle& n = numbers(set);
    return {positions_[n[0]], positions_[n[1]], positions_[n[2]]};
  }

  void look_at(Index i, Index j) {
    waiting_.push_back({i, j});
    if (waiting_.size() == kMostWaiting) look_at_waiting();
  }

  // Shares the tests of the pairs that wait among threads.
  void look_at_waiting() {
    cross_.assign(waiting_.size());
    share_parts(waiting_.size(), kPairsPerPart, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        const auto [i, j] = waiting_[n];
        cross_.set(
            n, TriangleCrossing<RealKernel>::test(corners(i), numbers(i), corners(j), numbers(j)));
      }
    });
    for (std::size_t n = 0; n < waiting_.size(); ++n) {
      if (cross_.test(n)) count(waiting_[n][0], waiting_[n][1]);
    }
    waiting_.clear();
  }

  // Counts all pairs of one triangle of each set, or of two triangles if the sets are the same. The
  // two halves of a quad are no pair.
  void count(Index i, Index j) {
    const std::uint64_t n = size_[i];
    const auto halves = std::equal_range(quads_.begin(), quads_.end(), ordered(i, j));
    const std::uint64_t pairs = (i == j ? n * (n - 1) / 2 : n * size_[j]) -
                                static_cast<std::uint64_t>(halves.second - halves.first);
    if (pairs == 0) return;
    result_.pairs += pairs;
    crossing_.set(i);
    crossing_.set(j);
  }

  Polygons faces_;
  std::vector<Vec3> positions_;
  std::vector<Triangle> triangles_;
  std::vector<Index> set_of_;  // per triangle
  std::vector<Index> first_;   // per set: its first triangle
  std::vector<Index> size_;    // per set
  std::vector<Edge> quads_;    // the sets of each quad's halves, ascending
  Marks crossing_;             // sets whose triangles cross others
  std::vector<Edge> waiting_;  // pairs of sets to be tested
  Marks cross_;                // per waiting pair
  SelfIntersections result_;
};

}  // namespace

SelfIntersections find_self_intersections(const Mesh& mesh) try {
  check_indices(mesh);
  return Search(mesh).run();
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, "there is not enough memory to look for crossings");
}

}  // namespace kdm
