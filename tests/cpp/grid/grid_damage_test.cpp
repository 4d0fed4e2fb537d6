// SPDX-License-Identifier: MIT
// What is no saved grid is refused: cut off, damaged, or made up by somebody who knows the format.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include "grid/saved/grid_format.h"
#include "grid/validate.h"
#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "kdmanifold/grid_io.h"
#include "support/extract_any.h"
#include "support/mesh_assert.h"
#include "support/sanitized.h"
#include "support/shapes.h"
#include "support/sheets.h"

namespace kdm {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kVersionAt = 8;
constexpr std::size_t kSizeAt = 12;
constexpr std::size_t kChecksumAt = 20;
constexpr std::size_t kLatticeAt = grid_format::kHeaderBytes;
constexpr std::size_t kReportsAt = kLatticeAt + 7 * 8;

void put(Bytes& bytes, std::size_t at, std::uint64_t value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    bytes[at + i] = static_cast<std::uint8_t>(value >> (8 * i));
  }
}

void put(Bytes& bytes, std::size_t at, double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  put(bytes, at, bits, 8);
}

// Makes header and payload fit again, as a forger would.
void repair(Bytes& bytes) {
  const std::string_view all(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  put(bytes, kSizeAt, bytes.size() - grid_format::kHeaderBytes, 8);
  put(bytes, kChecksumAt, grid_format::checksum(all.substr(grid_format::kHeaderBytes)), 8);
}

// What is wrong with the bytes; "" if they are a grid.
std::string verdict(const Bytes& bytes) {
  try {
    load_grid(bytes, "test.kdgrid");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kParseError) << error.what();
    EXPECT_EQ(std::string(error.what()).rfind("test.kdgrid: ", 0), 0u) << error.what();
    return error.what();
  }
  return "";
}

void expect_refused(const Bytes& bytes, const std::string& reason) {
  const std::string text = verdict(bytes);
  EXPECT_NE(text.find(reason), std::string::npos)
      << "expected: " << reason << "\n  actual: " << text;
}

Bytes small_file() {
  return save_grid(build_grid(shapes::rotated(shapes::thin_walled_box(0.02), Vec3(3, 1, 2), 1),
                              {.strategy = SplitStrategy::kUniform, .depth = 4}));
}

// Of a sheet with a rim, and faces that cross others.
Bytes small_sheet_file() {
  Mesh torus = shapes::open(shapes::torus(1, 0.4, 12, 8), 60);
  const Mesh wall = shapes::translated(shapes::grid_sheet(1, 1, [](double, double) { return 0.1; }),
                                       Vec3(0.3, -0.4, 0));
  return save_grid(
      build_grid(shapes::merged({torus, wall}),
                 {.strategy = SplitStrategy::kUniform, .depth = 5, .inside = InsideRule::kSheet}));
}

TEST(GridDamage, ACutIsNoticedAtEveryLength) {
  for (const Bytes& bytes : {small_file(), small_sheet_file()}) {
    ASSERT_EQ(verdict(bytes), "");
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      Bytes cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
      ASSERT_NE(verdict(cut), "") << size;
      if (size < grid_format::kHeaderBytes) continue;
      repair(cut);
      ASSERT_NE(verdict(cut), "") << size;
    }
    Bytes longer = bytes;
    longer.push_back(0);
    expect_refused(longer, "cut off or something was added");
    repair(longer);
    expect_refused(longer, "but not the file");
  }
}

TEST(GridDamage, DamageIsNoticedInEveryByte) {
  for (const Bytes& bytes : {small_file(), small_sheet_file()}) {
    for (std::size_t at = 0; at < bytes.size(); ++at) {
      for (const int mask : {1, 0x80, 0xff}) {
        Bytes damaged = bytes;
        damaged[at] = static_cast<std::uint8_t>(damaged[at] ^ mask);
        ASSERT_NE(verdict(damaged), "") << at;
      }
    }
  }
}

