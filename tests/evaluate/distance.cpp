// SPDX-License-Identifier: MIT
#include "distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace kdm::bench {
namespace {

// The nearest point of a triangle by its Voronoi regions (Ericson, Real-Time Collision Detection,
// 2005, 5.1.5).
double squared_distance(const Vec3& p, const std::array<Vec3, 3>& t) {
  const Vec3 ab = t[1] - t[0];
  const Vec3 ac = t[2] - t[0];
  const Vec3 ap = p - t[0];
  const double d1 = ab.dot(ap);
  const double d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return ap.squaredNorm();
  const Vec3 bp = p - t[1];
  const double d3 = ab.dot(bp);
  const double d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return bp.squaredNorm();
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return (ap - ab * (d1 / (d1 - d3))).squaredNorm();
  const Vec3 cp = p - t[2];
  const double d5 = ab.dot(cp);
  const double d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return cp.squaredNorm();
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return (ap - ac * (d2 / (d2 - d6))).squaredNorm();
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = (d4 - d3) / (d4 - d3 + d5 - d6);
    return (bp - (t[2] - t[1]) * w).squaredNorm();
  }
  const double sum = va + vb + vc;
  return (ap - ab * (vb / sum) - ac * (vc / sum)).squaredNorm();
}

// A bounding volume tree over triangles; node i's children are 2i+1 and 2i+2 of an implicit
// balanced tree over `order_`.
class TriangleTree {
 public:
  explicit TriangleTree(const Mesh& mesh) {
    for (const Triangle& t : all_triangles(mesh)) {
      triangles_.push_back({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
    }
    order_.resize(triangles_.size());
    std::iota(order_.begin(), order_.end(), 0u);
    build(0, order_.size());
  }

  double squared_distance_to(const Vec3& p) const {
    double best = std::numeric_limits<double>::infinity();
    search(0, p, best);
    return best;
  }

 private:
  static constexpr std::size_t kLeafSize = 4;

  struct Node {
    Vec3 min, max;
    std::size_t begin, end;
    std::size_t right;  // 0: leaf; the left child follows its parent
  };

  std::size_t build(std::size_t begin, std::size_t end) {
    const std::size_t number = nodes_.size();
    Node node{Vec3::Constant(std::numeric_limits<double>::infinity()),
              Vec3::Constant(-std::numeric_limits<double>::infinity()), begin, end, 0};
    for (std::size_t i = begin; i < end; ++i) {
      for (const Vec3& p : triangles_[order_[i]]) {
        node.min = node.min.cwiseMin(p);
        node.max = node.max.cwiseMax(p);
      }
    }
    nodes_.push_back(node);
    if (end - begin > kLeafSize) {
      int axis = 0;
      (node.max - node.min).maxCoeff(&axis);
      const auto centre = [&](Index t) {
        return triangles_[t][0][axis] + triangles_[t][1][axis] + triangles_[t][2][axis];
      };
      const std::size_t middle = begin + (end - begin) / 2;
      const auto at = [&](std::size_t i) {
        return order_.begin() + static_cast<std::ptrdiff_t>(i);
      };
      std::nth_element(at(begin), at(middle), at(end),
                       [&](Index a, Index b) { return centre(a) < centre(b); });
      build(begin, middle);
      nodes_[number].right = build(middle, end);
    }
    return number;
  }

  double squared_distance_to_box(std::size_t node, const Vec3& p) const {
    return (nodes_[node].min - p).cwiseMax(p - nodes_[node].max).cwiseMax(0).squaredNorm();
  }

  void search(std::size_t number, const Vec3& p, double& best) const {
    const Node& node = nodes_[number];
    if (node.right == 0) {
      for (std::size_t i = node.begin; i < node.end; ++i) {
        best = std::min(best, squared_distance(p, triangles_[order_[i]]));
      }
      return;
    }
    std::size_t near = number + 1;
    std::size_t far = node.right;
    double near_distance = squared_distance_to_box(near, p);
    double far_distance = squared_distance_to_box(far, p);
    if (far_distance < near_distance) {
      std::swap(near, far);
      std::swap(near_distance, far_distance);
    }
    if (near_distance < best) search(near, p, best);
    if (far_distance < best) search(far, p, best);
  }

  std::vector<std::array<Vec3, 3>> triangles_;
  std::vector<Index> order_;
  std::vector<Node> nodes_;
};

}  // namespace

std::vector<Triangle> all_triangles(const Mesh& mesh) {
  std::vector<Triangle> triangles = mesh.triangles;
  for (const auto& [a, b, c, d] : mesh.quads) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }
  return triangles;
}

