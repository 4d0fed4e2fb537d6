// SPDX-License-Identifier: MIT
// Draws a solid of a kind and puts it somewhere: as it is, moved and scaled, or turned as well.
#include "truth/solid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "truth/parts.h"

namespace kdm::truth {
namespace {

struct Kind {
  std::string name;
  Solid (*make)(Random& random);
};

const std::vector<Kind>& makers() {
  static const std::vector<Kind> list = {
      {"touching", make_touching}, {"coincident", make_coincident},
      {"nested", make_nested},     {"overlapping", make_overlapping},
      {"thin", make_thin},         {"inverted", make_inverted},
      {"doubled", make_doubled},   {"open", make_open},
      {"torn", make_torn},         {"voxels", make_voxels},
      {"spun", make_spun},         {"wire", make_wire},
      {"sound", make_sound},       {"expression", make_expression},
  };
  return list;
}

Eigen::Matrix3d random_rotation(Random& random) {
  // The direction and the angle's half by a random point of the 4-D sphere; no libm but sqrt.
  for (;;) {
    const Vec3 p = random.point(-1, 1);
    const double w = random.between(-1, 1);
    const double length = p.squaredNorm() + w * w;
    if (length < 0.01 || length > 1) continue;
    const double by = 1 / std::sqrt(length);
    return Eigen::Quaterniond(w * by, p.x() * by, p.y() * by, p.z() * by).toRotationMatrix();
  }
}

// Prisms that are no boxes, by a shear that is not too steep.
Eigen::Matrix3d random_shear(Random& random) {
  Eigen::Matrix3d shear = Eigen::Matrix3d::Identity();
  shear(0, 1) = random.between(-0.5, 0.5);
  shear(0, 2) = random.between(-0.5, 0.5);
  shear(1, 2) = random.between(-0.5, 0.5);
  return shear;
}

void put_somewhere(Solid& solid, Random& random) {
  const std::uint32_t draw = random.below(6);
  solid.pose = draw < 2 ? "plain" : draw < 3 ? "moved" : "turned";
  if (draw < 2) return;
  const double scale = spread(random, -10, 10);
  Eigen::Matrix3d by = Eigen::Matrix3d::Identity();
  if (draw >= 3) by = random_rotation(random);
  if (draw == 5) by = by * random_shear(random);
  by *= scale;
  const Vec3 to = random.point(-10, 10) * scale;
  const auto put = [&](Mesh& mesh) {
    for (Vec3& p : mesh.positions) p = by * p + to;
  };
  put(solid.input);
  put(solid.account.boundary);
  std::for_each(solid.operands.begin(), solid.operands.end(), put);
  solid.account.volume *= by.determinant();
  solid.tolerance *= scale;
  solid.slack *= 1.5 * scale;  // a shear may stretch
  if (draw >= 3) solid.account.topology.any_of.insert(solid.apart.begin(), solid.apart.end());
}

}  // namespace

const std::vector<std::string>& kinds() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Kind& kind : makers()) list.push_back(kind.name);
    return list;
  }();
  return names;
}

Solid make_solid(const std::string& kind, std::uint32_t seed) {
  for (std::size_t i = 0; i < makers().size(); ++i) {
    if (makers()[i].name != kind) continue;
    Random random(seed * 64 + static_cast<std::uint32_t>(i));
    Solid solid = makers()[i].make(random);
    put_somewhere(solid, random);
    // Files of facets have three vertices a triangle.
    if (random.below(4) == 0) solid.input = taken_apart(solid.input);
    return solid;
  }
  throw std::out_of_range("no kind '" + kind + "'");
}

}  // namespace kdm::truth