// Then some changes make another grid that is sound as well, and a surface comes out of it.
void forge_all(const Bytes& bytes, bool sheet) {
  int accepted = 0;
  int refused = 0;
  const std::size_t step = check::kSanitized ? 7 : 1;
  for (std::size_t at = grid_format::kHeaderBytes; at < bytes.size(); at += step) {
    for (int bit = 0; bit < 9; ++bit) {
      Bytes forged = bytes;
      forged[at] = static_cast<std::uint8_t>(forged[at] ^ (bit < 8 ? 1 << bit : 0xff));
      repair(forged);
      if (!verdict(forged).empty()) {
        ++refused;
        continue;
      }
      ++accepted;
      const Grid grid = load_grid(forged);
      ASSERT_NO_THROW(validate(grid.data())) << at;
      ExtractedMesh out;
      try {
        // To embed what is forged takes long: every sixteenth is.
        const Strict strict = accepted % 16 == 0 ? Strict::kEmbedded : Strict::kManifold;
        out = check::extract_any(grid, {.strict = strict, .normals = true});
      } catch (const Error& error) {
        ASSERT_EQ(error.code(), ErrorCode::kNotClosed) << "byte " << at << ", bit " << bit;
      }
      if ((sheet || !grid.input().closed) && out.triangles.empty()) continue;
      ASSERT_TRUE(sheet ? check::is_manifold(out) : check::is_two_manifold(out))
          << "byte " << at << ", bit " << bit;
    }
  }
  EXPECT_GT(accepted, 0);
  EXPECT_GT(refused, accepted / 4);
}

TEST(GridDamage, ForgedBytesGiveASoundGridOrAnError) { forge_all(small_file(), false); }
TEST(GridDamage, ForgedBytesGiveASoundSheetOrAnError) { forge_all(small_sheet_file(), true); }

TEST(GridDamage, HeadersAreChecked) {
  const Bytes sound = small_file();
  expect_refused({}, "no saved grid");
  expect_refused({1, 2, 3}, "no saved grid");
  expect_refused(Bytes(sound.begin(), sound.begin() + 9), "1 x header");
  const auto expect_after = [&](const std::function<void(Bytes&)>& change, const char* reason) {
    Bytes bytes = sound;
    change(bytes);
    expect_refused(bytes, reason);
  };
  expect_after([](Bytes& b) { b[0] = 0x09; }, "no saved grid");
  expect_after([](Bytes& b) { b[7] = '\r'; }, "no saved grid");
  expect_after([](Bytes& b) { put(b, kVersionAt, 1, 4); }, "version is 1; this library knows 7");
  expect_after([](Bytes& b) { put(b, kVersionAt, 0xffffffff, 4); }, "version is 4294967295");
  expect_after([](Bytes& b) { put(b, kSizeAt, ~std::uint64_t{0}, 8); }, "bytes should follow");
  expect_after([](Bytes& b) { b[kChecksumAt] ^= 1; }, "damaged");
  expect_after([](Bytes& b) { b.back() ^= 1; }, "damaged");
}

