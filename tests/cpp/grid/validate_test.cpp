// SPDX-License-Identifier: MIT
// validate() accepts what the library builds and names the rule that a damaged grid breaks.
#include "grid/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "grid/faces.h"
#include "grid/splitting_edges.h"
#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "support/paths.h"
#include "support/random_meshes.h"
#include "support/shapes.h"

namespace kdm {
namespace {

const GridData& sound_grid() {
  static const Grid grid =
      build_grid(shapes::rotated(shapes::torus(1, 0.4, 24, 12), Vec3(1, 2, 3), 1),
                 {.strategy = SplitStrategy::kUniform, .depth = 9});
  return grid.data();
}

// What validate says of a grid with some damage.
std::string verdict(const std::function<void(GridData&)>& damage) {
  GridData grid = sound_grid();
  damage(grid);
  try {
    validate(grid);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kInternal);
    return error.what();
  }
  return "nothing";
}

void expect_rule(const char* rule, const std::function<void(GridData&)>& damage) {
  const std::string text = verdict(damage);
  EXPECT_NE(text.find(std::string("grid: ") + rule + " (at "), std::string::npos)
      << "expected: " << rule << "\n  actual: " << text;
}

// The first cell whose two children are leaves; there is always one.
Index last_split(const GridData& grid) {
  for (Index c = 0; c < grid.cells.size(); ++c) {
    const Cell& cell = grid.cells[c];
    if (!cell.leaf() && grid.cells[cell.below()].leaf() && grid.cells[cell.above()].leaf()) {
      return c;
    }
  }
  throw std::logic_error("no split");
}

// An edge with at least `count` hits.
Index edge_with(const GridData& grid, Index count) {
  for (EdgeId e = 0; e < 4 * grid.splits(); ++e) {
    if (grid.edge_hits(e).size() >= count) return e;
  }
  throw std::logic_error("no such edge");
}

// An edge with hits that reaches neither end of the lattice.
Index inner_edge(const GridData& grid) {
  const std::vector<LatticeBox> boxes = cell_boxes(grid);
  EdgeId found = kNone;
  for_each_splitting_edge(grid, boxes, [&](const SplittingEdge& edge) {
    if (edge.box.lo[edge.axis] == 0 || edge.box.hi[edge.axis] == kLatticeSize) return;
    if (found == kNone && !edge.hits.empty()) found = edge.number;
  });
  if (found == kNone) throw std::logic_error("no inner edge");
  return found;
}

// Half-edges round the first minimal face with at least `count` hits; strips do not count.
std::vector<Index> half_edges_round_a_face(const GridData& grid, Index count) {
  std::vector<Index> found;
  for_each_face(grid, cell_boxes(grid), [&](const MinimalFace& face) {
    if (!found.empty() || face.strip() || face.hit_count() < count) return;
    for (int side = 0; side < 4; ++side) {
      const FaceEdge& edge = face.edges[side];
      for (Index i = 0; i < edge.hits.size(); ++i) {
        const Index hit = side < 2 ? edge.hits.first + i : edge.hits.beyond - 1 - i;
        found.push_back(3 * hit + edge.slot);
      }
    }
  });
  return found;
}

void join_sides(GridData& grid, Index a, Index b) {
  grid.opposite[a] = b;
  grid.opposite[b] = a;
}

TEST(Validate, AcceptsWhatIsBuilt) {
  EXPECT_EQ(verdict([](GridData&) {}), "nothing");
  for (const SplitStrategy strategy :
       {SplitStrategy::kAdaptive, SplitStrategy::kOctree, SplitStrategy::kMedian}) {
    EXPECT_NO_THROW(
        validate(build_grid(shapes::torus(), {.strategy = strategy, .depth = 12}).data()));
    EXPECT_NO_THROW(
        validate(build_grid(shapes::integer_tetrahedra(9, 4, 1), {.strategy = strategy, .depth = 9})
                     .data()));
  }
}

TEST(Validate, AcceptsAGridWithoutSplits) {
  GridData grid;
  grid.cells.resize(1);
  grid.edge_begin.assign(1, 0);
  EXPECT_NO_THROW(validate(grid));
}

TEST(Validate, NoticesDamagedCells) {
  expect_rule("there is a root and two cells a split", [](GridData& g) { g.cells.clear(); });
  expect_rule("there is a root and two cells a split", [](GridData& g) { g.cells.pop_back(); });
  const auto replace = [](Index first_child, int axis, std::int32_t value) {
    return [=](GridData& g) { g.cells[last_split(g)] = Cell(first_child, axis, value); };
  };
  const GridData& sound = sound_grid();
  const Index c = last_split(sound);
  const Cell cell = sound.cells[c];
  const auto size = static_cast<Index>(sound.cells.size());
  expect_rule("children follow their cell", replace(c, cell.axis(), cell.value()));
  expect_rule("children follow their cell", replace(size - 1, cell.axis(), cell.value()));
  expect_rule("children follow their cell", replace(kNone, cell.axis(), cell.value()));
  expect_rule("children are adjacent, the lower one odd",
              replace(cell.below() + 1, cell.axis(), cell.value()));
  expect_rule("a split has an axis", replace(cell.below(), 3, cell.value()));
  const LatticeBox box = cell_boxes(sound)[c];
  for (const std::int32_t outside : {0, box.lo[cell.axis()], box.hi[cell.axis()], kLatticeSize}) {
    expect_rule("a split lies strictly inside its cell",
                replace(cell.below(), cell.axis(), outside));
  }
  expect_rule("a cell has one parent", [](GridData& g) {
    // The two children of the root share theirs.
    const Cell below = g.cells[g.cells[0].below()];
    const Cell above = g.cells[g.cells[0].above()];
    g.cells[g.cells[0].below()] = Cell(above.below(), below.axis(), below.value());
  });
  expect_rule("no cell is lost", [](GridData& g) { g.cells[last_split(g)] = Cell(); });
  expect_rule("no cell is lost", [](GridData& g) { g.cells.resize(g.cells.size() + 2); });
}

TEST(Validate, NoticesTreesThatAreTooDeep) {
  // A chain: every upper cell is cut one lattice step above its lower side.
  const auto chain = [](int depth) {
    GridData grid;
    grid.cells.resize(1);
    for (int k = 0; k < depth; ++k) {
      grid.cells[2 * k] = Cell(static_cast<Index>(2 * k + 1), 0, k + 1);
      grid.cells.resize(grid.cells.size() + 2);
    }
    grid.edge_begin.assign(4 * static_cast<std::size_t>(depth) + 1, 0);
    return grid;
  };
  EXPECT_NO_THROW(validate(chain(kMaxDepth)));
  expect_rule("no cell lies deeper than midpoints can",
              [&](GridData& g) { g = chain(kMaxDepth + 1); });
}

TEST(Validate, NoticesDamagedEdges) {
  expect_rule("splitting edges cover all hits", [](GridData& g) { g.edge_begin.pop_back(); });
  expect_rule("splitting edges cover all hits", [](GridData& g) { g.edge_begin[0] = 1; });
  expect_rule("splitting edges cover all hits", [](GridData& g) { --g.edge_begin.back(); });
  expect_rule("splitting edges cover all hits", [](GridData& g) { g.hits.pop_back(); });
  expect_rule("edges' hits are in order", [](GridData& g) {
    const Index e = edge_with(g, 1);
    g.edge_begin[e + 1] = g.edge_begin[e] - 1;
  });
  expect_rule("edges' hits are in order", [](GridData& g) { g.edge_begin[5] = 1000000000; });
}

TEST(Validate, NoticesDamagedHits) {
  const auto change = [](Index number, const std::function<Hit(const Hit&)>& what) {
    return [=](GridData& g) {
      Hit& hit = g.hits[g.edge_hits(edge_with(g, 2)).first + number];
      hit = what(hit);
    };
  };
  for (const LinePosition outside : {0u, ~0u}) {
    expect_rule("a hit lies on its edge", [=](GridData& g) {
      const Index e = inner_edge(g);
      Hit& hit = g.hits[outside == 0 ? g.edge_hits(e).first : g.edge_hits(e).beyond - 1];
      hit.position = outside;
    });
  }
  expect_rule("a hit is turned rightly", change(0, [](const Hit& h) {
                return Hit(h.position, h.plane(), h.leaving(), !h.reversed());
              }));
  expect_rule("a hit is turned rightly", change(0, [](const Hit& h) {
                return Hit(h.position, h.plane(), !h.leaving(), h.reversed());
              }));
  expect_rule("a hit has a plane", change(0, [](const Hit& h) {
                return Hit(h.position, static_cast<Index>(sound_grid().planes.size()), h.leaving(),
                           h.reversed());
              }));
  expect_rule("hits ascend along an edge", [](GridData& g) {
    const Index first = g.edge_hits(edge_with(g, 2)).first;
    std::swap(g.hits[first], g.hits[first + 1]);
  });
  expect_rule("hits ascend along an edge", [](GridData& g) {
    const Index first = g.edge_hits(edge_with(g, 2)).first;
    g.hits[first].position = g.hits[first + 1].position;
  });
  expect_rule("hits alternate along an edge", change(1, [](const Hit& h) {
                return Hit(h.position, h.plane(), !h.leaving(), !h.reversed());
              }));
}

TEST(Validate, NoticesArraysOfTheWrongSize) {
  expect_rule("a hit has three half-edges", [](GridData& g) { g.opposite.pop_back(); });
  expect_rule("a hit has three half-edges", [](GridData& g) { g.start.push_back(0); });
  expect_rule("a plane has a source face", [](GridData& g) { g.source_faces.pop_back(); });
  const char* order = "planes come in the order of their first hits";
  expect_rule(order, [](GridData& g) {  // the first hit has a plane that comes later
    const auto is_new = [](const Hit& h) { return h.plane() > 0; };
    g.hits[0] = Hit(g.hits[0].position, std::find_if(g.hits.begin(), g.hits.end(), is_new)->plane(),
                    g.hits[0].leaving(), g.hits[0].reversed());
  });
  expect_rule(order, [](GridData& g) {  // one without hits
    g.planes.push_back(g.planes[0]);
    g.source_faces.push_back(0);
  });
}

TEST(Validate, NoticesDamagedLinks) {
  expect_rule("links are mutual", [](GridData& g) {
    const std::vector<Index> round = half_edges_round_a_face(g, 4);
    g.opposite[round[0]] = g.opposite[round[1]] == round[0] ? round[2] : round[1];
  });
  expect_rule("links are mutual",
              [](GridData& g) { g.opposite[half_edges_round_a_face(g, 2)[0]] = kNone; });
  expect_rule("linked half-edges run against each other", [](GridData& g) {
    // Every other half-edge round the face starts on the same side.
    const std::vector<Index> round = half_edges_round_a_face(g, 4);
    join_sides(g, g.opposite[round[0]], g.opposite[round[2]]);
    join_sides(g, round[0], round[2]);
  });
  expect_rule("links of a face join its own hits and do not cross", [](GridData& g) {
    // Between faces of the same two leaves' directions: found by trying all.
    const std::vector<Index> round = half_edges_round_a_face(g, 2);
    const Index a = round[0];
    const Index b = g.opposite[a];
    for (Index c = 0; c < g.opposite.size(); ++c) {
      const Index d = g.opposite[c];
      if (c == a || c == b || g.start_leaf(c) == g.start_leaf(a)) continue;
      if (g.start_leaf(d) == g.start_leaf(b) || g.start_leaf(d) == g.start_leaf(c)) continue;
      join_sides(g, a, c);
      join_sides(g, b, d);
      return;
    }
  });
}

TEST(Validate, NoticesCrossingLinks) {
  // Six hits round a face, linked to the one across: directions fit, but the links cross.
  const Grid grid = build_grid(shapes::rotated(shapes::thin_walled_box(0.02), Vec3(3, 1, 2), 1),
                               {.strategy = SplitStrategy::kUniform, .depth = 6});
  GridData damaged = grid.data();
  const std::vector<Index> round = half_edges_round_a_face(damaged, 6);
  ASSERT_GE(round.size(), 6u);
  const std::size_t count = round.size();
  if (count == 6) {
    for (std::size_t i = 0; i < 3; ++i) join_sides(damaged, round[i], round[i + 3]);
  } else {
    // 0-3 and 2-5 cross; the rest stays in neighbours.
    join_sides(damaged, round[0], round[3]);
    join_sides(damaged, round[2], round[5]);
    join_sides(damaged, round[1], round[4]);
    for (std::size_t i = 6; i < count; i += 2) join_sides(damaged, round[i], round[i + 1]);
  }
  try {
    validate(damaged);
    FAIL() << "crossing links were accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("join its own hits and do not cross"),
              std::string::npos)
        << error.what();
  }
}

