// SPDX-License-Identifier: MIT
// Reads a grid from the bytes that grid_format.h describes.
//
// The bytes may come from anybody, so the checksum proves nothing. Every number is checked against
// its range where it is read. Every count is checked against the number of bytes that are left, so
// that no allocation exceeds a fixed multiple of the file. Walks down the trees have a limit of
// steps. Whatever else may be wrong is found by `validate`.
#include <limits>
#include <memory>
#include <new>

#include "grid/count_stats.h"
#include "grid/saved/grid_format.h"
#include "grid/saved/link_reader.h"
#include "grid/saved/read_exact.h"
#include "grid/saved/read_numbers.h"
#include "grid/splitting_edges.h"
#include "grid/validate.h"
#include "io/bytes.h"
#include "kdmanifold/error.h"
#include "kdmanifold/grid_io.h"
#include "kdmanifold/reports.h"
#include "text/compose.h"

namespace kdm {
namespace {

namespace format = grid_format;

constexpr Index kAnyIndex = kNone;

class GridReader {
 public:
  GridReader(ByteReader& bytes, GridData& grid) : bytes_(bytes), grid_(grid) {}

  void read() {
    read_lattice();
    read_reports();
    // A split takes two bytes or more, and so does a hit.
    const std::uint64_t splits = bytes_.take_varint(format::kMostSplits, "the number of splits");
    const std::uint64_t hits = bytes_.take_varint(format::kMostHits, "the number of hits");
    bytes_.require(splits, 2, "split");
    bytes_.require(hits, 2, "hit");
    read_cells(static_cast<Index>(splits));
    read_edges(static_cast<Index>(splits), hits);
    read_hits();
    grid_.planes.shrink_to_fit();
    grid_.source_faces.shrink_to_fit();
    mark_active_sides(grid_);
    read_links();
    read_exact(bytes_, static_cast<Index>(grid_.operands.size()), grid_.exact);
    if (bytes_.bytes_left() > 0) bytes_.fail("the grid ends here, but not the file");
    count_stats(grid_);
  }

 private:
  Index take_index(Index most, std::string_view what) {
    return static_cast<Index>(bytes_.take_varint(most, what));
  }

  void read_lattice() {
    // Coordinates of accepted meshes are below 1e150.
    constexpr double kFar = 1e152;
    for (int axis = 0; axis < 3; ++axis) {
      grid_.lattice.origin[axis] = take_real(bytes_, -kFar, kFar, "the lattice's origin");
    }
    constexpr double kLeastStep = std::numeric_limits<double>::min();
    grid_.lattice.step = take_real(bytes_, kLeastStep, kFar, "the lattice's step");
    grid_.tolerance = take_real(bytes_, 0, std::numeric_limits<double>::max(), "the tolerance");
    grid_.stats.winding_threshold = take_real(bytes_, 0, 1, "the winding threshold");
    grid_.stats.asked_tolerance =
        take_real(bytes_, 0, std::numeric_limits<double>::max(), "the tolerance asked for");
  }

  void read_reports() {
    InputReport& input = grid_.input;
    for (Index* count : {&input.vertices,
                         &input.triangles,
                         &input.boundary_edges,
                         &input.non_manifold_edges,
                         &input.boundary_loops,
                         &input.degenerate_faces,
                         &input.cancelled_faces,
                         &input.duplicate_faces,
                         &input.sewn_edges,
                         &input.turned_faces,
                         &input.turned_parts,
                         &input.components,
                         &input.patched_holes,
                         &input.lost_parts,
                         &input.stray_parts,
                         &input.thickened_parts,
                         &input.rebuilt_parts,
                         &grid_.stats.unresolved_leaves,
                         &grid_.stats.guessed_faces,
                         &grid_.stats.exact_parts,
                         &grid_.stats.thin_parts}) {
      *count = take_index(kAnyIndex, "a count of the report");
    }
    bytes_.require(1, 1, "flags");
    const auto flags = bytes_.take_unsigned<std::uint8_t>();
    if (flags >= 2 * format::kSimplified) {
      bytes_.fail("there are no such flags");
    }
    input.closed = (flags & format::kClosed) != 0;
    input.flipped = (flags & format::kFlipped) != 0;
    input.lattice_step = grid_.lattice.step;
    grid_.stats.topology_resolved = (flags & format::kTopologyResolved) != 0;
    grid_.sheet = (flags & format::kSheet) != 0;
    several_operands_ = (flags & format::kSeveralOperands) != 0;
    input.nesting_known = (flags & format::kNestingKnown) != 0;
    for (double* measure : {&input.patch_area, &input.lost_area, &input.largest_lost,
                            &input.sewing_distance, &input.rebuilding_tolerance, &input.extent}) {
      *measure =
          take_real(bytes_, 0, std::numeric_limits<double>::max(), "a measure of the report");
    }
    if ((flags & format::kSimplified) != 0) {
      grid_.simplified = take_real(bytes_, std::numeric_limits<double>::min(),
                                   std::numeric_limits<double>::max(), "how far it was simplified");
    }
  }

