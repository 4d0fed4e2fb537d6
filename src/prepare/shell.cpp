// SPDX-License-Identifier: MIT
// The shell is the sum of prisms, two a triangle, and of tetrahedra where prisms leave gaps. All of
// these count positively: their union is the set of the points whose winding number is positive.
// What two of them share, on the surface itself or across a joined side, is no part of the shell's
// outline.
#include "prepare/shell.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "mesh/numbers.h"
#include "mesh/sides.h"
#include "mesh/sort.h"
#include "prepare/fans.h"
#include "prepare/shell_layer.h"

namespace kdm {
namespace {

// A layer, and the vertices of its face.
struct Coat {
  Coat(const PiecesOfSurface& surface, double height)
      : layer(surface, height), vertices(layer.fans().size(), kNone), is_front(height > 0) {}

  Index vertex(SideId corner) const { return vertices[layer.fans().of(corner)]; }

  ShellLayer layer;
  std::vector<Index> vertices;  // per fan of the layer
  bool is_front;
};

// A triangle of the shell, and the triangle of the surface that it comes from.
struct ShellTriangle {
  Triangle corners;
  TriangleId source;
};

class ShellMaker {
 public:
  ShellMaker(const PiecesOfSurface& surface, double thickness, std::span<const Index> source,
             const Marks& wanted)
      : surface_(surface),
        source_(source),
        wanted_(wanted),
        front_(surface, thickness / 2),
        back_(surface, -thickness / 2) {}

  Mesh run() {
    add_vertices(front_);
    add_vertices(back_);
    add_middles();
    for (TriangleId t = 0; t < surface_.size(); ++t) {
      if (!wanted_.test(t)) continue;
      for (const Coat* coat : {&front_, &back_}) {
        add(*coat, t, {coat->vertex(3 * t), coat->vertex(3 * t + 1), coat->vertex(3 * t + 2)});
      }
      for (SideId side = 3 * t; side < 3 * t + 3; ++side) {
        if (surface_.opposite()[side] == kNone) {
          add_outer_wall(t, side);
        } else {
          add_cut(front_, side);
          add_cut(back_, side);
        }
      }
    }
    fill_pyramids(front_);
    fill_pyramids(back_);
    take_inner_triangles();
    return std::move(mesh_);
  }

 private:
  void add_vertices(Coat& coat) {
    const Fans& fans = coat.layer.fans();
    for (Index fan = 0; fan < fans.size(); ++fan) {
      if (!wanted_.test(triangle_of(fans.first(fan)))) continue;
      coat.vertices[fan] = add_vertex(coat.layer.place(fans.first(fan)));
    }
  }

  Index add_vertex(const Vec3& place) {
    mesh_.positions.push_back(place);
    return static_cast<Index>(mesh_.positions.size() - 1);
  }

  // Walls meet on the surface where a layer is cut within a piece. There, and nowhere else, fans of
  // the surface have a vertex of their own.
  void add_middles() {
    const Fans& fans = surface_.fans();
    Marks cut(fans.size());
    for (SideId side = 0; side < 3 * surface_.size(); ++side) {
      if (surface_.opposite()[side] == kNone) continue;
      if (!front_.layer.ends_at(side) && !back_.layer.ends_at(side)) continue;
      cut.set(fans.of(side));
      cut.set(fans.of(next_side(side)));
    }
    middle_.assign(fans.size(), kNone);
    for (Index fan = 0; fan < fans.size(); ++fan) {
      if (!cut.test(fan) || !wanted_.test(triangle_of(fans.first(fan)))) continue;
      middle_[fan] = add_vertex(surface_.place(fans.first(fan)));
    }
  }

  // Adds the wall from face to face where a piece ends.
  void add_outer_wall(TriangleId t, SideId side) {
    const SideId end = next_side(side);
    add(front_, t,
        {middle(end), front_.vertex(end), front_.vertex(side), middle(side), back_.vertex(side),
         back_.vertex(end)});
  }

  // Adds a prism's wall where a layer is cut within a piece, and fills the wedge that it leaves
  // before the other prism's wall, if they do not overlap. The tetrahedra's sides are those that
  // the walls are made of.
  void add_cut(const Coat& coat, SideId side) {
    if (!coat.layer.ends_at(side)) return;
    const SideId other = surface_.opposite()[side];
    const std::array<Index, 2> middles = {middle(side), middle(next_side(side))};
    const std::array<Index, 2> here = {coat.vertex(side), coat.vertex(next_side(side))};
    add_inner(coat, triangle_of(side), {middles[1], here[1], here[0]});
    add_inner(coat, triangle_of(side), {middles[1], here[0], middles[0]});
    if (other < side) return;
    const std::array<Index, 2> there = {coat.vertex(next_side(other)), coat.vertex(other)};
    fill(coat, triangle_of(side), {middles[0], here[0], there[0], there[1]});
    fill(coat, triangle_of(side), {middles[0], middles[1], here[0], there[1]});
    fill(coat, triangle_of(side), {middles[1], here[0], there[1], here[1]});
  }

