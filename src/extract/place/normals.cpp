// SPDX-License-Identifier: MIT
// Computes normals at the corners of the triangles, for shading.
#include "extract/place/normals.h"

#include <algorithm>
#include <cmath>

#include "mesh/marks.h"

namespace kdm {
namespace {

// Normals of flat parts differ by rounding; faces that meet at just the crease angle stay smooth.
constexpr double kSlack = 1e-9;

// Grows with the angle between a and b, nearly as the angle does, but needs a square root only.
double sine_of_half_angle(const Vec3& a, const Vec3& b) {
  const double lengths = std::sqrt(a.squaredNorm() * b.squaredNorm());
  if (!(lengths > 0)) return 0;
  const double cosine = std::min(std::max(a.dot(b) / lengths, -1.0), 1.0);
  return std::sqrt((1 - cosine) / 2);
}

class CornerNormals {
 public:
  CornerNormals(const DualMesh& mesh, std::span<const Vec3> face_normals, double crease_cosine)
      : mesh_(mesh),
        face_normals_(face_normals),
        limit_(crease_cosine - kSlack),
        normals_(mesh.opposite.size(), Vec3::Zero()),
        done_(mesh.opposite.size()) {}

  std::vector<Vec3> run() {
    for (Index h = 0; h < mesh_.opposite.size(); ++h) {
      if (done_.test(h) || mesh_.dropped(h / 3)) continue;
      collect_fan(h);
      divide_fan();
    }
    return std::move(normals_);
  }

 private:
  const Vec3& face_normal(Index half_edge) const { return face_normals_[half_edge / 3]; }

  // The half-edges that start in one vertex; each runs along the link to the next one's triangle.
  // On the boundary they are a chain from one side to the other.
  void collect_fan(Index any) {
    fan_.clear();
    const Index v = mesh_.vertex[any];
    chain_ = mesh_.on_boundary(v);
    for (const HalfEdgeId h : mesh_.ring_from(chain_ ? mesh_.first_half_edge[v] : any)) {
      fan_.push_back(h);
      done_.set(h);
    }
  }

  void divide_fan() {
    const auto crease_before = [&](std::size_t i) {
      if (i == 0 && chain_) return true;
      const Index before = fan_[i == 0 ? fan_.size() - 1 : i - 1];
      return face_normal(before).dot(face_normal(fan_[i])) < limit_;
    };
    std::size_t first = 0;
    while (first < fan_.size() && !crease_before(first)) ++first;
    if (first < fan_.size()) {
      std::rotate(fan_.begin(), fan_.begin() + static_cast<std::ptrdiff_t>(first), fan_.end());
    }
    std::size_t begin = 0;
    for (std::size_t end = 1; end <= fan_.size(); ++end) {
      if (end < fan_.size() && !crease_before(end)) continue;
      average(begin, end);
      begin = end;
    }
  }

  void average(std::size_t begin, std::size_t end) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3& apex = mesh_.position[mesh_.vertex[fan_[i]]];
      const Vec3& next = mesh_.position[mesh_.vertex[next_in_triangle(fan_[i])]];
      const Vec3& previous = mesh_.position[mesh_.vertex[previous_in_triangle(fan_[i])]];
      sum += sine_of_half_angle(next - apex, previous - apex) * face_normal(fan_[i]);
    }
    // Corners without an angle, or normals that cancel, leave nothing to average.
    constexpr double kNothing = 1e-6;
    const double length = sum.norm();
    for (std::size_t i = begin; i < end; ++i) {
      normals_[fan_[i]] = length > kNothing ? (sum / length).eval() : face_normal(fan_[i]);
    }
  }

  const DualMesh& mesh_;
  std::span<const Vec3> face_normals_;
  double limit_;
  std::vector<Vec3> normals_;
  Marks done_;  // per half-edge
  std::vector<Index> fan_;
  bool chain_ = false;  // the fan ends at the boundary on both sides
};

}  // namespace

double cosine_of_degrees(double degrees) {
  if (degrees > 90) return -cosine_of_degrees(180 - degrees);
  if (degrees == 90) return 0;
  constexpr double kPi = 3.14159265358979323846;
  const double x = degrees * (kPi / 180);
  // Taylor's series; the first term left out is below 1e-18.
  double sum = 1;
  double term = 1;
  for (int k = 2; k <= 22; k += 2) {
    term *= -x * x / (k * (k - 1));
    sum += term;
  }
  return sum;
}

std::vector<Vec3> corner_normals(const DualMesh& mesh, std::span<const Vec3> face_normals,
                                 double crease_cosine) {
  return CornerNormals(mesh, face_normals, crease_cosine).run();
}

std::vector<Vec3> corner_normals(const GridData& grid, const DualMesh& mesh, double crease_cosine) {
  std::vector<Vec3> face_normals;
  face_normals.reserve(mesh.triangles());
  for (const HitId hit : mesh.hit) face_normals.push_back(grid.plane_of(hit).normal);
  return corner_normals(mesh, face_normals, crease_cosine);
}

}  // namespace kdm