  void read_cells(Index splits) {
    const std::size_t cells = 2 * std::size_t{splits} + 1;
    enum State : char { kLeaf, kPending, kDone };
    std::vector<State> state(cells, kLeaf);
    std::vector<std::uint8_t> depth(cells, 0);
    std::vector<CellId> pending;
    grid_.cells.assign(cells, Cell());
    boxes_.assign(cells, LatticeBox());
    const auto expect_split = [&](CellId cell) {
      state[cell] = kPending;
      pending.push_back(cell);
    };
    if (splits > 0) expect_split(0);
    for (SplitId k = 0; k < splits; ++k) {
      constexpr std::uint64_t kMost = std::uint64_t{8 * 3 * 2} * kLatticeSize;
      const std::uint64_t packed = bytes_.take_varint(kMost, "a split");
      CellId c = 0;
      if ((packed & format::kStray) != 0) {
        c = take_index(2 * k, "the cell of a split");
      } else {
        while (!pending.empty() && state[pending.back()] != kPending) pending.pop_back();
        if (pending.empty()) bytes_.fail("no cell is left that could be split");
        c = pending.back();
      }
      if (state[c] != kPending) bytes_.fail("a cell is split that should not be");
      state[c] = kDone;
      const LatticeBox& box = boxes_[c];
      const auto axis = static_cast<int>(packed / 8 % 3);
      const int middle = (box.lo[axis] + box.hi[axis]) / 2;
      const std::int64_t value = middle + format::to_signed(packed / 24);
      if (value <= box.lo[axis] || value >= box.hi[axis]) {
        bytes_.fail("a split lies outside of its cell");
      }
      const CellId below = 2 * k + 1;
      add_split(c, below, axis, static_cast<std::int32_t>(value));
      depth[below] = depth[below + 1] = static_cast<std::uint8_t>(depth[c] + 1);
      if (depth[below] > kMaxDepth) bytes_.fail("a cell lies too deep");
      if ((packed & format::kAboveIsSplit) != 0) expect_split(below + 1);
      if ((packed & format::kBelowIsSplit) != 0) expect_split(below);
    }
    for (const State s : state) {
      if (s == kPending) bytes_.fail("splits are missing");
    }
  }

  void add_split(CellId c, CellId below, int axis, std::int32_t value) {
    grid_.cells[c] = Cell(below, axis, value);
    boxes_[below] = boxes_[below + 1] = boxes_[c];
    boxes_[below].hi[axis] = value;
    boxes_[below + 1].lo[axis] = value;
  }

  void read_edges(Index splits, std::uint64_t hits) {
    grid_.edge_begin.reserve(4 * std::size_t{splits} + 1);
    grid_.edge_begin.push_back(0);
    std::uint64_t total = 0;
    for (SplitId k = 0; k < splits; ++k) {
      bytes_.require(1, 1, "edge");
      const unsigned packed = bytes_.take_unsigned<std::uint8_t>();
      for (int i = 0; i < 4; ++i) {
        std::uint64_t count = packed >> (2 * i) & 3u;
        if (count == format::kManyHits) count += bytes_.take_varint(hits, "the hits of an edge");
        total += count;
        if (total > hits) bytes_.fail("the edges have more hits than there are");
        grid_.edge_begin.push_back(static_cast<Index>(total));
      }
    }
    if (total != hits) bytes_.fail("there are hits without an edge");
    // The numbers of edges with many hits took bytes that the hits were promised.
    bytes_.require(hits, 2, "hit");
    grid_.hits.reserve(static_cast<std::size_t>(hits));
  }

  void read_hits() {
    for_each_splitting_edge(grid_, boxes_, [&](const SplittingEdge& edge) {
      auto lowest = static_cast<std::uint64_t>(edge.box.lo[edge.axis]) << kFractionBits;
      const auto beyond = static_cast<std::uint64_t>(edge.box.hi[edge.axis]) << kFractionBits;
      bool leaving = false;
      for (const HitId h : edge.hits) {
        if (lowest >= beyond) bytes_.fail("an edge has no room for its hits");
        const std::uint64_t position =
            lowest + bytes_.take_varint(beyond - lowest - 1, "the position of a hit");
        lowest = position + (grid_.sheet ? 0 : 1);
        const std::uint64_t met = grid_.planes.size();
        const bool directed = grid_.sheet || h == edge.hits.first;
        std::uint64_t back = bytes_.take_varint(directed ? 2 * met + 1 : met, "a hit's plane");
        if (directed) {
          leaving = (back & 1) != 0;
          back /= 2;
        } else {
          leaving = !leaving;
        }
        if (back == 0) read_plane();
        const std::uint64_t plane = back == 0 ? met : met - back;
        grid_.hits.push_back(Hit(static_cast<LinePosition>(position), static_cast<Index>(plane),
                                 leaving, reversed_on_edge(edge.i, leaving)));
      }
    });
  }

