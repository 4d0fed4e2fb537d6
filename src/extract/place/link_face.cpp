// SPDX-License-Identifier: MIT
// Finds the minimal face that a link passes through.
#include "extract/place/link_face.h"

#include <algorithm>

#include "extract/dual/clearance.h"

namespace kdm {
namespace {

// A vertex keeps off the sides of its face by at most this fraction of the face's size.
constexpr double kSideMargin = 1.0 / 64;

}  // namespace

std::optional<LinkFace> face_between(const LatticeBox& first, const LatticeBox& second) {
  LinkFace face{};
  int flat = 0;
  for (int i = 0; i < 3; ++i) {
    face.lo[i] = std::max(first.lo[i], second.lo[i]);
    face.hi[i] = std::min(first.hi[i], second.hi[i]);
    if (face.lo[i] < face.hi[i]) continue;
    face.axis = i;
    ++flat;
  }
  return flat == 1 ? std::optional(face) : std::nullopt;
}

Vec3 off_sides(const LinkFace& face, const Vec3& point, double margin) {
  const Vec3 off = (kSideMargin * (face.hi - face.lo)).cwiseMin(margin);
  return point.cwiseMax(face.lo + off).cwiseMin(face.hi - off);
}

bool within(const LinkFace& face, const Vec3& point) {
  for (int i = 0; i < 3; ++i) {
    if (i == face.axis) continue;
    if (!(point[i] > face.lo[i] + kClear && point[i] < face.hi[i] - kClear)) return false;
  }
  return true;
}

}  // namespace kdm