TEST(GridDamage, HostileNumbersAreRefused) {
  const Bytes sound = small_file();
  const auto expect_after = [&](const std::function<void(Bytes&)>& change, const char* reason) {
    Bytes bytes = sound;
    change(bytes);
    repair(bytes);
    expect_refused(bytes, reason);
  };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double bad : {kInfinity, -kInfinity, std::nan(""), 1e200}) {
    expect_after([&](Bytes& b) { put(b, kLatticeAt + 8, bad); }, "lattice's origin");
  }
  for (const double bad : {0.0, -1.0, kInfinity, std::nan(""), 1e-310}) {
    expect_after([&](Bytes& b) { put(b, kLatticeAt + 24, bad); }, "lattice's step");
  }
  for (const double bad : {-1.0, kInfinity, std::nan("")}) {
    expect_after([&](Bytes& b) { put(b, kLatticeAt + 32, bad); }, "tolerance");
    expect_after([&](Bytes& b) { put(b, kLatticeAt + 40, bad); }, "winding threshold");
    expect_after([&](Bytes& b) { put(b, kLatticeAt + 48, bad); }, "tolerance asked for");
  }
  // A report's number beyond 32 bits, one without end, and one with a superfluous last byte.
  const auto insert = [](Bytes& b, std::size_t at, const Bytes& what) {
    b.insert(b.begin() + static_cast<std::ptrdiff_t>(at), what.begin(), what.end());
  };
  expect_after(
      [&](Bytes& b) {
        insert(b, kReportsAt, {0x80, 0x80, 0x80, 0x80, 0x80, 1});
      },
      "a count of the report should be a number up to 4294967295");
  expect_after([&](Bytes& b) { insert(b, kReportsAt, Bytes(20, 0xff)); }, "a count of the report");
  expect_after([&](Bytes& b) { insert(b, kReportsAt, {0x80, 0}); }, "a count of the report");
  // Counts that promise more than the file holds take no memory.
  const std::size_t flags_at = kReportsAt + [&] {
    std::size_t numbers = 0;
    std::size_t at = kReportsAt;
    for (; numbers < 21; ++at) numbers += sound[at] < 0x80 ? 1 : 0;
    return at - kReportsAt;
  }();
  expect_after([&](Bytes& b) { b[flags_at] = 128; }, "no such flags");
  const std::size_t sizes_at = flags_at + 1 + 6 * 8;  // six measures follow the flags
  expect_after(
      [&](Bytes& b) {
        b[flags_at] |= 64;
        insert(b, sizes_at, Bytes(8, 0));
      },
      "how far it was simplified");
  const Bytes most{0xff, 0xff, 0xff, 0xff, 3};  // 2^30 - 1
  expect_after([&](Bytes& b) { insert(b, sizes_at, most); }, "x split of 2 bytes");
  expect_after(
      [&](Bytes& b) {
        insert(b, sizes_at, {1, 0xff, 0xff, 0xff, 0xff, 3});
      },
      "x hit of 2 bytes");
  expect_after(
      [&](Bytes& b) {
        insert(b, sizes_at, {0xff, 0xff, 0xff, 0xff, 4});
      },
      "the number of splits should be");
}

TEST(GridDamage, HostileRimsAreRefused) {
  const Bytes sound = small_sheet_file();
  GridData grid = load_grid(sound).data();
  ASSERT_GT(grid.rims.size(), 2u);
  const auto expect_after = [&](const std::function<void(std::vector<RimHit>&)>& change,
                                const char* reason) {
    GridData changed = grid;
    change(changed.rims);
    expect_refused(save_grid(Grid(std::make_unique<GridData>(changed))), reason);
  };
  const Index linked = static_cast<Index>(
      std::find_if(grid.opposite.begin(), grid.opposite.end(), [](Index h) { return h != kNone; }) -
      grid.opposite.begin());
  ASSERT_LT(linked, grid.rims.back().half_edge);
  expect_after(
      [&](auto& rims) {
        rims = {{linked, rims[0].point, rims[0].normal}};
      },
      "a sheet's rim is of a half-edge on the boundary");
  expect_after(
      [&](auto& rims) { rims.back().half_edge = static_cast<Index>(grid.opposite.size()); },
      "a rim's half-edge is none");
  expect_after([](auto& rims) { rims[1].point[2] = -1; }, "a rim's point");
  expect_after([](auto& rims) { rims[1].point[0] = std::nan(""); }, "a rim's point");
  expect_after([](auto& rims) { rims[1].normal *= 0.5; }, "a rim's normal");
  expect_after([](auto& rims) { rims[1].normal[1] = std::nan(""); }, "a rim's normal");
  EXPECT_EQ(verdict(save_grid([&] {
              GridData changed = grid;
              changed.rims[1].normal.setZero();
              return Grid(std::make_unique<GridData>(changed));
            }())),
            "")
      << "one may have no direction";
}