  void read_plane() {
    Plane plane;
    plane.normal = take_normal(bytes_, false, "a normal");
    // Planes meet the root cell; its diagonal is less than two sides.
    plane.offset = take_real(bytes_, -2.0 * kLatticeSize, 2.0 * kLatticeSize, "a plane's offset");
    constexpr std::uint64_t kMost = std::uint64_t{1} << 33;
    const std::int64_t source =
        source_before_ + format::to_signed(bytes_.take_varint(kMost, "a source face"));
    if (source < 0 || source > kAnyIndex) bytes_.fail("a source face is none");
    source_before_ = source;
    grid_.planes.push_back(plane);
    grid_.source_faces.push_back(static_cast<Index>(source));
  }

  void read_links() {
    LinkReader links(bytes_, grid_);
    // Grids that are built take 4 to 6, but there are trees with as many faces as the square of
    // their splits.
    constexpr std::uint64_t kStepsAnItem = 250;
    const std::uint64_t limit = kStepsAnItem * (grid_.cells.size() + grid_.hits.size());
    if (!for_each_face(grid_, boxes_, links, limit)) {
      bytes_.fail("the cells have far more sides in common than those of grids that are built");
    }
    links.finish();
    links.read_rims();
    links.read_corners();
    if (several_operands_) read_operands();
  }

  void read_operands() {
    constexpr std::size_t kLeastBytes = 64;  // of a report: its measures alone take 48
    const auto operands = take_index(kAnyIndex, "the number of operands");
    if (operands == 0) bytes_.fail("there are no operands");
    bytes_.require(operands, kLeastBytes, "operand");
    grid_.operands.resize(operands);
    for (InputReport& operand : grid_.operands) {
      for_each_field(operand, [&](const ReportField&, auto& value) { take_value(value); });
    }
    bytes_.require(grid_.planes.size(), 1, "plane's operand");
    for (std::size_t i = 0; i < grid_.planes.size(); ++i) {
      grid_.source_operands.push_back(take_operand(bytes_, operands));
    }
  }
  void take_value(Index& count) { count = take_index(kAnyIndex, "a count of the report"); }
  void take_value(bool& flag) { flag = take_index(1, "a flag of the report") != 0; }
  void take_value(double& measure) {
    measure = take_real(bytes_, 0, std::numeric_limits<double>::max(), "a measure of the report");
  }

  ByteReader& bytes_;
  GridData& grid_;
  bool several_operands_ = false;
  std::vector<LatticeBox> boxes_;
  std::int64_t source_before_ = 0;  // the source face of the last plane read
};

// Throws unless the payload is whole and undamaged.
void check_header(ByteReader& bytes, std::string_view all) {
  if (all.substr(0, format::kMagic.size()) != format::kMagic) {
    bytes.fail("this is no saved grid: it does not begin as one");
  }
  bytes.require(1, format::kHeaderBytes, "header");
  bytes.skip(format::kMagic.size());
  const auto version = bytes.take_unsigned<std::uint32_t>();
  if (version != format::kVersion) {
    bytes.fail_at(
        format::kMagic.size(),
        compose("the format's version is {}; this library knows {}", version, format::kVersion));
  }
  const auto size = bytes.take_unsigned<std::uint64_t>();
  const auto checksum = bytes.take_unsigned<std::uint64_t>();
  if (size != bytes.bytes_left()) {
    bytes.fail(
        compose("{} bytes should follow, but there are {}: the file was cut off or "
                "something was added",
                size, bytes.bytes_left()));
  }
  if (format::checksum(all.substr(bytes.offset())) != checksum) {
    bytes.fail("the file is damaged: its checksum is another");
  }
}

}  // namespace

Grid load_grid(std::span<const std::uint8_t> from, std::string_view name) try {
  const std::string_view all(reinterpret_cast<const char*>(from.data()), from.size());
  ByteReader bytes(all, name, ByteOrder::kLittle, 0);
  check_header(bytes, all);
  auto grid = std::make_unique<GridData>();
  GridReader(bytes, *grid).read();
  try {
    validate(*grid);
  } catch (const Error& error) {
    throw Error(ErrorCode::kParseError, compose("{}: {}", name, error.what()));
  }
  return Grid(std::move(grid));
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, compose("{}: not enough memory to load it", name));
}

}  // namespace kdm
