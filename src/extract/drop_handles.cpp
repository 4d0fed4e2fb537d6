// SPDX-License-Identifier: MIT
// Cuts handles at short loops, smaller ones first, and closes the rims.
#include "extract/drop_handles.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "extract/short_loops.h"
#include "geometry/exact_sign.h"
#include "geometry/triangle.h"
#include "geometry/triangle_triangle.h"
#include "mesh/box_tree.h"
#include "mesh/boxes.h"
#include "mesh/marks.h"
#include "mesh/scale.h"
#include "mesh/sides.h"
#include "mesh/sort.h"
#include "prepare/least_area_patch.h"

namespace kdm {
namespace {

// A loop at which the mesh is to be cut.
struct Cut {
  const ShortLoop* loop = nullptr;
  bool around_centre = false;  // its rims are closed by triangles round a vertex of their own
  bool fails = false;

  // Takes the next way to close the rims, if there is one.
  void try_next() {
    fails = around_centre;
    around_centre = true;
  }
};

// Cuts handles of a copy of a mesh, at loops no two of which have neighbouring vertices.
class Cutting {
 public:
  Cutting(const Mesh& mesh, const ShortLoops& loops, const HandleSettings& settings)
      : mesh_(mesh), loops_(loops), settings_(settings), made_by_(mesh.triangles.size(), kNone) {}

  // Makes the cut, or tells that its rims cannot be closed so. `number` is what `failing` says of
  // it.
  bool make(const Cut& cut, Index number);
  // Tells the numbers of the cuts whose triangles have no area or meet others.
  std::vector<Index> failing() const;
  Mesh take() { return std::move(mesh_); }

 private:
  // Where a vertex of the loop goes, of the piece of surface on the left and of that on the right,
  // and the sides that start from it on the right.
  struct Parting {
    Vec3 left;
    Vec3 right;
    std::vector<SideId> right_sides;
  };

  std::optional<Parting> part(const ShortLoop& loop, std::size_t i) const;
  std::vector<SideId> fan(VertexId v, VertexId first, VertexId last) const;
  Vec3 drawn_along(const std::vector<SideId>& bank, VertexId v, VertexId before,
                   VertexId next) const;
  std::optional<std::vector<Triangle>> patch(const ShortLoop& loop) const;
  void close(const std::vector<VertexId>& rim, const std::vector<Triangle>& patch, Index number);
  VertexId add_vertex(const Vec3& position);
  void add_triangle(const Triangle& t, Index number);
  Vec3 rounded(const Vec3& p) const {
    return settings_.single ? Vec3(p.cast<float>().cast<double>()) : p;
  }

  Mesh mesh_;
  const ShortLoops& loops_;  // of the mesh as it was
  const HandleSettings& settings_;
  std::vector<Index> made_by_;  // per triangle: the cut that made or moved it
};

bool Cutting::make(const Cut& cut, Index number) {
  const std::vector<VertexId>& loop = cut.loop->vertices;
  std::vector<Parting> partings;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    std::optional<Parting> parting = part(*cut.loop, i);
    if (!parting) return false;
    partings.push_back(std::move(*parting));
  }
  std::vector<Triangle> cover;
  if (!cut.around_centre) {
    std::optional<std::vector<Triangle>> found = patch(*cut.loop);
    if (!found) return false;
    cover = std::move(*found);
  }
  std::vector<VertexId> right;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    for (const SideId side : loops_.sides_from(loop[i])) made_by_[triangle_of(side)] = number;
    mesh_.positions[loop[i]] = partings[i].left;
    right.push_back(add_vertex(partings[i].right));
    for (const SideId side : partings[i].right_sides) {
      mesh_.triangles[triangle_of(side)][static_cast<std::size_t>(corner_of(side))] = right.back();
    }
  }
  close(right, cover, number);
  // The rim on the left runs the other way.
  const auto last = static_cast<Index>(loop.size() - 1);
  for (Triangle& t : cover) t = {last - t[2], last - t[1], last - t[0]};
  close({loop.rbegin(), loop.rend()}, cover, number);
  return true;
}

