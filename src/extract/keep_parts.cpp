// SPDX-License-Identifier: MIT
// Finds the parts of the result and leaves out crumbs and parts that are not wanted.
#include "extract/keep_parts.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mesh/boxes.h"
#include "mesh/disjoint_sets.h"
#include "mesh/measure.h"
#include "mesh/nesting.h"
#include "mesh/polygons.h"
#include "mesh/scale.h"

namespace kdm {
namespace {

struct Part {
  Measure measure;
  Shell shell;
  double invented_area = 0;
  bool keep = true;

  double size() const { return (shell.bounds.max - shell.bounds.min).norm(); }
};

class Parting {
 public:
  explicit Parting(const Mesh& mesh) : mesh_(mesh), faces_(mesh), part_of_(faces_.size()) {
    find_parts();
    measure();
  }

  void drop_crumbs(double tolerance, KeptParts& kept) {
    constexpr double kLargest = 16;  // tolerances
    for (Part& part : parts_) {
      const double thickness = 2 * std::abs(part.measure.volume) / part.measure.area;
      const double size = part.size();
      if (part.invented_area == 0 || thickness > tolerance) continue;
      if (part.measure.volume > 0 && size > kLargest * tolerance) continue;
      part.keep = false;
      ++kept.crumbs;
    }
  }

  void drop_invented(double most) {
    for (Part& part : parts_) {
      part.keep = part.invented_area <= most * (part.measure.area - part.invented_area);
    }
  }

  void choose(Parts wanted, KeptParts& kept) {
    if (wanted == Parts::kAll || parts_.empty()) return;
    const std::vector<Index> depth = depths();
    const auto larger = [](const Part& a, const Part& b) {
      return a.measure.volume < b.measure.volume;
    };
    const auto largest =
        static_cast<Index>(std::max_element(parts_.begin(), parts_.end(), larger) - parts_.begin());
    for (Index p = 0; p < parts_.size(); ++p) {
      const bool stays = wanted == Parts::kOuter ? depth[p] == 0 : p == largest;
      if (stays || !parts_[p].keep) continue;
      parts_[p].keep = false;
      ++kept.dropped;
    }
  }

  void drop_small(const ExtractOptions& options, KeptParts& kept) {
    std::vector<bool> small;
    for (const Part& part : parts_) {
      small.push_back(part.size() <
                      (part.measure.volume > 0 ? options.drop_parts : options.drop_cavities));
    }
    const std::vector<Index> gone_with = outermost(small);
    for (Index p = 0; p < parts_.size(); ++p) {
      const Index outer = gone_with[p];
      if (outer == kNone || !parts_[p].keep) continue;
      parts_[p].keep = false;
      const bool material = parts_[outer].measure.volume > 0;
      SmallShells& shells = material ? kept.small_parts : kept.small_cavities;
      shells.volume += material ? parts_[p].measure.volume : -parts_[p].measure.volume;
      if (outer == p) ++shells.count;
    }
  }

  bool keeps_all() const {
    return std::all_of(parts_.begin(), parts_.end(), [](const Part& part) { return part.keep; });
  }
  bool keeps(Index face) const { return parts_[part_of_[face]].keep; }
  double invented_area() const {
    double sum = 0;
    for (const Part& part : parts_) sum += part.keep ? part.invented_area : 0;
    return sum;
  }

 private:
  void find_parts() {
    DisjointSets sets(mesh_.positions.size());
    for (Index face = 0; face < faces_.size(); ++face) {
      for (Index i = 1; i < faces_.corners(face); ++i) sets.join(faces_[face][0], faces_[face][i]);
    }
    std::vector<Index> number(mesh_.positions.size(), kNone);
    for (Index face = 0; face < faces_.size(); ++face) {
      const Index set = sets.find(faces_[face][0]);
      if (number[set] == kNone) {
        number[set] = static_cast<Index>(parts_.size());
        parts_.emplace_back();
      }
      part_of_[face] = number[set];
    }
  }

  void measure() {
    faces_.for_each_triangle([&](Index face, const Triangle& t) {
      for (const Index v : t) grow(parts_[part_of_[face]].shell.bounds, mesh_.positions[v]);
    });
    for (Part& part : parts_) part.measure.centre = centre_of(part.shell.bounds);
    faces_.for_each_triangle([&](Index face, const Triangle& t) {
      Part& part = parts_[part_of_[face]];
      const double before = part.measure.area;
      part.measure.add(mesh_.positions[t[0]], mesh_.positions[t[1]], mesh_.positions[t[2]]);
      if (mesh_.source_faces[face] == kNone) part.invented_area += part.measure.area - before;
    });
  }

