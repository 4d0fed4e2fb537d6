// SPDX-License-Identifier: MIT
// Looking for clashes, in all of a mesh or where it has changed.
#include "extract/embed/clashes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "extract/mend/triangle_shape.h"
#include "geometry/triangle_triangle.h"

namespace kdm {
namespace {

using Test = TriangleCrossing<RealKernel>;

// A triangle with what is asked of it again and again.
class Plate {
 public:
  explicit Plate(const std::array<Vec3, 3>& corners)
      : corners_(corners),
        lo_(corners[0].cwiseMin(corners[1]).cwiseMin(corners[2])),
        hi_(corners[0].cwiseMax(corners[1]).cwiseMax(corners[2])) {
    const Vec3 u = corners[1] - corners[0];
    const Vec3 v = corners[2] - corners[0];
    normal_ = u.cross(v);
    // Far above what rounding does to the products below.
    slack_ = 0x1p-46 * u.cwiseAbs().sum() * v.cwiseAbs().sum();
  }

  const std::array<Vec3, 3>& corners() const { return corners_; }

  // Do boxes or the plane show that the triangle (a, b, c), which shares no corner, is elsewhere?
  bool surely_apart(const Vec3& a, const Vec3& b, const Vec3& c) const {
    for (int i = 0; i < 3; ++i) {
      if ((a[i] > hi_[i] && b[i] > hi_[i] && c[i] > hi_[i]) ||
          (a[i] < lo_[i] && b[i] < lo_[i] && c[i] < lo_[i])) {
        return true;
      }
    }
    const int first = side(a);
    return first != 0 && side(b) == first && side(c) == first;
  }

 private:
  // Of the plane; 0 where that is not sure.
  int side(const Vec3& p) const {
    const Vec3 d = p - corners_[0];
    const double height = normal_.dot(d);
    const double slack = slack_ * d.cwiseAbs().maxCoeff();
    return height > slack ? 1 : (height < -slack ? -1 : 0);
  }