// Nothing if the surface passes the vertex more than once.
std::optional<Cutting::Parting> Cutting::part(const ShortLoop& loop, std::size_t i) const {
  const std::size_t size = loop.vertices.size();
  const VertexId v = loop.vertices[i];
  const VertexId before = loop.vertices[(i + size - 1) % size];
  const VertexId next = loop.vertices[(i + 1) % size];
  const std::vector<SideId> left = fan(v, next, before);
  const std::vector<SideId> right = fan(v, before, next);
  if (left.size() + right.size() != loops_.sides_from(v).size()) return std::nullopt;
  return Parting{drawn_along(left, v, before, next), drawn_along(right, v, before, next), right};
}

// Returns the sides round v from the one that leads to `first` on, counter-clockwise, without the
// one that leads to `last`. If that one is in another fan, there is one side too many.
std::vector<SideId> Cutting::fan(VertexId v, VertexId first, VertexId last) const {
  const auto all = loops_.sides_from(v);
  SideId side =
      *std::find_if(all.begin(), all.end(), [&](SideId from) { return loops_.end(from) == first; });
  std::vector<SideId> sides;
  while (loops_.end(side) != last && sides.size() <= all.size()) {
    sides.push_back(side);
    side = loops_.opposite(previous_side(side));
  }
  return sides;
}

// Returns where v goes if it is drawn away from the loop towards its neighbours on one bank. The
// first side leads along the loop.
Vec3 Cutting::drawn_along(const std::vector<SideId>& bank, VertexId v, VertexId before,
                          VertexId next) const {
  constexpr double kMost = 0.25;  // of the way
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i < bank.size(); ++i) sum += mesh_.positions[loops_.end(bank[i])];
  const Vec3 towards = bank.size() > 1
                           ? Vec3(sum / static_cast<double>(bank.size() - 1))
                           : Vec3((mesh_.positions[before] + mesh_.positions[next]) / 2);
  const Vec3 way = towards - mesh_.positions[v];
  const double length = way.norm();
  const double part = length > 0 ? std::min(kMost, settings_.shift / length) : 0;
  return rounded(mesh_.positions[v] + part * way);
}

// Returns triangles over the loop's vertices, by their places in the loop, which none of the mesh's
// edges joins; nothing if there are none.
std::optional<std::vector<Triangle>> Cutting::patch(const ShortLoop& loop) const {
  const auto size = static_cast<Index>(loop.vertices.size());
  std::vector<Vec3> points;
  std::vector<PointId> polygon;
  std::vector<std::uint64_t> edges;
  const Vec3& origin = mesh_.positions[loop.vertices[0]];
  for (Index i = 0; i < size; ++i) {
    points.push_back((mesh_.positions[loop.vertices[i]] - origin) / loop.length);
    polygon.push_back(i);
    for (const SideId side : loops_.sides_from(loop.vertices[i])) {
      const auto end = std::find(loop.vertices.begin(), loop.vertices.end(), loops_.end(side));
      const auto j = static_cast<Index>(end - loop.vertices.begin());
      if (i < j && j < size) edges.push_back(std::uint64_t{i} << 32 | j);
    }
  }
  sort_numbers(edges);
  std::vector<Triangle> triangles;
  const std::vector<Vec3> beyond(size, Vec3::Zero());
  LeastAreaPatch(points, edges).make(polygon, beyond, triangles);
  for (const Triangle& t : triangles) {
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(t[i], t[next_corner(i)]);
      const bool on_loop = high == low + 1 || (low == 0 && high == size - 1);
      const bool taken =
          std::binary_search(edges.begin(), edges.end(), std::uint64_t{low} << 32 | high);
      if (taken && !on_loop) return std::nullopt;
    }
  }
  return triangles;
}

// Closes a rim by the triangles of a patch, given by places in the rim; or, if there are none, by
// triangles round a new vertex.
void Cutting::close(const std::vector<VertexId>& rim, const std::vector<Triangle>& patch,
                    Index number) {
  for (const Triangle& t : patch) add_triangle({rim[t[0]], rim[t[1]], rim[t[2]]}, number);
  if (!patch.empty()) return;
  Vec3 sum = Vec3::Zero();
  for (const VertexId v : rim) sum += mesh_.positions[v];
  const VertexId centre = add_vertex(rounded(sum / static_cast<double>(rim.size())));
  for (std::size_t i = 0; i < rim.size(); ++i) {
    add_triangle({rim[i], rim[(i + 1) % rim.size()], centre}, number);
  }
}

