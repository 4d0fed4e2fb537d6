// SPDX-License-Identifier: MIT
#include "kdmanifold/thicken.h"

#include <cmath>
#include <new>
#include <utility>

#include "kdmanifold/error.h"
#include "mesh/check_indices.h"
#include "mesh/check_positions.h"
#include "mesh/marks.h"
#include "mesh/polygons.h"
#include "mesh/scale.h"
#include "mesh/topology.h"
#include "prepare/edit_faces.h"
#include "prepare/neighbours.h"
#include "prepare/non_manifold_edges.h"
#include "prepare/pieces_of_surface.h"
#include "prepare/shell.h"
#include "prepare/thicken_faces.h"
#include "prepare/weld.h"
#include "text/compose.h"

namespace kdm {
namespace {

struct Faces {
  std::vector<Triangle> triangles;
  std::vector<Index> source;  // per triangle: the input's number of its face
};

// Cuts quads in two, and leaves out triangles with a repeated point.
Faces welded_faces(const Mesh& mesh, const Weld& weld) {
  Faces faces;
  Polygons(mesh).for_each_triangle([&](Index face, const Triangle& c) {
    const Triangle t = {weld.point_of[c[0]], weld.point_of[c[1]], weld.point_of[c[2]]};
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;
    faces.triangles.push_back(t);
    faces.source.push_back(mesh.source_faces.empty() ? face : mesh.source_faces[face]);
  });
  return faces;
}

// Leaves out copies, and turns neighbours to agree.
Faces oriented_faces(const Faces& all, const std::vector<Vec3>& points) {
  const NeighbourDirections directions = orient_neighbours(
      all.triangles, points, build_topology(all.triangles, static_cast<Index>(points.size())));
  Faces faces;
  for (std::size_t t = 0; t < all.triangles.size(); ++t) {
    if (directions.copy_of[t] != kNone) continue;
    const Triangle& c = all.triangles[t];
    faces.triangles.push_back(directions.must_turn.test(t) ? Triangle{c[0], c[2], c[1]} : c);
    faces.source.push_back(all.source[t]);
  }
  return faces;
}

}  // namespace

Mesh thicken(const Mesh& mesh, double thickness) try {
  if (!(thickness > 0 && std::isfinite(thickness))) {
    throw Error(ErrorCode::kInvalidOption,
                compose("thickness is {}; it must be a finite number above 0", thickness));
  }
  check_positions(mesh);
  check_indices(mesh);
  const std::size_t faces = mesh.triangles.size() + mesh.quads.size();
  if (!mesh.source_faces.empty() && mesh.source_faces.size() != faces) {
    throw Error(ErrorCode::kInvalidMesh, compose("source_faces has {} entries for {} faces",
                                                 mesh.source_faces.size(), faces));
  }
  const Weld weld = weld_positions(mesh.positions);
  std::vector<Vec3> points;
  points.reserve(weld.first_of.size());
  for (const Index first : weld.first_of) points.push_back(mesh.positions[first]);
  const Faces all = welded_faces(mesh, weld);
  const auto [places, exponent] = scale_to_one(points, all.triangles);
  const Faces surface = oriented_faces(all, places);
  Topology topology = build_topology(surface.triangles, static_cast<Index>(places.size()));
  pair_straightest(surface.triangles, places, topology);
  const double height = std::ldexp(thickness, -exponent);
  const PiecesOfSurface pieces(surface.triangles, places, std::move(topology.opposite), height);
  if (!pieces.has_area()) {
    throw Error(ErrorCode::kInvalidMesh, "no face of the mesh has an area");
  }
  Marks all_of_it;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) all_of_it.push_back(true);
  Mesh shell = make_shell(pieces, height, surface.source, all_of_it);
  shell.positions = scaled(shell.positions, exponent);
  return shell;
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, "there is not enough memory to thicken the surface");
}

void thicken_faces(InputFaces& faces, const Marks& wanted, double thickness) {
  const auto [places, exponent] = scale_to_one(faces.points, faces.triangles);
  const double height = std::ldexp(thickness, -exponent);
  const PiecesOfSurface pieces(faces.triangles, places, faces.topology.opposite, height);
  const Mesh shell = make_shell(pieces, height, faces.source_faces, wanted);
  drop_faces(faces, wanted);
  const auto first = static_cast<Index>(faces.points.size());
  for (const Vec3& p : scaled(shell.positions, exponent)) faces.points.push_back(p);
  for (const Triangle& t : shell.triangles) {
    faces.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  faces.source_faces.insert(faces.source_faces.end(), shell.source_faces.begin(),
                            shell.source_faces.end());
}

}  // namespace kdm