  std::array<Vec3, 3> corners_;
  Vec3 lo_;
  Vec3 hi_;
  Vec3 normal_;
  double slack_;
};

// A corner of both, or kNone.
Index shared_corner(const Triangle& a, const Triangle& b) {
  for (const Index v : a) {
    if (v == b[0] || v == b[1] || v == b[2]) return v;
  }
  return kNone;
}

Triangle numbers(const DualMesh& mesh, Index t) {
  return {mesh.vertex[3 * t], mesh.vertex[3 * t + 1], mesh.vertex[3 * t + 2]};
}

// A power of two, so that products stay in range and nothing is rounded.
double scale_for(const Lattice& lattice) {
  int exponent = 0;
  std::frexp(lattice.origin.cwiseAbs().maxCoeff() + lattice.step * kLatticeSize, &exponent);
  return std::ldexp(1.0, -exponent);
}

}  // namespace

Clashes::Clashes(const GridView& view, const DualMesh& loops, const EditLog& log)
    : view_(view),
      loops_(loops),
      envelopes_(view, loops, log),
      triangles_(static_cast<Index>(view.grid.hits.size())),
      sure_(rounds_little(view.grid.lattice)),
      scale_(scale_for(view.grid.lattice)),
      enclosed_(view.grid.hits.size(), 0),
      changed_(view.grid.hits.size(), 0),
      parent_(view.grid.cells.size(), kNone),
      first_(view.grid.cells.size(), kNone) {
  for (Index c = 0; c < view.grid.cells.size(); ++c) {
    const Cell& cell = view.grid.cells[c];
    if (!cell.leaf()) parent_[cell.below()] = parent_[cell.above()] = c;
  }
}

void Clashes::find(const DualMesh& mesh) {
  std::vector<Index> hits(view_.grid.hits.size());
  std::iota(hits.begin(), hits.end(), Index{0});
  find_again(mesh, hits);
}

void Clashes::find_again(const DualMesh& mesh, const std::vector<Index>& hits) {
  triangles_.read(mesh);
  const std::vector<Index> around = with_neighbours(hits);
  forget(mesh);
  places_.resize(mesh.position.size());
  suspect_.resize(mesh.triangles(), 0);
  seen_.assign(mesh.triangles(), kNone);
  spread_.assign(mesh.vertices(), kUnknown);
  pool_.clear();
  pool_begin_.assign(view_.grid.cells.size(), kNone);
  for (const Index h : around) {
    triangles_.for_each(h, [&](Index t) { place(mesh, t); });
  }
  for (const Index leaf : crowded_leaves(around)) envelopes_.separate(mesh, triangles_, leaf);
  const bool had_suspects = !entries_.empty();
  for (const Index h : around) {
    enclosed_[h] = sure_ && envelopes_.holds(mesh, triangles_, h) ? 1 : 0;
  }
  for (const Index h : around) {
    if (enclosed_[h] != 0 && !had_suspects) continue;
    triangles_.for_each(h, [&](Index t) {
      if (enclosed_[h] != 0) {
        look_for_suspects(mesh, t);
        return;
      }
      if (without_area(mesh, t)) flat_.push_back(t);
      look_round(mesh, t);
    });
  }
  for (const Index h : around) changed_[h] = 0;
}

std::vector<Index> Clashes::triangles() const {
  std::vector<Index> triangles = flat_;
  for (const auto& [t, other] : pairs_) triangles.insert(triangles.end(), {t, other});
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  return triangles;
}

// The hits, those across strips from them, and those round loops beside theirs in a leaf.
std::vector<Index> Clashes::with_neighbours(const std::vector<Index>& hits) {
  std::vector<Index> around;
  const auto add = [&](Index h) {
    if (changed_[h] != 0) return;
    changed_[h] = 1;
    around.push_back(h);
  };
  for (const Index h : hits) add(h);
  if (around.size() == view_.grid.hits.size()) return around;
  for (const Index leaf : crowded_leaves(hits)) envelopes_.for_each_hit(leaf, add);
  for (std::size_t n = 0; n < around.size(); ++n) {
    const Index h = around[n];
    for (Index i = 0; i < 3; ++i) {
      if ((loops_.strip[h] >> i & 1) != 0) add(loops_.opposite[3 * h + i] / 3);
    }
  }
  std::sort(around.begin(), around.end());
  return around;
}

// Those of the hits' leaves that hold several loops.
std::vector<Index> Clashes::crowded_leaves(const std::vector<Index>& hits) const {
  std::vector<Index> leaves;
  for (const Index h : hits) {
    for (Index i = 0; i < 3 && !loops_.dropped(h); ++i) {
      const Index leaf = loops_.leaf[loops_.vertex[3 * h + i]];
      if (envelopes_.has_several_loops(leaf)) leaves.push_back(leaf);
    }
  }
  std::sort(leaves.begin(), leaves.end());
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
  return leaves;
}

// All about what has changed or is no more.
void Clashes::forget(const DualMesh& mesh) {
  const auto gone = [&](Index t) { return mesh.dropped(t) || changed_[mesh.hit[t]] != 0; };
  std::erase_if(pairs_, [&](const auto& pair) { return gone(pair.first) || gone(pair.second); });
  std::erase_if(flat_, gone);
  for (Index t = 0; t < suspect_.size(); ++t) {
    if (suspect_[t] != 0 && gone(t)) suspect_[t] = 0;
  }
}

void Clashes::place(const DualMesh& mesh, Index triangle) {
  for (Index h = 3 * triangle; h < 3 * triangle + 3; ++h) {
    const Index v = mesh.vertex[h];
    places_[v] = scale_ * single_precision(view_.grid.lattice, mesh.position[v]);
  }
}

// Where the pool has the number of triangles that keep to envelopes and may lie in the leaf, and
// then these, some of them twice.
Index Clashes::enclosed_in(Index leaf) {
  Index& begin = pool_begin_[leaf];
  if (begin != kNone) return begin;
  begin = static_cast<Index>(pool_.size());
  pool_.push_back(0);
  const auto add = [&](Index hit) {
    triangles_.for_each(hit, [&](Index t) { pool_.push_back(t); });
  };
  envelopes_.for_each_hit(leaf, [&](Index hit) {
    if (enclosed_[hit] == 0) return;
    add(hit);
    for (Index i = 0; i < 3; ++i) {
      if ((loops_.strip[hit] >> i & 1) != 0) add(loops_.opposite[3 * hit + i] / 3);
    }
  });
  pool_[begin] = static_cast<Index>(pool_.size()) - begin - 1;
  return begin;
}

// Holds a new suspect against all there is in the leaves that its box meets, and notes it there.
void Clashes::look_round(const DualMesh& mesh, Index suspect) {
  suspect_[suspect] = 1;
  Vec3 lo = mesh.position[mesh.vertex[3 * suspect]];
  Vec3 hi = lo;
  for (Index i = 1; i < 3; ++i) {
    const Vec3& p = mesh.position[mesh.vertex[3 * suspect + i]];
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  lo -= Vec3::Constant(kClear);
  hi += Vec3::Constant(kClear);
  const Plate plate(corners(mesh, suspect));
  const Triangle own = numbers(mesh, suspect);
  const auto meet = [&](Index t) {
    if (seen_[t] == suspect || t == suspect) return;
    seen_[t] = suspect;
    const Triangle other = numbers(mesh, t);
    const Index shared = shared_corner(own, other);
    if (shared != kNone
            ? spread(mesh, shared)
            : plate.surely_apart(places_[other[0]], places_[other[1]], places_[other[2]])) {
      return;
    }
    test(mesh, suspect, t);
  };
  const auto visit = [&](Index leaf) {
    const Index begin = enclosed_in(leaf);
    for (Index i = begin + 1; i <= begin + pool_[begin]; ++i) meet(pool_[i]);
    for (Index* e = &first_[leaf]; *e != kNone;) {
      Entry& entry = entries_[*e];
      if (suspect_[entry.suspect] == 0 || entry.suspect == suspect) {
        *e = entry.next;
        continue;
      }
      meet(entry.suspect);
      e = &entry.next;
    }
    entries_.push_back({suspect, first_[leaf]});
    first_[leaf] = static_cast<Index>(entries_.size() - 1);
  };
  const Index leaf = loops_.leaf[loops_.vertex[3 * mesh.hit[suspect]]];
  std::array<Index, kMaxDepth + 1> left;  // to be descended into
  left[0] = cell_round(leaf, lo, hi);
  for (std::size_t count = 1; count > 0;) {
    Index c = left[--count];
    while (!view_.grid.cells[c].leaf()) {
      const Cell& cell = view_.grid.cells[c];
      const double value = cell.value();
      const bool above = hi[cell.axis()] >= value;
      if (lo[cell.axis()] <= value) {
        if (above) left[count++] = cell.above();
        c = cell.below();
      } else {
        c = cell.above();
      }
    }
    visit(c);
  }
}

// The smallest cell round the leaf that holds all of the box: near the leaf, while the root is far.
Index Clashes::cell_round(Index leaf, const Vec3& lo, const Vec3& hi) const {
  Index cell = leaf;
  while (cell != 0 && !((lo.array() > to_vec3(view_.boxes[cell].lo).array()).all() &&
                        (hi.array() < to_vec3(view_.boxes[cell].hi).array()).all())) {
    cell = parent_[cell];
  }
  return cell;
}

// A changed triangle that keeps to its envelope, and the suspects of before.
void Clashes::look_for_suspects(const DualMesh& mesh, Index triangle) {
  const Index hit = mesh.hit[triangle];
  const Plate plate(corners(mesh, triangle));
  const Triangle own = numbers(mesh, triangle);
  const auto look_in = [&](Index leaf) {
    for (Index e = first_[leaf]; e != kNone; e = entries_[e].next) {
      const Index t = entries_[e].suspect;
      if (suspect_[t] == 0 || changed_[mesh.hit[t]] != 0 || seen_[t] == triangle) continue;
      seen_[t] = triangle;
      const Triangle other = numbers(mesh, t);
      if (shared_corner(own, other) == kNone &&
          plate.surely_apart(places_[other[0]], places_[other[1]], places_[other[2]])) {
        continue;
      }
      test(mesh, t, triangle);
    }
  };
  for (Index i = 0; i < 3; ++i) {
    look_in(loops_.leaf[loops_.vertex[3 * hit + i]]);
    if ((loops_.strip[hit] >> i & 1) == 0) continue;
    // Two hits across a strip share four leaves; the fourth is beyond it.
    const Index across = loops_.opposite[3 * hit + i];
    look_in(loops_.leaf[loops_.vertex[previous_in_triangle(across)]]);
  }
}

// Seen from some side, do the triangles round the vertex lie beside each other, all turned rightly?
// Then no two of them meet elsewhere.
bool Clashes::spread(const DualMesh& mesh, Index v) {
  constexpr double kSure = 1e-6;
  if (spread_[v] != kUnknown) return spread_[v] == kYes;
  spread_[v] = kNo;
  Vec3 normal = Vec3::Zero();
  if (mesh.on_boundary(v)) return false;
  for (const HalfEdgeId h : mesh.ring(v)) normal += view_.grid.plane_of(mesh.hit[h / 3]).normal;
  // Turned rightly, each takes less than half a turn: a ring that rises once winds once.
  int axis = 0;
  normal.cwiseAbs().minCoeff(&axis);
  const Vec3 across = normal.cross(Vec3::Unit(axis));
  const double size = normal.cwiseAbs().sum();
  const Vec3& apex = mesh.position[v];
  int rises = 0;
  for (const HalfEdgeId h : mesh.ring(v)) {
    const Vec3 a = mesh.position[mesh.end_vertex(h)] - apex;
    const Vec3 b = mesh.position[mesh.vertex[previous_in_triangle(h)]] - apex;
    const double area = a.cross(b).dot(normal);
    if (!(area > kSure * size * (a.squaredNorm() + b.squaredNorm()))) return false;
    rises += across.dot(a) < 0 && across.dot(b) >= 0 ? 1 : 0;
  }
  if (rises == 1) spread_[v] = kYes;
  return rises == 1;
}

void Clashes::test(const DualMesh& mesh, Index t, Index other) {
  const Corners a = corners(mesh, t);
  const Corners b = corners(mesh, other);
  if (Test::test(a, numbers(mesh, t), b, numbers(mesh, other))) pairs_.emplace_back(t, other);
}

Clashes::Corners Clashes::corners(const DualMesh& mesh, Index t) const {
  const Triangle n = numbers(mesh, t);
  return {places_[n[0]], places_[n[1]], places_[n[2]]};
}

bool Clashes::without_area(const DualMesh& mesh, Index t) const {
  const Corners c = corners(mesh, t);
  return is_flat(c[0], c[1], c[2]);
}

}  // namespace kdm