VertexId Cutting::add_vertex(const Vec3& position) {
  mesh_.positions.push_back(position);
  return static_cast<VertexId>(mesh_.positions.size() - 1);
}

void Cutting::add_triangle(const Triangle& t, Index number) {
  const auto& p = mesh_.positions;
  mesh_.triangles.push_back(t);
  made_by_.push_back(number);
  if (!mesh_.source_faces.empty()) mesh_.source_faces.push_back(kNone);
  if (!mesh_.source_operands.empty()) mesh_.source_operands.push_back(kNone);
  if (mesh_.corner_normals.empty()) return;
  const Eigen::Vector3f n = unit_normal(p[t[0]], p[t[1]], p[t[2]]).cast<float>();
  mesh_.corner_normals.insert(mesh_.corner_normals.end(), 3, {n[0], n[1], n[2]});
}

std::vector<Index> Cutting::failing() const {
  const std::vector<Vec3> positions = scale_to_one(mesh_.positions).positions;
  const auto corners = [&](TriangleId t) {
    const Triangle& numbers = mesh_.triangles[t];
    return std::array<Vec3, 3>{positions[numbers[0]], positions[numbers[1]], positions[numbers[2]]};
  };
  std::vector<TriangleId> made;
  std::vector<Box> boxes;
  std::vector<Index> cuts;
  for (TriangleId t = 0; t < mesh_.triangles.size(); ++t) {
    if (made_by_[t] == kNone) continue;
    const auto [a, b, c] = corners(t);
    made.push_back(t);
    boxes.push_back(box_of(a, b, c));
    if (!has_area(a, b, c)) cuts.push_back(made_by_[t]);
  }
  const BoxTree tree(boxes);
  for (TriangleId t = 0; t < mesh_.triangles.size(); ++t) {
    const auto own = corners(t);
    tree.for_each_meeting(box_of(own[0], own[1], own[2]), [&](Index i) {
      if (made[i] != t &&
          TriangleCrossing<RealKernel>::test(own, mesh_.triangles[t], corners(made[i]),
                                             mesh_.triangles[made[i]])) {
        cuts.push_back(made_by_[made[i]]);
      }
    });
  }
  make_set(cuts);
  return cuts;
}

// Returns a number by which a loop is known, wherever it begins.
std::uint64_t name_of(const ShortLoop& loop) {
  std::uint64_t name = 0;
  for (const VertexId v : loop.vertices) name += mixed_bits(v);
  return name;
}

// Removes handles of a mesh.
class Removal {
 public:
  Removal(const HandleSettings& settings, const Progress& progress, Mesh& mesh)
      : settings_(settings), progress_(progress), mesh_(mesh) {}

  DroppedHandles run();

 private:
  // How many cuts are chosen at a time: fewer than the bits of a kind, of which more could not be
  // told to be independent.
  static constexpr std::size_t kMostCuts = 32;

  bool remove(double below);
  void leave_out_failed(std::vector<ShortLoop>& loops);
  Index count_left() const;
  std::vector<Cut> choose(std::vector<ShortLoop>& loops, const ShortLoops& of) const;
  Index make(std::vector<Cut> cuts, const ShortLoops& loops);

  const HandleSettings& settings_;
  const Progress& progress_;
  Mesh& mesh_;
  KindSpan given_up_;                  // kinds of loops at which the mesh cannot be cut
  std::vector<std::uint64_t> failed_;  // which loops these were, by their vertices
  Index dropped_ = 0;
};

// Begins with small handles: where they are, searches end soon. Once they are gone, they neither
// are found again nor hide larger ones.
DroppedHandles Removal::run() {
  constexpr double kFirst = 1.0 / 512;  // of the diagonal
  Box bounds;
  for (const Vec3& p : mesh_.positions) grow(bounds, p);
  const double most = settings_.smaller_than;
  double below = std::min(most, kFirst * (bounds.max - bounds.min).norm());
  while (remove(below) && below < most) below = std::min(most, 2 * below);
  return {dropped_, given_up_.size() == 0 ? 0 : count_left()};
}