TEST(Validate, NoticesDamagedStarts) {
  expect_rule("a half-edge starts in its leaf", [](GridData& g) {
    const Index h = half_edges_round_a_face(g, 2)[0];
    g.start[h] = g.start[g.opposite[h]];
  });
  expect_rule("a half-edge starts in its leaf", [](GridData& g) {
    g.start[half_edges_round_a_face(g, 2)[0]] = GridData::kStrip - 1;
  });
  expect_rule("strips are marked", [](GridData& g) {
    for (std::uint32_t& start : g.start) start &= ~GridData::kStrip;
  });
  expect_rule("strips are marked",
              [](GridData& g) { g.start[half_edges_round_a_face(g, 2)[0]] |= GridData::kStrip; });
}

TEST(Validate, NoticesHitsThatNoWalkFinds) {
  expect_rule("every half-edge crosses a minimal face", [](GridData& g) {
    for (Cell& cell : g.cells) cell.clear_active();
  });
}

// An open sheet, and what validate says of it with some damage.
const GridData& sound_sheet() {
  static const Grid grid = build_grid(
      shapes::open(shapes::rotated(shapes::torus(1, 0.4, 24, 12), Vec3(1, 2, 3), 1), 100),
      {.strategy = SplitStrategy::kUniform, .depth = 9, .inside = InsideRule::kSheet});
  return grid.data();
}