TEST(GridDamage, HostileCornersAreRefused) {
  GridData grid = load_grid(small_file()).data();
  const auto expect_after = [&](std::vector<KeptCorner> corners, const char* reason) {
    GridData changed = grid;
    changed.corners = std::move(corners);
    expect_refused(save_grid(Grid(std::make_unique<GridData>(changed))), reason);
  };
  const auto half_edges = static_cast<Index>(grid.opposite.size());
  expect_after({{half_edges, Vec3::Zero()}}, "a corner's half-edge is none");
  expect_after({{0, Vec3(0, 0, -1)}}, "a corner's point");
  expect_after({{0, Vec3(0, std::nan(""), 0)}}, "a corner's point");
  expect_after({{0, Vec3(2.0 * kLatticeSize, 0, 0)}}, "a corner's point");
  EXPECT_EQ(verdict(save_grid([&] {
              GridData changed = grid;
              changed.corners = {{0, Vec3::Zero()}, {half_edges - 1, Vec3::Zero()}};
              return Grid(std::make_unique<GridData>(changed));
            }())),
            "");
}

// Saves grids that no build makes, and says what loading makes of them.
std::string verdict_of(GridData grid) {
  return verdict(save_grid(Grid(std::make_unique<GridData>(std::move(grid)))));
}

TEST(GridDamage, TreesThatWouldBreakRecursionsAreRefused) {
  GridData grid;
  grid.cells.resize(1);
  for (int k = 0; k < 5000; ++k) {
    grid.cells[2 * k] = Cell(static_cast<Index>(2 * k + 1), 0, k + 1);
    grid.cells.resize(grid.cells.size() + 2);
  }
  grid.edge_begin.assign(4 * 5000 + 1, 0);
  EXPECT_NE(verdict_of(grid).find("a cell lies too deep"), std::string::npos);
}

// Below the root's splitting face slabs along x, above it slabs along y: their faces are as many as
// the square of the splits, and hits at the far end make every slab look for them.
TEST(GridDamage, TreesWithEndlesslyManyFacesAreRefused) {
  GridData grid;
  grid.cells = {Cell(1, 2, kLatticeSize / 2), Cell(), Cell()};
  grid.edge_begin.assign(5, 0);
  constexpr std::int32_t kSlabs = 1 << 12;
  const auto slabs = [&](auto&& self, Index cell, int axis, std::int32_t lo, std::int32_t hi,
                         bool with_hits) -> void {
    if (hi - lo == kLatticeSize / kSlabs) return;
    const std::int32_t middle = (lo + hi) / 2;
    grid.cells[cell] = Cell(static_cast<Index>(grid.cells.size()), axis, middle);
    const Index child = static_cast<Index>(grid.cells.size());
    grid.cells.resize(grid.cells.size() + 2);
    for (int i = 0; i < 4; ++i) {
      if (with_hits && i == edge_on_side(axis, 2, false)) {
        const LinePosition last = (std::uint32_t{kLatticeSize - 1} << kFractionBits) + 7;
        grid.hits.push_back(Hit(last, 0, true, reversed_on_edge(i, true)));
      }
      grid.edge_begin.push_back(static_cast<Index>(grid.hits.size()));
    }
    self(self, child, axis, lo, middle, with_hits);
    self(self, child + 1, axis, middle, hi, with_hits);
  };
  slabs(slabs, 1, 0, 0, kLatticeSize, false);
  slabs(slabs, 2, 1, 0, kLatticeSize, true);
  grid.planes = {{Vec3::UnitX(), 1}};
  grid.source_faces = {0};
  grid.opposite.assign(3 * grid.hits.size(), 0);
  grid.start.assign(3 * grid.hits.size(), 0);
  EXPECT_NE(verdict_of(grid).find("far more sides in common"), std::string::npos);
}

}  // namespace
}  // namespace kdm