  // Which lie in which, of the parts for which `counts(part)` holds; nothing if there are too many
  // to find that out.
  template <typename Counts>
  std::optional<std::vector<Enclosure>> enclosures(const Counts& counts) const {
    const ScaledPositions scaled = scale_to_one(mesh_.positions);
    std::vector<Shell> shells;
    for (const Part& part : parts_) {
      shells.push_back(part.shell);
      shells.back().closed = counts(part);
      for (Vec3* corner : {&shells.back().bounds.min, &shells.back().bounds.max}) {
        for (int i = 0; i < 3; ++i) (*corner)[i] = std::ldexp((*corner)[i], -scaled.exponent);
      }
    }
    return find_enclosures(faces_, scaled.positions, part_of_, shells);
  }

  // Per part the small one that it goes with, which lies in no other small one; kNone if it stays.
  // If nobody knows what lies in what, whatever is no larger than the largest small one goes by
  // itself: so nothing that lies in a part that goes is left over.
  std::vector<Index> outermost(const std::vector<bool>& small) const {
    double largest = 0;
    for (Index p = 0; p < parts_.size(); ++p) {
      if (small[p]) largest = std::max(largest, parts_[p].size());
    }
    const auto counts = [&](const Part& part) { return part.size() <= largest; };
    std::vector<Index> with(parts_.size(), kNone);
    const auto pairs = enclosures(counts);
    for (Index p = 0; p < parts_.size(); ++p) {
      if (pairs ? small[p] : counts(parts_[p])) with[p] = p;
    }
    if (!pairs) return with;
    for (const Enclosure& pair : *pairs) {
      if (!small[pair.outer]) continue;
      Index& outer = with[pair.inner];
      if (outer == kNone || outer == pair.inner ||
          parts_[pair.outer].size() > parts_[outer].size()) {
        outer = pair.outer;
      }
    }
    return with;
  }

  // By how many parts each is enclosed.
  std::vector<Index> depths() const {
    std::vector<Index> depth(parts_.size(), 0);
    const auto pairs = enclosures([](const Part&) { return true; });
    if (pairs) {
      for (const Enclosure& pair : *pairs) ++depth[pair.inner];
    } else {
      for (Index p = 0; p < parts_.size(); ++p) depth[p] = parts_[p].measure.volume < 0 ? 1 : 0;
    }
    return depth;
  }

  const Mesh& mesh_;
  Polygons faces_;
  std::vector<Index> part_of_;  // per face
  std::vector<Part> parts_;
};

// Faces for which `keeps` holds, and the vertices they use.
template <typename Keeps>
Mesh filtered(const Mesh& mesh, const Keeps& keeps) {
  Mesh out;
  std::vector<Index> number(mesh.positions.size(), kNone);
  const auto renumbered = [&](Index v) {
    if (number[v] == kNone) {
      number[v] = static_cast<Index>(out.positions.size());
      out.positions.push_back(mesh.positions[v]);
    }
    return number[v];
  };
  std::size_t corner = 0;  // of the faces before
  const auto add = [&](auto face, Index of, auto& to) {
    const std::size_t first = corner;
    corner += face.size();
    if (!keeps(of)) return;
    for (Index& v : face) v = renumbered(v);
    to.push_back(face);
    out.source_faces.push_back(mesh.source_faces[of]);
    if (!mesh.source_operands.empty()) out.source_operands.push_back(mesh.source_operands[of]);
    if (mesh.corner_normals.empty()) return;
    for (std::size_t i = first; i < corner; ++i) {
      out.corner_normals.push_back(mesh.corner_normals[i]);
    }
  };
  const auto triangles = static_cast<Index>(mesh.triangles.size());
  for (Index i = 0; i < triangles; ++i) add(mesh.triangles[i], i, out.triangles);
  for (Index i = 0; i < mesh.quads.size(); ++i) add(mesh.quads[i], triangles + i, out.quads);
  return out;
}

void keep_only(const Parting& parting, Mesh& mesh) {
  if (parting.keeps_all()) return;
  mesh = filtered(mesh, [&](Index face) { return parting.keeps(face); });
}

}  // namespace

KeptParts keep_parts(const ExtractOptions& options, double tolerance, Mesh& mesh) {
  KeptParts kept;
  const bool closed_holes = std::find(mesh.source_faces.begin(), mesh.source_faces.end(), kNone) !=
                            mesh.source_faces.end();
  const bool some_small = options.drop_parts > 0 || options.drop_cavities > 0;
  if (options.parts == Parts::kAll && !some_small && !closed_holes) return kept;
  Parting parting(mesh);
  parting.drop_crumbs(tolerance, kept);
  parting.choose(options.parts, kept);
  if (some_small) parting.drop_small(options, kept);
  kept.invented_area = parting.invented_area();
  keep_only(parting, mesh);
  return kept;
}

void drop_invented_parts(double most, Mesh& mesh) {
  Parting parting(mesh);
  parting.drop_invented(most);
  keep_only(parting, mesh);
}

}  // namespace kdm