void expect_sheet_rule(const char* rule, const std::function<void(GridData&)>& damage) {
  GridData grid = sound_sheet();
  damage(grid);
  try {
    validate(grid);
    ADD_FAILURE() << "nothing found; expected: " << rule;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(std::string("grid: ") + rule + " (at "),
              std::string::npos)
        << error.what();
  }
}

// The first half-edge for which the predicate holds.
Index find_half_edge(const GridData& grid, const std::function<bool(Index)>& wanted) {
  for (Index h = 0; h < grid.opposite.size(); ++h) {
    if (wanted(h)) return h;
  }
  throw std::logic_error("no such half-edge");
}

TEST(Validate, SheetsHaveRules) {
  ASSERT_NO_THROW(validate(sound_sheet()));
  ASSERT_GT(sound_sheet().rims.size(), 1u);
  const auto linked = [](const GridData& g, bool strip) {
    return find_half_edge(
        g, [&](Index h) { return g.opposite[h] != kNone && g.crosses_strip(h) == strip; });
  };
  const auto unlink = [](GridData& g, Index h) {
    g.opposite[g.opposite[h]] = kNone;
    g.opposite[h] = kNone;
  };
  expect_sheet_rule("strips are linked", [&](GridData& g) { unlink(g, linked(g, true)); });
  expect_sheet_rule("a sheet's rim is of a half-edge on the boundary",
                    [&](GridData& g) { g.rims[0].half_edge = linked(g, false); });
  expect_sheet_rule("rims ascend", [](GridData& g) { std::swap(g.rims[0], g.rims[1]); });
  expect_sheet_rule("links are mutual", [&](GridData& g) {
    g.opposite[linked(g, false)] =
        find_half_edge(g, [&](Index h) { return g.opposite[h] == kNone; });
  });
  expect_sheet_rule("links of a face join its own hits and do not cross", [&](GridData& g) {
    // Two links of different faces change partners.
    const Index a = linked(g, false);
    const Index b = find_half_edge(g, [&](Index h) {
      return g.opposite[h] != kNone && h != a && h != g.opposite[a] &&
             g.start_leaf(g.opposite[h]) != g.start_leaf(a) &&
             g.start_leaf(h) != g.start_leaf(g.opposite[a]) && g.start_leaf(h) != g.start_leaf(a);
    });
    join_sides(g, g.opposite[a], g.opposite[b]);
    join_sides(g, a, b);
  });
  expect_rule("a rim is of a half-edge", [](GridData& g) {
    g.rims = {{static_cast<Index>(g.opposite.size()), Vec3::Zero(), Vec3::Zero()}};
  });
  expect_rule("a corner is of a half-edge", [](GridData& g) {
    g.corners = {{static_cast<Index>(g.opposite.size()), Vec3::Zero()}};
  });
  expect_rule("corners ascend", [](GridData& g) {
    g.corners = {{3, Vec3::Zero()}, {3, Vec3::Zero()}};
  });
  GridData open = sound_sheet();
  Index h = linked(open, false);
  unlink(open, h);
  EXPECT_NO_THROW(validate(open)) << "links may be missing";
}

TEST(Validate, ItsRulesAreThoseOfTheReadme) {
  const auto matches_in = [&](const char* file, const std::regex& pattern) {
    std::ifstream stream(paths::kRoot / "src" / file);
    std::stringstream text;
    text << stream.rdbuf();
    const std::string all = text.str();
    std::set<std::string> found;
    for (std::sregex_iterator i(all.begin(), all.end(), pattern), end; i != end; ++i) {
      found.insert((*i)[1]);
    }
    return found;
  };
  // Numbered lines without a full stop, and string literals that are no file names or formats.
  const auto listed = matches_in("README.md", std::regex("\n[0-9]+\\. ([a-z][^.\n]*)(?=\n)"));
  const auto checked = matches_in("grid/validate.cpp", std::regex("\"([^\"/{\n]+)\""));
  EXPECT_EQ(listed.size(), 35u);
  EXPECT_EQ(listed, checked);
}

}  // namespace
}  // namespace kdm