  // Fills what wedges leave round a vertex that a layer's prisms bend away from on all sides.
  void fill_pyramids(const Coat& coat) {
    std::vector<SideId> corners;  // the first ones of the layer's fans
    for (Index fan = 0; fan < middle_.size(); ++fan) {
      const SideId first = surface_.fans().first(fan);
      if (middle_[fan] == kNone || surface_.opposite()[first] == kNone) continue;
      corners.clear();
      surface_.fans().for_each_corner(fan, surface_.opposite(), [&](SideId corner) {
        if (coat.layer.ends_at(corner)) corners.push_back(corner);
      });
      for (std::size_t i = 2; i < corners.size(); ++i) {
        fill(coat, triangle_of(corners[i]),
             {middle_[fan], coat.vertex(corners[0]), coat.vertex(corners[i - 1]),
              coat.vertex(corners[i])});
      }
    }
  }

  // Adds a tetrahedron if it counts positively. Its last three corners are given as they are seen
  // from the first one at the back of the surface.
  void fill(const Coat& coat, TriangleId t, const std::array<Index, 4>& corners) {
    const auto [p, q, r, s] = corners;
    const std::vector<Vec3>& at = mesh_.positions;
    const double volume = (at[q] - at[p]).dot((at[r] - at[p]).cross(at[s] - at[p]));
    if (!(coat.is_front ? volume > 0 : volume < 0)) return;
    add_inner(coat, t, {p, r, q});
    add_inner(coat, t, {p, q, s});
    add_inner(coat, t, {p, s, r});
    add_inner(coat, t, {q, r, s});
  }

  // Adds a triangle that may have another one at its back.
  void add_inner(const Coat& coat, TriangleId t, const Triangle& corners) {
    inner_.push_back({turned(coat, corners), t});
  }

  // Adds a polygon that comes from triangle `t`. Corners that are `kNone` are left out.
  void add(const Coat& coat, TriangleId t, std::initializer_list<Index> corners) {
    outline_.clear();
    std::copy_if(corners.begin(), corners.end(), std::back_inserter(outline_),
                 [](Index corner) { return corner != kNone; });
    for (std::size_t i = 2; i < outline_.size(); ++i) {
      take({turned(coat, {outline_[0], outline_[i - 1], outline_[i]}), t});
    }
  }

  // All is described for the front of the surface; at the back it is turned.
  static Triangle turned(const Coat& coat, const Triangle& t) {
    return coat.is_front ? t : Triangle{t[0], t[2], t[1]};
  }

  void take(const ShellTriangle& triangle) {
    mesh_.triangles.push_back(triangle.corners);
    mesh_.source_faces.push_back(source_[triangle.source]);
  }

  // Takes the inner triangles but for those that lie back to back.
  void take_inner_triangles() {
    const auto key = [](const ShellTriangle& triangle) {
      Triangle corners = triangle.corners;
      sort_numbers(corners);
      return corners;
    };
    const auto is_even = [](const Triangle& t) {
      return (t[0] < t[1]) + (t[1] < t[2]) + (t[2] < t[0]) == 2;
    };
    sort_by(inner_,
            [&](const ShellTriangle& a, const ShellTriangle& b) { return key(a) < key(b); });
    for (std::size_t begin = 0, end = 0; begin < inner_.size(); begin = end) {
      int turns = 0;  // how many more are turned one way than the other
      for (; end < inner_.size() && key(inner_[end]) == key(inner_[begin]); ++end) {
        turns += is_even(inner_[end].corners) ? 1 : -1;
      }
      for (std::size_t i = begin; i < end && turns != 0; ++i) {
        if (is_even(inner_[i].corners) != (turns > 0)) continue;
        take(inner_[i]);
        turns += turns > 0 ? -1 : 1;
      }
    }
  }

  Index middle(SideId corner) const { return middle_[surface_.fans().of(corner)]; }

  const PiecesOfSurface& surface_;
  std::span<const Index> source_;
  const Marks& wanted_;
  Coat front_;
  Coat back_;
  std::vector<Index> middle_;  // per fan of the surface; kNone if it has no vertex
  std::vector<ShellTriangle> inner_;
  std::vector<Index> outline_;
  Mesh mesh_;
};

}  // namespace

Mesh make_shell(const PiecesOfSurface& surface, double thickness, std::span<const Index> source,
                const Marks& wanted) {
  return ShellMaker(surface, thickness, source, wanted).run();
}

}  // namespace kdm
