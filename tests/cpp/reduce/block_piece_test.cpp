// SPDX-License-Identifier: MIT
#include "reduce/block_piece.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "mesh/boxes.h"
#include "reduce/reference.h"
#include "reduce/true_creases.h"
#include "support/shapes.h"

namespace kdm {
namespace {

constexpr double kAllowed = 0.02;

// A ball that is kept within a distance of itself.
struct KeptBall {
  Mesh mesh = shapes::jittered(shapes::icosphere(4), 0.002, 3);
  ScaledMesh scaled{mesh.positions, mesh.triangles, {}, {}, {}};
  Reference reference{scaled.all_corners()};
  Workpiece piece{HalfEdges(mesh.triangles, static_cast<Index>(mesh.positions.size())),
                  mesh.positions, distance()};

  KeptDistance distance() const {
    Samples samples(static_cast<Index>(mesh.triangles.size()));
    std::vector<TriangleId> near(mesh.positions.size(), kNone);
    for (TriangleId t = 0; t < mesh.triangles.size(); ++t) {
      for (const Index v : mesh.triangles[t]) {
        if (near[v] == kNone) samples.add(mesh.positions[v], t, t);
        near[v] = t;
      }
    }
    return {&reference,      std::move(samples),
            kAllowed,        std::vector<double>(mesh.positions.size(), kAllowed),
            std::move(near), std::make_shared<TrueCreases>(scaled, 0.01)};
  }

  std::vector<SpaceBlock> blocks(double below) const {
    std::vector<Box> boxes(piece.mesh.triangles());
    for (TriangleId t = 0; t < boxes.size(); ++t) {
      if (piece.mesh.is_removed(t)) continue;
      const Triangle c = piece.mesh.corners(t);
      boxes[t] = box_of(piece.positions[c[0]], piece.positions[c[1]], piece.positions[c[2]]);
    }
    return cut_space(boxes, 700, below);
  }
};

void reduce_block(KeptBall& ball, CollapseState& state, const SpaceBlock& block) {
  BlockPiece part(ball.piece, state, block);
  part.collapse([](Index) {});
  EXPECT_EQ(part.gone(), 2 * part.collapses());
  part.put_back(ball.piece, state);
  ball.piece.mesh.count_removed(part.gone());
}

TEST(BlockPiece, ChangesNothingBeyondItsBox) {
  KeptBall ball;
  const KeptBall before;
  CollapseState state = first_state(ball.piece);
  const SpaceBlock block = ball.blocks(0.5).front();
  reduce_block(ball, state, block);
  Index gone = 0;
  for (TriangleId t = 0; t < ball.piece.mesh.triangles(); ++t) {
    const Triangle corners = before.piece.mesh.corners(t);
    bool inside = true;
    for (const VertexId v : corners) inside = inside && holds(block.box, before.mesh.positions[v]);
    if (ball.piece.mesh.is_removed(t)) ++gone;
    EXPECT_TRUE(inside || ball.piece.mesh.corners(t) == corners) << t;
  }
  EXPECT_GT(gone, 200u);
  for (VertexId v = 0; v < ball.mesh.positions.size(); ++v) {
    const Vec3& now = ball.piece.positions[v];
    const bool inside = holds(block.box, before.mesh.positions[v]);
    EXPECT_TRUE(inside ? holds(block.box, now) : now == before.mesh.positions[v]);
  }
}

// A mesh made anew of the triangles that are left has the same neighbours and shapes.
void expect_sound(const Workpiece& piece) {
  std::vector<Triangle> triangles;
  std::vector<TriangleId> numbers;
  for (TriangleId t = 0; t < piece.mesh.triangles(); ++t) {
    if (piece.mesh.is_removed(t)) continue;
    triangles.push_back(piece.mesh.corners(t));
    numbers.push_back(t);
  }
  ASSERT_EQ(triangles.size(), piece.mesh.living_triangles());
  const HalfEdges anew(triangles, piece.mesh.vertices());
  for (SideId h = 0; h < 3 * triangles.size(); ++h) {
    const SideId back = anew.opposite(h);
    EXPECT_EQ(piece.mesh.opposite(3 * numbers[triangle_of(h)] + corner_of(h)),
              3 * numbers[triangle_of(back)] + corner_of(back));
  }
  for (VertexId v = 0; v < piece.mesh.vertices(); ++v) {
    EXPECT_EQ(piece.mesh.leaving(v) == kNone, anew.leaving(v) == kNone);
    if (piece.mesh.leaving(v) == kNone) {
      EXPECT_NE(piece.joined_to[v], kNone);
    } else {
      EXPECT_EQ(piece.mesh.start(piece.mesh.leaving(v)), v);
    }
  }
  for (const TriangleId t : numbers) {
    const Triangle c = piece.mesh.corners(t);
    EXPECT_EQ(
        piece.faces[t].normal,
        face_shape(piece.positions[c[0]], piece.positions[c[1]], piece.positions[c[2]]).normal);
  }
}

TEST(BlockPiece, PutsBackASoundMesh) {
  KeptBall ball;
  CollapseState state = first_state(ball.piece);
  for (const double below : {0.5, 0.3}) {
    const Index before = ball.piece.mesh.living_triangles();
    for (const SpaceBlock& block : ball.blocks(below)) reduce_block(ball, state, block);
    EXPECT_LT(ball.piece.mesh.living_triangles(), 0.9 * before);
    expect_sound(ball.piece);
  }
}

// Nothing that was tried in a block is tried again, and points that are to stay near are not lost:
// a collapser that goes on finds little to do, and keeps the distance.
TEST(BlockPiece, LeavesLittleToDo) {
  KeptBall ball;
  CollapseState state = first_state(ball.piece);
  Index in_blocks = 0;
  for (const double below : {0.5, 0.3}) {
    for (const SpaceBlock& block : ball.blocks(below)) {
      const Index before = ball.piece.mesh.living_triangles();
      reduce_block(ball, state, block);
      in_blocks += before - ball.piece.mesh.living_triangles();
    }
  }
  EXPECT_GT(state.failed.count(), 100u);
  ball.piece.guard.emplace(ball.piece.mesh, ball.piece.positions);
  Collapser collapser(ball.piece, state);
  collapser.collapse_to(0, [] {});
  EXPECT_LT(collapser.collapses(), in_blocks / 4);
  expect_sound(ball.piece);
  std::vector<std::array<Vec3, 3>> left;
  for (TriangleId t = 0; t < ball.piece.mesh.triangles(); ++t) {
    if (ball.piece.mesh.is_removed(t)) continue;
    const Triangle c = ball.piece.mesh.corners(t);
    left.push_back(
        {ball.piece.positions[c[0]], ball.piece.positions[c[1]], ball.piece.positions[c[2]]});
  }
  const Reference surface(std::move(left));
  for (const Vec3& p : ball.mesh.positions) {
    TriangleId hint = kNone;
    EXPECT_TRUE(surface.is_near(p, kAllowed * (1 + 1e-9), hint));
  }
}

}  // namespace
}  // namespace kdm