// Counts the handles that are smaller than asked for.
Index Removal::count_left() const {
  ShortLoops loops(mesh_.positions, mesh_.triangles);
  std::vector<ShortLoop> left = loops.find(settings_.smaller_than, {});
  std::size_t count = 0;
  for (bool all = false; !all;) {
    const std::vector<Cut> cuts = choose(left, loops);
    count += cuts.size();
    all = cuts.size() < kMostCuts;
    if (!all) left.erase(left.begin(), left.begin() + (cuts.back().loop - left.data()) + 1);
  }
  return static_cast<Index>(std::min<std::size_t>(count, loops.handles()));
}

// Removes the handles below a size, and tells whether there may be larger ones.
bool Removal::remove(double below) {
  constexpr int kMostFailures = 8;  // in a row, each with other kinds of loops
  for (int failures = 0; failures < kMostFailures;) {
    report_progress(progress_, 0.95, "faces");
    ShortLoops loops(mesh_.positions, mesh_.triangles);
    std::vector<ShortLoop> found = loops.find(below, given_up_);
    if (found.empty()) return loops.limited();
    leave_out_failed(found);
    if (found.empty()) continue;
    const Index made = make(choose(found, loops), loops);
    dropped_ += made;
    if (made > 0) given_up_ = {};  // kinds are others now
    failures = made > 0 ? 0 : failures + 1;
  }
  return true;
}

// Gives up the kinds of loops at which the mesh could not be cut before.
void Removal::leave_out_failed(std::vector<ShortLoop>& loops) {
  const auto kept = std::remove_if(loops.begin(), loops.end(), [&](const ShortLoop& loop) {
    if (std::find(failed_.begin(), failed_.end(), name_of(loop)) == failed_.end()) return false;
    given_up_.add(loop.kind);
    return true;
  });
  loops.erase(kept, loops.end());
}

// Chooses loops, short ones first, that have no neighbouring vertices and none of which divides
// what the cuts before leave: its kind is no sum of theirs.
std::vector<Cut> Removal::choose(std::vector<ShortLoop>& loops, const ShortLoops& of) const {
  sort_by(loops, [](const ShortLoop& a, const ShortLoop& b) { return a.length < b.length; });
  Marks beside(mesh_.positions.size());
  KindSpan kinds;
  std::vector<Cut> cuts;
  for (const ShortLoop& loop : loops) {
    const auto is_beside = [&](VertexId v) { return beside.test(v); };
    if (std::any_of(loop.vertices.begin(), loop.vertices.end(), is_beside)) continue;
    if (!kinds.add(loop.kind)) continue;
    for (const VertexId v : loop.vertices) {
      beside.set(v);
      for (const SideId side : of.sides_from(v)) beside.set(of.end(side));
    }
    cuts.push_back({.loop = &loop});
    if (cuts.size() == kMostCuts) break;
  }
  return cuts;
}

// Makes all of the cuts that can be made, and returns how many.
Index Removal::make(std::vector<Cut> cuts, const ShortLoops& loops) {
  for (;;) {
    Cutting cutting(mesh_, loops, settings_);
    bool all = true;
    Index made = 0;
    for (Index i = 0; i < cuts.size(); ++i) {
      if (cuts[i].fails) continue;
      if (cutting.make(cuts[i], i)) {
        ++made;
      } else {
        cuts[i].try_next();
        all = false;
      }
    }
    if (!all) continue;
    const std::vector<Index> failing = cutting.failing();
    for (const Index i : failing) cuts[i].try_next();
    if (!failing.empty()) continue;
    for (const Cut& cut : cuts) {
      if (!cut.fails) continue;
      failed_.push_back(name_of(*cut.loop));
      given_up_.add(cut.loop->kind);
    }
    if (made > 0) mesh_ = cutting.take();
    return made;
  }
}

}  // namespace

DroppedHandles drop_handles(const HandleSettings& settings, const Progress& progress, Mesh& mesh) {
  return Removal(settings, progress, mesh).run();
}

}  // namespace kdm