double diagonal(const Mesh& mesh) {
  if (mesh.positions.empty()) return 0;
  Vec3 min = mesh.positions[0];
  Vec3 max = min;
  for (const Vec3& p : mesh.positions) {
    min = min.cwiseMin(p);
    max = max.cwiseMax(p);
  }
  return (max - min).norm();
}

std::vector<double> distances_of_points(const std::vector<Vec3>& points, const Mesh& to) {
  std::vector<double> distances(points.size(), std::numeric_limits<double>::infinity());
  if (all_triangles(to).empty()) return distances;
  const TriangleTree tree(to);
  for (std::size_t i = 0; i < points.size(); ++i) {
    distances[i] = std::sqrt(tree.squared_distance_to(points[i]));
  }
  return distances;
}

Distance distance_of_points(const std::vector<Vec3>& points, const Mesh& to) {
  Distance result;
  if (points.empty()) return result;
  for (const double distance : distances_of_points(points, to)) {
    result.max = std::max(result.max, distance);
    result.mean += distance;
    result.rms += distance * distance;
  }
  result.mean /= static_cast<double>(points.size());
  result.rms = std::sqrt(result.rms / static_cast<double>(points.size()));
  return result;
}

Distance one_sided_distance(const Mesh& from, const Mesh& to, Index samples) {
  const std::vector<Triangle> triangles = all_triangles(from);
  Distance result;
  if (triangles.empty() || all_triangles(to).empty()) {
    result.max = result.mean = result.rms = std::numeric_limits<double>::infinity();
    return result;
  }
  const TriangleTree tree(to);
  for (const Triangle& t : triangles) {
    for (const Index v : t) {
      result.max = std::max(result.max, tree.squared_distance_to(from.positions[v]));
    }
  }
  std::vector<double> area_up_to;
  double area = 0;
  for (const auto& [a, b, c] : triangles) {
    const Vec3& p = from.positions[a];
    area += (from.positions[b] - p).cross(from.positions[c] - p).norm();
    area_up_to.push_back(area);
  }
  double sum = 0;
  double sum_of_squares = 0;
  std::size_t t = 0;
  for (Index i = 0; i < samples; ++i) {
    // Evenly along the summed areas; within a triangle by the R2 low-discrepancy sequence.
    while (t + 1 < triangles.size() && area_up_to[t] < area * (i + 0.5) / samples) ++t;
    double x = std::fmod(0.5 + 0.7548776662466927 * i, 1.0);
    double y = std::fmod(0.5 + 0.5698402909980532 * i, 1.0);
    if (x + y > 1) {
      x = 1 - x;
      y = 1 - y;
    }
    const Vec3& p = from.positions[triangles[t][0]];
    const double squared = tree.squared_distance_to(p + x * (from.positions[triangles[t][1]] - p) +
                                                    y * (from.positions[triangles[t][2]] - p));
    result.max = std::max(result.max, squared);
    sum += std::sqrt(squared);
    sum_of_squares += squared;
  }
  result.max = std::sqrt(result.max);
  if (samples > 0) {
    result.mean = sum / samples;
    result.rms = std::sqrt(sum_of_squares / samples);
  }
  return result;
}

}  // namespace kdm::bench
