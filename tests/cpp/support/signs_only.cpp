// SPDX-License-Identifier: MIT
#include "support/signs_only.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace kdm::check {
namespace {

struct Crossing {
  double at;
  Vec3 normal;
};

class Contour {
 public:
  Contour(const Mesh& mesh, const Box& box, int n)
      : mesh_(mesh), min_(box.min), step_((box.max.x() - box.min.x()) / n), n_(n) {}

  Mesh run() {
    for (int axis = 0; axis < 3; ++axis) cast_lines(axis);
    for (int axis = 0; axis < 3; ++axis) add_faces(axis);
    place_vertices();
    return result_;
  }

 private:
  using Place = std::array<int, 3>;

  double coordinate(int axis, int i) const { return min_[axis] + i * step_; }

  // The crossings of the grid line along `axis` through (i, j) of the other two axes.
  std::vector<Crossing> crossings(int axis, int i, int j) const {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    // A little beside the line, so that no mesh edge is met.
    const double pu = coordinate(u, i) + 1e-9 * step_;
    const double pv = coordinate(v, j) + 1.7e-9 * step_;
    std::vector<Crossing> found;
    for (const Triangle& t : mesh_.triangles) {
      const Vec3& a = mesh_.positions[t[0]];
      const Vec3& b = mesh_.positions[t[1]];
      const Vec3& c = mesh_.positions[t[2]];
      const auto side = [&](const Vec3& p, const Vec3& q) {
        return (q[u] - p[u]) * (pv - p[v]) - (q[v] - p[v]) * (pu - p[u]);
      };
      const double ab = side(a, b);
      const double bc = side(b, c);
      const double ca = side(c, a);
      if ((ab > 0) != (bc > 0) || (bc > 0) != (ca > 0)) continue;
      const double sum = ab + bc + ca;
      const double at = (bc * a[axis] + ca * b[axis] + ab * c[axis]) / sum;
      found.push_back({at, (b - a).cross(c - a).normalized()});
    }
    return found;
  }

  void cast_lines(int axis) {
    for (int i = 0; i <= n_; ++i) {
      for (int j = 0; j <= n_; ++j) lines_[{axis, i, j}] = crossings(axis, i, j);
    }
  }

  bool inside(const Place& p) const {
    int below = 0;
    for (const Crossing& c : lines_.at({0, p[1], p[2]})) below += c.at < coordinate(0, p[0]);
    return below % 2 == 1;
  }

  // A quad for every edge along the axis at which the sign changes.
  void add_faces(int axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (int i = 1; i < n_; ++i) {
      for (int j = 1; j < n_; ++j) {
        for (int k = 0; k < n_; ++k) {
          Place low{};
          low[axis] = k;
          low[u] = i;
          low[v] = j;
          Place high = low;
          ++high[axis];
          const bool enters = !inside(low);
          if (enters != inside(high)) continue;
          const Crossing* hit = middle_hit(axis, i, j, k);
          if (hit == nullptr) continue;
          Vec3 point;
          point[axis] = hit->at;
          point[u] = coordinate(u, i);
          point[v] = coordinate(v, j);
          std::array<Index, 4> q{};
          constexpr int kRound[4][2] = {{-1, -1}, {0, -1}, {0, 0}, {-1, 0}};
          for (int corner = 0; corner < 4; ++corner) {
            Place cell = low;
            cell[u] += kRound[corner][0];
            cell[v] += kRound[corner][1];
            q[corner] = vertex_of(cell, point, hit->normal);
          }
          if (enters) std::swap(q[1], q[3]);
          result_.triangles.push_back({q[0], q[1], q[2]});
          result_.triangles.push_back({q[0], q[2], q[3]});
        }
      }
    }
  }

  const Crossing* middle_hit(int axis, int i, int j, int k) const {
    const double low = coordinate(axis, k);
    const Crossing* best = nullptr;
    for (const Crossing& c : lines_.at({axis, i, j})) {
      if (c.at < low || c.at > low + step_) continue;
      const auto off = [&](const Crossing& x) { return std::abs(x.at - low - step_ / 2); };
      if (best == nullptr || off(c) < off(*best)) best = &c;
    }
    return best;
  }

  Index vertex_of(const Place& cell, const Vec3& point, const Vec3& normal) {
    const auto number = static_cast<Index>(planes_.size());
    const auto [entry, added] = vertices_.emplace(cell, number);
    if (added) planes_.emplace_back();
    planes_[entry->second].emplace_back(point, normal);
    return entry->second;
  }

  void place_vertices() {
    result_.positions.resize(planes_.size());
    for (const auto& [cell, number] : vertices_) {
      Vec3 mean = Vec3::Zero();
      for (const auto& [point, normal] : planes_[number]) mean += point;
      mean /= static_cast<double>(planes_[number].size());
      Eigen::Matrix3d a = 1e-3 * Eigen::Matrix3d::Identity();  // towards the mean where flat
      Vec3 b = Vec3::Zero();
      for (const auto& [point, normal] : planes_[number]) {
        a += normal * normal.transpose();
        b += normal * normal.dot(point - mean);
      }
      Vec3 x = mean + a.ldlt().solve(b);
      for (int k = 0; k < 3; ++k) {
        x[k] = std::clamp(x[k], coordinate(k, cell[k]), coordinate(k, cell[k] + 1));
      }
      result_.positions[number] = x;
    }
  }

  const Mesh& mesh_;
  Vec3 min_;
  double step_;
  int n_;
  std::map<std::array<int, 3>, std::vector<Crossing>> lines_;
  std::map<Place, Index> vertices_;
  std::vector<std::vector<std::pair<Vec3, Vec3>>> planes_;
  Mesh result_;
};

}  // namespace

Mesh signs_only_contour(const Mesh& mesh, const Box& box, int n) {
  return Contour(mesh, box, n).run();
}

}  // namespace kdm::check
