// SPDX-License-Identifier: MIT
// What is concluded from normals, against a search for closed curves and for crossing triangles.
#include "split/one_way_sections.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "geometry/triangle_box.h"
#include "mesh/disjoint_sets.h"
#include "split/crossing_triangles.h"
#include "support/cell_scene.h"
#include "support/random.h"
#include "support/sanitized.h"
#include "support/shapes.h"

namespace kdm {
namespace {

using check::CellScene;
using check::with_room;

// Tells whether the surface meets the side of the cell in a closed curve: a connected one with as
// many edges of the mesh on the side as triangles.
bool has_closed_curve(const CellScene& scene, int axis, bool high) {
  const Surface& surface = scene.surface;
  LatticeBox side = scene.box;
  side.lo[axis] = side.hi[axis] = (high ? scene.box.hi : scene.box.lo)[axis];
  std::vector<TriangleId> met;
  for (TriangleId t = 0; t < surface.triangles.size(); ++t) {
    if (triangle_meets_box(surface.triangles[t], side)) met.push_back(t);
  }
  DisjointSets curves(surface.triangles.size());
  std::map<Index, int> open_ends;  // per curve: triangles minus edges
  const auto for_each_edge = [&](const auto& visit) {
    for (const TriangleId t : met) {
      for (int i = 0; i < 3; ++i) {
        const SideId opposite = surface.topology.opposite[3 * t + static_cast<Index>(i)];
        const auto& corners = surface.triangles[t];
        if (triangle_of(opposite) > t &&
            edge_meets_box(corners[i], corners[next_corner(i)], side)) {
          visit(t, triangle_of(opposite));
        }
      }
    }
  };
  for_each_edge([&](TriangleId a, TriangleId b) { curves.join(a, b); });
  for (const TriangleId t : met) ++open_ends[curves.find(t)];
  for_each_edge([&](TriangleId a, TriangleId) { --open_ends[curves.find(a)]; });
  return std::any_of(open_ends.begin(), open_ends.end(),
                     [](const auto& curve) { return curve.second == 0; });
}

// Looks at cells of many sizes all over closed surfaces that are smooth, rough or cross themselves.
void for_each_random_cell(const std::function<void(const CellScene&)>& visit) {
  check::Random random(7);
  const int tries = check::kSanitized ? 40 : 600;
  for (int i = 0; i < tries; ++i) {
    const double rough = 0.25 * random.unit() * random.unit();
    const Mesh ball = shapes::jittered(shapes::icosphere(3), rough, random.below(1000));
    const Vec3 centre = random.direction();
    const double size = random.between(0.05, 0.5);
    const Vec3 shape = random.point(0.5 * size, size);
    visit(CellScene(with_room(ball), centre - shape, centre + shape));
  }
}

TEST(OneWaySections, NoneOfThemIsClosed) {
  OneWaySections sections;
  int one_way = 0;
  int closed = 0;
  for_each_random_cell([&](const CellScene& scene) {
    sections.find(scene.surface_in_cell);
    for (int axis = 0; axis < 3; ++axis) {
      for (const bool high : {false, true}) {
        const bool curve = has_closed_curve(scene, axis, high);
        EXPECT_FALSE(curve && sections.run_one_way(axis, high));
        if (curve) ++closed;
        if (sections.run_one_way(axis, high)) ++one_way;
      }
    }
  });
  EXPECT_GT(one_way, closed);
  if (!check::kSanitized) {
    EXPECT_GT(closed, 5);
  }
}

TEST(OneWaySections, TrianglesOfAGraphDoNotCross) {
  OneWaySections sections;
  CrossingTriangles crossing_triangles;
  int graphs = 0;
  int crossing = 0;
  for_each_random_cell([&](const CellScene& scene) {
    sections.find(scene.surface_in_cell);
    const bool cross = crossing_triangles.exist_in(scene.surface_in_cell.triangles);
    const bool graph = sections.are_of_a_graph(scene.surface_in_cell);
    EXPECT_FALSE(cross && graph);
    if (cross) ++crossing;
    if (graph) ++graphs;
  });
  EXPECT_GT(graphs, check::kSanitized ? 1 : 20);
  EXPECT_GT(crossing, check::kSanitized ? 1 : 20);
}

// Seen from above both blocks face one way, but a line from there enters one after the other.
TEST(OneWaySections, TwoPiecesThatFaceTheSameWayAreNoGraph) {
  const Mesh high = shapes::box(Vec3(-2, -2, -2), Vec3(2, 2, 0));
  const Mesh low = shapes::box(Vec3(-2, -2, -2), Vec3(2, 2, -0.5));
  OneWaySections sections;
  const CellScene one(with_room(high), Vec3(-1, -1, -0.75), Vec3(1, 1, 0.25));
  sections.find(one.surface_in_cell);
  EXPECT_TRUE(sections.are_of_a_graph(one.surface_in_cell));
  const CellScene both(with_room(shapes::merged({high, low})), Vec3(-1, -1, -0.75),
                       Vec3(1, 1, 0.25));
  sections.find(both.surface_in_cell);
  EXPECT_TRUE(sections.run_one_way(0, true));
  EXPECT_FALSE(sections.are_of_a_graph(both.surface_in_cell));
}

// At a rim curves end, and triangles need not face the same way.
TEST(OneWaySections, NothingIsConcludedForOpenSurfaces) {
  const Mesh open = shapes::open(with_room(shapes::cube()));
  const Surface surface = prepare_surface(open, {.inside = InsideRule::kSheet});
  TriangleLists lists(surface.triangles);
  CellSurface cell(surface);
  cell.find_pieces(LatticeBox(), lists.entries(lists.all()));
  OneWaySections sections;
  sections.find(cell);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_FALSE(sections.run_one_way(axis, false));
    EXPECT_FALSE(sections.run_one_way(axis, true));
  }
}

}  // namespace
}  // namespace kdm
