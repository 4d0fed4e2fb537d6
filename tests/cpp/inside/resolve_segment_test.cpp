// SPDX-License-Identifier: MIT
// Stretches of grid edges whose crossings do not fit: what is kept, turned, dropped, invented.
#include "inside/resolve_segment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "inside/winding_field.h"
#include "prepare/surface.h"
#include "support/random.h"
#include "support/shapes.h"

namespace kdm {
namespace {

constexpr std::int32_t kMiddle = kLatticeSize / 2;

// The box that the unit cube fills on the lattice, without its faces up the z axis if `open`.
struct Cube {
  explicit Cube(bool open) {
    Mesh mesh = shapes::cube();
    if (open) {
      std::erase_if(mesh.triangles, [&](const Triangle& t) {
        return mesh.positions[t[0]][2] + mesh.positions[t[1]][2] + mesh.positions[t[2]][2] == 3;
      });
    }
    triangles = prepare_surface(mesh, {.inside = InsideRule::kSheet}).triangles;
  }
  std::vector<LatticeTriangle> triangles;
};

// A line through the cube along z; the crossings that exist, found as construction does.
class Line {
 public:
  Line(const std::vector<LatticeTriangle>& triangles, std::int32_t x, std::int32_t y)
      : field_(triangles, 0.5, 64), segment_{2, {x, y, 0}, kLatticeSize, false, false} {
    for (Index i = 0; i < triangles.size(); ++i) {
      const int sign = line_crosses(triangles[i], 2, x, y);
      if (sign == 0) continue;
      crossings_.push_back({crossing_position(triangles[i], 2, x, y), i, sign > 0});
    }
  }

  std::string resolve(bool invent = true) {
    std::vector<ClassifiedCrossing> classified;
    SegmentResolver(field_, 1.0 / 16).resolve(segment_, crossings_, invent, classified);
    std::string text;
    LinePosition last = 0;
    for (const ClassifiedCrossing& c : classified) {
      EXPECT_GE(c.position(), last);
      last = c.position();
      if (!c.kept()) continue;
      text += c.leaving() ? '>' : '<';
      if (c.triangle() == kNone) text += "new";
      positions.push_back(real_position(c.position()));
    }
    return text;
  }

  Segment& segment() { return segment_; }
  std::vector<Crossing>& crossings() { return crossings_; }
  std::vector<double> positions;

 private:
  WindingField field_;
  Segment segment_;
  std::vector<Crossing> crossings_;
};

TEST(ResolveSegment, WhatFitsIsKept) {
  const Cube cube(false);
  EXPECT_EQ(Line(cube.triangles, kMiddle, kMiddle + 9).resolve(), "<>");
  EXPECT_EQ(Line(cube.triangles, 9, kMiddle).resolve(), "");
}

TEST(ResolveSegment, AHoleGetsAHit) {
  const Cube cube(true);
  Line line(cube.triangles, kMiddle, kMiddle + 9);
  EXPECT_EQ(line.resolve(), "<>new");
  // Seen from the middle of the missing face half of the surroundings are surface, so that is where
  // the winding number is one half.
  EXPECT_NEAR(line.positions[1], kLatticeSize - kLatticeMargin, 1);
  EXPECT_EQ(Line(cube.triangles, kMiddle, kMiddle + 9).resolve(false), "<");
}

TEST(ResolveSegment, ATurnedFaceIsTurnedBack) {
  Cube cube(false);
  // One triangle of the upper side turned: the other one and the sides outvote it.
  for (LatticeTriangle& t : cube.triangles) {
    if (line_crosses(t, 2, kMiddle, kMiddle / 2) > 0) std::swap(t[1], t[2]);
  }
  Line line(cube.triangles, kMiddle, kMiddle / 2 - kMiddle / 4);
  ASSERT_EQ(line.crossings().size(), 2u);
  EXPECT_EQ(line.crossings()[0].leaving, line.crossings()[1].leaving);
  const std::string found = line.resolve();
  EXPECT_EQ(found[0], '<');
  EXPECT_EQ(std::count(found.begin(), found.end(), '<'),
            std::count(found.begin(), found.end(), '>'));
}

TEST(ResolveSegment, ADoubledFaceIsOneHit) {
  Cube cube(false);
  const std::vector<LatticeTriangle> once = cube.triangles;
  cube.triangles.insert(cube.triangles.end(), once.begin(), once.end());
  Line line(cube.triangles, kMiddle, kMiddle + 9);
  EXPECT_EQ(line.crossings().size(), 4u);
  EXPECT_EQ(line.resolve(), "<>");
}

// A field that is inside below a height, and counts how often it is asked.
class Slope final : public PointField {
 public:
  Slope(double height, bool smooth) : height_(height), smooth_(smooth) {}

