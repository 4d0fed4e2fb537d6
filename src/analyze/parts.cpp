// SPDX-License-Identifier: MIT
// Finds the genus of each part by Euler's formula, its size by sums over triangles, and whether it
// is a cavity or inside out from the parts that it lies in.
#include "analyze/parts.h"

#include <cmath>

#include "mesh/boxes.h"
#include "mesh/measure.h"
#include "mesh/nesting.h"
#include "mesh/scale.h"

namespace kdm {
namespace {

// A part whose volume is at most this share of the sum of its terms' absolute values encloses
// nothing, but for rounding errors: it consists of faces back to back.
constexpr double kMostRoundingVolume = 1e-10;

// Returns the number of handles. If each boundary loop is closed by a disk, Euler's formula says
// fans
// - edges + faces + loops = 2 - 2 genus.
Index genus_of(const PartTopology& part, Index loops) {
  if (!part.manifold || !part.agreeing) return kNone;
  return (2 + part.edges - part.fans - part.faces - loops) / 2;
}

void measure_parts(const Polygons& faces, const ScaledPositions& scaled,
                   std::span<const Index> part_of, std::vector<Shell>& shells,
                   std::vector<Measure>& measures) {
  for (Index face = 0; face < faces.size(); ++face) {
    if (part_of[face] == kNone) continue;
    for (Index k = 0; k < faces.corners(face); ++k) {
      grow(shells[part_of[face]].bounds, scaled.positions[faces[face][k]]);
    }
  }
  for (Index part = 0; part < shells.size(); ++part) {
    measures[part].centre = centre_of(shells[part].bounds);
  }
  faces.for_each_triangle([&](Index face, const Triangle& t) {
    if (part_of[face] == kNone) return;
    measures[part_of[face]].add(scaled.positions[t[0]], scaled.positions[t[1]],
                                scaled.positions[t[2]]);
  });
}

// Returns 1 if the part is turned outwards, -1 if inwards, 0 if it is open or without volume.
int turn_of(const PartTopology& part, const Measure& measure) {
  if (!part.balanced || std::abs(measure.volume) <= kMostRoundingVolume * measure.absolute_volume) {
    return 0;
  }
  return measure.volume > 0 ? 1 : -1;
}

}  // namespace

PartsReport describe_parts(const Mesh& mesh, const MeshFaults& faults,
                           std::span<const BoundaryLoop> loops) {
  const Polygons faces(mesh);
  const ScaledPositions scaled = scale_to_one(mesh.positions);
  std::vector<Shell> shells(faults.parts.size());
  std::vector<Measure> measures(faults.parts.size());
  measure_parts(faces, scaled, faults.part_of, shells, measures);

  std::vector<MeshPart> parts(faults.parts.size());
  for (const BoundaryLoop& loop : loops) ++parts[faults.part_of[loop.face]].boundary_loops;
  std::vector<int> turns(parts.size());
  for (Index i = 0; i < parts.size(); ++i) {
    const PartTopology& topology = faults.parts[i];
    MeshPart& part = parts[i];
    part.first_face = topology.first_face;
    part.faces = topology.faces;
    part.closed = shells[i].closed = topology.balanced;
    part.genus = genus_of(topology, part.boundary_loops);
    part.area = std::ldexp(measures[i].area, 2 * scaled.exponent);
    if (part.closed) part.volume = std::ldexp(measures[i].volume, 3 * scaled.exponent);
    turns[i] = turn_of(topology, measures[i]);
  }

  const std::optional<std::vector<Enclosure>> enclosures =
      find_enclosures(faces, scaled.positions, faults.part_of, shells);
  if (!enclosures) return {std::move(parts), false};
  std::vector<int> winding(parts.size(), 0);  // at the part, by the parts that hold it
  for (const Enclosure& pair : *enclosures) {
    winding[pair.inner] += turns[pair.outer];
    Index& smallest = parts[pair.inner].inside;
    if (smallest == kNone ||
        std::abs(measures[pair.outer].volume) < std::abs(measures[smallest].volume)) {
      smallest = pair.outer;
    }
  }
  for (Index i = 0; i < parts.size(); ++i) {
    parts[i].cavity = turns[i] < 0 && winding[i] > 0;
    parts[i].inside_out = turns[i] != 0 && (winding[i] < 0 || (turns[i] < 0 && winding[i] == 0));
  }
  return {std::move(parts), true};
}

}  // namespace kdm
