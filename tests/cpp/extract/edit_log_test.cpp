// SPDX-License-Identifier: MIT
// What is noted of edits comes back, and what is taken back is forgotten.
#include "extract/dual/edit_log.h"

#include <gtest/gtest.h>

#include "extract/dual/edit.h"
#include "support/dual_mesh_shapes.h"

namespace kdm {
namespace {

TEST(EditLog, KnowsNothingOfWhatWasNotNoted) {
  const EditLog log;
  EXPECT_FALSE(log.edited(7));
  EXPECT_FALSE(log.was_split(7));
  EXPECT_EQ(log.links_inside_face(7), 0);
  EXPECT_TRUE(log.touched_hits().empty());
  EXPECT_EQ(log.flips(), 0u);
}

TEST(EditLog, EditedHitsAreTouchedAndDividedOnesAreNotEdited) {
  EditLog log;
  log.note_edited(5);
  log.note_divided(2);
  log.note_edited(5);
  EXPECT_TRUE(log.edited(5));
  EXPECT_FALSE(log.edited(2));
  EXPECT_FALSE(log.edited(4));
  EXPECT_EQ(log.touched_hits(), (std::vector<HitId>{5, 2, 5}));
  log.forget_touched();
  EXPECT_TRUE(log.touched_hits().empty());
  EXPECT_TRUE(log.edited(5)) << "as long as its triangles are not taken back";
  log.forget_edits(5);
  log.forget_edits(100);
  EXPECT_FALSE(log.edited(5));
}

TEST(EditLog, SplitLoopsAreKeptUntilTheyAreTakenBack) {
  EditLog log;
  log.note_split(3);
  EXPECT_TRUE(log.was_split(3));
  EXPECT_FALSE(log.was_split(2));
  log.forget_split(3);
  log.forget_split(50);
  EXPECT_FALSE(log.was_split(3));
}

TEST(EditLog, EachHalfEdgeOfAHitHasItsBit) {
  EditLog log;
  log.note_link(3 * 4 + 1, true);
  log.note_link(3 * 4 + 2, true);
  EXPECT_EQ(log.links_inside_face(4), 0b110);
  log.note_link(3 * 4 + 1, false);
  EXPECT_EQ(log.links_inside_face(4), 0b100);
  EXPECT_EQ(log.links_inside_face(3), 0);
}

TEST(EditLog, AddedVerticesCountByPassWhileTheyAreThere) {
  DualMesh mesh = shapes::dual_mesh({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  find_loops(GridData(), mesh);
  mesh.position.resize(mesh.vertices(), Vec3::Zero());
  EditLog log;
  VertexId first = mesh.vertices();
  divide_triangle(0, Vec3::Zero(), mesh);
  const VertexId second = divide_triangle(1, Vec3::Zero(), mesh);
  log.note_added(AddedBy::kLinks, first, mesh);
  first = mesh.vertices();
  divide_edge(0, Vec3::Zero(), mesh);
  log.note_added(AddedBy::kDoubleEdges, first, mesh);
  log.note_added(AddedBy::kVertexSplits, mesh.vertices(), mesh);
  EXPECT_EQ(log.added_vertices(AddedBy::kLinks, mesh), 2u);
  EXPECT_EQ(log.added_vertices(AddedBy::kDoubleEdges, mesh), 1u);
  EXPECT_EQ(log.added_vertices(AddedBy::kVertexSplits, mesh), 0u);
  mesh.first_half_edge[second] = kNone;  // dropped
  EXPECT_EQ(log.added_vertices(AddedBy::kLinks, mesh), 1u);
}

}  // namespace
}  // namespace kdm