  bool inside(const Vec3& p) const override { return excess(p) > 0; }
  bool inside(const LatticePoint& p) const override { return inside(to_vec3(p)); }
  double excess(const Vec3& p) const override {
    ++asked;
    const double depth = (height_ - p[2]) / kLatticeSize;
    if (!smooth_) return depth > 0 ? 1 : -1;
    return depth / (1 + 3 * std::abs(depth));
  }
  Vec3 gradient(const Vec3& p) const override {
    static_cast<void>(p);
    return -Vec3::UnitZ();
  }
  std::size_t work() const override { return 0; }

  mutable int asked = 0;

 private:
  double height_;
  bool smooth_;
};

// About 24 halvings lead from the segment to the precision; of a field that changes smoothly about
// half as many questions do.
TEST(ResolveSegment, ASmoothFieldIsAskedFewTimes) {
  check::Random random(6);
  for (int trial = 0; trial < 200; ++trial) {
    const double height = random.between(1, kLatticeSize - 1);
    for (const bool smooth : {false, true}) {
      const Slope field(height, smooth);
      std::vector<Crossing> none;
      std::vector<ClassifiedCrossing> found;
      const Segment segment{2, {kMiddle, kMiddle, 0}, kLatticeSize, true, false};
      SegmentResolver(field, 1.0 / 16).resolve(segment, none, true, found);
      ASSERT_EQ(found.size(), 1u);
      EXPECT_NEAR(real_position(found[0].position()), height, 1.0 / 16);
      EXPECT_LE(field.asked, smooth ? 14 : 26);
    }
  }
}

// Whatever the crossings and the ends are, the result alternates, fits them and ascends.
TEST(ResolveSegment, EveryResultFits) {
  check::Random random(5);
  const Cube cube(true);
  for (int trial = 0; trial < 300; ++trial) {
    Line line(cube.triangles, kMiddle, kMiddle + 9);
    Segment& segment = line.segment();
    segment.low[2] = static_cast<std::int32_t>(random.below(kLatticeSize - 8));
    const std::uint32_t longest =
        trial % 2 == 0 ? 4 : static_cast<std::uint32_t>(kLatticeSize - segment.low[2]);
    segment.high = segment.low[2] + 1 + static_cast<std::int32_t>(random.below(longest));
    segment.inside_low = random.coin();
    segment.inside_high = random.coin();
    line.crossings().clear();
    const auto length = static_cast<std::uint32_t>(segment.high - segment.low[2]);
    for (std::uint32_t i = random.below(6); i > 0; --i) {
      const LinePosition base =
          (static_cast<LinePosition>(segment.low[2]) << kFractionBits) +
          (trial % 3 == 0 ? random.below(100) : random.below(length << kFractionBits));
      line.crossings().push_back({base, random.below(10), random.coin()});
    }
    const std::string found = line.resolve();
    bool inside = segment.inside_low;
    for (std::size_t i = 0; i < line.positions.size(); ++i) {
      EXPECT_GE(line.positions[i], segment.low[2]);
      EXPECT_LT(line.positions[i], segment.high);
      if (i > 0) {
        EXPECT_GT(line.positions[i], line.positions[i - 1]);
      }
    }
    for (const char c : found) {
      if (c != '<' && c != '>') continue;
      EXPECT_EQ(c == '>', inside);
      inside = !inside;
    }
    EXPECT_EQ(inside, segment.inside_high) << trial;
  }
}

}  // namespace
}  // namespace kdm
