// SPDX-License-Identifier: MIT
// Where vertices go, on hand-made rings: flat ones, ridges and corners, in leaves of every size,
// with the best place inside and outside of the leaf, exact and with noise.
#include "extract/place/vertex_position.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numeric>

#include "geometry/quadric.h"
#include "kdmanifold/build.h"
#include "support/mesh_assert.h"
#include "support/random.h"
#include "support/shapes.h"

namespace kdm {
namespace {

using check::Random;

constexpr std::array<VertexPosition, 2> kPositions{VertexPosition::kConstrained,
                                                   VertexPosition::kProjection};
// Of a leaf, in lattice steps: the least that can be split again, the usual, all there is.
constexpr std::array<std::int32_t, 4> kSizes{2, 64, 1 << 13, kLatticeSize};

// A leaf and the hits of one loop, whose planes run through a common point.
struct Ring {
  LatticeBox box;
  GridData grid;
  std::vector<Vec3> points;
  std::vector<Index> hits;

  Ring(std::int32_t size, Random& random) {
    for (int k = 0; k < 3; ++k) {
      const auto room = static_cast<std::uint32_t>(kLatticeSize - size + 1);
      box.lo[k] = static_cast<std::int32_t>(random.below(room));
      box.hi[k] = box.lo[k] + size;
    }
  }
  double size() const { return box.hi[0] - box.lo[0]; }
  Vec3 at(const Vec3& fraction) const { return to_vec3(box.lo) + size() * fraction; }
  void add(const Vec3& point, const Vec3& normal, const Vec3& through) {
    const Vec3 unit = normal.normalized();
    hits.push_back(static_cast<Index>(hits.size()));
    points.push_back(point);
    grid.hits.push_back(Hit(0, hits.back(), true, false));
    grid.planes.push_back({unit, unit.dot(through)});
  }
  Vec3 mass_point() const {
    const Vec3 sum = std::accumulate(points.begin(), points.end(), Vec3(Vec3::Zero()));
    return sum / static_cast<double>(points.size());
  }
  double error(const Vec3& x) const {
    double sum = 0;
    for (const Plane& p : grid.planes) {
      const double distance = p.normal.dot(x) - p.offset;
      sum += distance * distance;
    }
    return sum;
  }
  Vec3 vertex(VertexPosition position) const {
    return vertex_position({grid, {}, points}, hits, box, position);
  }
  bool holds(const Vec3& x) const {
    return (x.array() >= to_vec3(box.lo).array()).all() &&
           (x.array() <= to_vec3(box.hi).array()).all();
  }
};

// `rank` different planes, two hits each, through the point at `fraction` of the leaf; the normals
// are off by `noise`.
Ring ring(int rank, std::int32_t size, const Vec3& fraction, double noise, Random& random) {
  Ring made(size, random);
  const Eigen::Matrix3d frame =
      Eigen::AngleAxisd(random.between(0, 3), random.direction()).toRotationMatrix();
  for (int i = 0; i < 2 * rank; ++i) {
    const Vec3 normal = frame.col(i / 2) + noise * random.direction();
    made.add(made.at(random.point(0, 1)), normal, made.at(fraction));
  }
  return made;
}

TEST(VertexPositions, FlatRidgeAndCornerRingsInLeavesOfEverySize) {
  Random random(1);
  for (const std::int32_t size : kSizes) {
    for (int round = 0; round < 300; ++round) {
      const int rank = 1 + round % 3;
      const Vec3 fraction = random.point(0.2, 0.8);
      const Ring made = ring(rank, size, fraction, 0, random);
      for (const VertexPosition position : kPositions) {
        SCOPED_TRACE(testing::Message() << "size " << size << " rank " << rank);
        const Vec3 x = made.vertex(position);
        ASSERT_TRUE(made.holds(x));
        if (rank == 3) {
          // A corner is met exactly.
          ASSERT_LE((x - made.at(fraction)).norm(), 1e-9 * (size + 1));
          continue;
        }
        // Elsewhere the vertex lies on the planes and, if the leaf has room, below the hits' mean.
        const Vec3 foot = x - made.mass_point();
        Vec3 along = foot;
        for (int k = 0; k < rank; ++k) {
          const Vec3& n = made.grid.planes[static_cast<std::size_t>(2 * k)].normal;
          along -= n * n.dot(foot);
        }
        const bool inside = (x.array() > to_vec3(made.box.lo).array()).all() &&
                            (x.array() < to_vec3(made.box.hi).array()).all();
        if (!inside) continue;
        ASSERT_LE(made.error(x), 1e-18 * (size + 1.0) * (size + 1.0));
        ASSERT_LE(along.norm(), 1e-9 * (size + 1));
      }
    }
  }
}

// A loop passes a hit again where the leaves beside its edge are split further.
TEST(VertexPositions, HitsOfCoincidentEdgesCountOnce) {
  Random random(5);
  for (int round = 0; round < 100; ++round) {
    Ring made(64, random);
    for (int i = 0; i < 4; ++i) {  // on a curved face: no point lies on all planes
      const Vec3 point = made.at(random.point(0.2, 0.8).cwiseProduct(Vec3(1, 1, 0.5)));
      made.add(point, Vec3(0, 0, 1) + 0.5 * random.direction(), point);
    }
    std::array<Vec3, 2> expected;
    for (int i = 0; i < 2; ++i) expected[i] = made.vertex(kPositions[i]);
    // The second hit once more, the first at both ends of the loop.
    made.grid.hits.insert(made.grid.hits.end(), {made.grid.hits[1], made.grid.hits[0]});
    made.points.insert(made.points.end(), {made.points[1], made.points[0]});
    made.hits = {0, 1, 4, 2, 3, 5};
    for (int i = 0; i < 2; ++i) {
      EXPECT_LE((made.vertex(kPositions[i]) - expected[i]).norm(), 1e-9);
    }
    made.points[4] = made.at(random.point(0, 1));
    EXPECT_GT((made.vertex(kPositions[0]) - expected[0]).norm(), 1e-6) << "another hit";
  }
  Ring flat(64, random);
  for (int i = 0; i < 2; ++i)
    flat.add(flat.at(Vec3(0.5, 0.5, 0.5)), Vec3(0, 0, 1), flat.at(Vec3(0, 0, 0.5)));
  flat.grid.hits[1] = flat.grid.hits[0];
  EXPECT_EQ(flat.vertex(kPositions[0]), flat.points[0]) << "all are one";
}

// Noise in the normals moves the vertex by as much of the leaf, and not by the inverse: a flat ring
// does not become a corner.
TEST(VertexPositions, NoiseDoesNotMakeFeatures) {
  Random random(2);
  for (const std::int32_t size : kSizes) {
    for (const double noise : {0.0, 1e-12, 1e-6, 1e-3, 0.02}) {
      for (int round = 0; round < 150; ++round) {
        const Vec3 fraction(0.5, 0.4, 0.6);
        const Ring made = ring(1 + round % 3, size, fraction, noise, random);
        for (const VertexPosition position : kPositions) {
          SCOPED_TRACE(testing::Message() << "size " << size << " noise " << noise);
          const Vec3 x = made.vertex(position);
          ASSERT_TRUE(made.holds(x));
          // All planes meet at this point: no vertex is further from the mean of the hits.
          const double furthest = (made.at(fraction) - made.mass_point()).norm();
          ASSERT_LE((x - made.mass_point()).norm(),
                    furthest * (1 + 3 * noise) + (1e-9 + 2 * noise) * size);
        }
      }
    }
  }
}

// The same ring in a leaf of another size gives the same place in it.
TEST(VertexPositions, TheSizeOfTheLeafDoesNotMatter) {
  for (int round = 0; round < 200; ++round) {
    for (const VertexPosition position : kPositions) {
      std::vector<Vec3> places;
      for (const std::int32_t size : kSizes) {
        Random random(static_cast<std::uint32_t>(round));
        const int rank = 1 + round % 3;
        const double noise = round % 2 == 0 ? 0 : 0.3;
        const Vec3 fraction = random.point(-0.5, 1.5);
        Ring made(size, random);  // takes as many random numbers whatever the size
        made.box = {{0, 0, 0}, {size, size, size}};
        for (int i = 0; i < 2 * rank; ++i) {
          Vec3 normal = Vec3::Unit(i / 2) + 0.2 * Vec3::Ones() + noise * random.direction();
          made.add(made.at(random.point(0, 1)), normal, made.at(fraction));
        }
        places.push_back((made.vertex(position) - to_vec3(made.box.lo)) / size);
      }
      for (const Vec3& place : places) ASSERT_LE((place - places[0]).norm(), 1e-9) << round;
    }
  }
}

TEST(VertexPositions, OutsideTheLeafOneIsTheBestTheOtherTheNearest) {
  Random random(4);
  int different = 0;
  for (const std::int32_t size : kSizes) {
    for (int round = 0; round < 300; ++round) {
      // The corner lies outside; planes are not perpendicular, so the two ways differ.
      Vec3 fraction = random.point(0, 1);
      fraction[static_cast<int>(random.below(3))] = random.coin() ? -0.4 : 1.3;
      Ring made(size, random);
      const Vec3 main = random.direction();
      for (int i = 0; i < 4; ++i) {
        made.add(made.at(random.point(0, 1)), main + 0.9 * random.direction(), made.at(fraction));
      }
      const Vec3 best = made.vertex(VertexPosition::kConstrained);
      const Vec3 nearest = made.vertex(VertexPosition::kProjection);
      ASSERT_TRUE(made.holds(best) && made.holds(nearest));
      const double slack = 1e-3 * size * size;  // ties are broken by distance to the hits
      ASSERT_LE(made.error(best), made.error(nearest) + slack);
      PrimalQuadric quadric(made.mass_point());
      for (const Plane& p : made.grid.planes) quadric.add(p);
      const Vec3 free = quadric.minimiser();
      ASSERT_LE(
          (nearest - free.cwiseMax(to_vec3(made.box.lo)).cwiseMin(to_vec3(made.box.hi))).norm(), 0);
      different += (best - nearest).norm() > 0.01 * size ? 1 : 0;
    }
  }
  EXPECT_GT(different, 600);
}

TEST(VertexPositions, BothGiveManifolds) {
  for (const Mesh& mesh : {shapes::rotated(shapes::torus(1, 0.4, 24, 12), Vec3(1, 2, 3), 1),
                           shapes::rotated(shapes::thin_walled_box(0.02), Vec3(3, 1, 2), 1)}) {
    const Grid grid = build_grid(mesh, {.strategy = SplitStrategy::kUniform, .depth = 9});
    const ExtractedMesh best = extract(grid);
    const ExtractedMesh nearest = extract(grid, {.position = VertexPosition::kProjection});
    EXPECT_TRUE(check::is_two_manifold(best));
    EXPECT_TRUE(check::is_two_manifold(nearest));
    EXPECT_NE(best.positions, nearest.positions);
  }
}

}  // namespace
}  // namespace kdm
