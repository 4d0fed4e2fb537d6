// SPDX-License-Identifier: MIT
// Test shapes: triangle meshes that are closed and oriented outwards unless a name says otherwise.
// Tests, benchmark and fuzzers all take their scenes from here. Everything is deterministic: no
// libm call beyond sqrt, so the same bytes come out on every platform.
#pragma once

#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "kdmanifold/mesh.h"

namespace kdm::shapes {

// --- Tools ------------------------------------------------------------------------------------

Mesh merged(const std::vector<Mesh>& parts);  ///< one after the other, nothing welded
Mesh translated(Mesh mesh, const Vec3& by);
Mesh scaled(Mesh mesh, const Vec3& by);  ///< negative factors flip the faces as well
Mesh rotated(Mesh mesh, const Vec3& axis, double angle);  ///< about the origin, radians
Mesh turned(const Mesh& mesh);                            ///< so that no face is axis-parallel
Mesh inverted(Mesh mesh);                                 ///< inside out
Mesh subdivided(Mesh mesh);                               ///< each triangle in four, in its plane
Mesh jittered(Mesh mesh, double amplitude, std::uint32_t seed);  ///< each vertex moved at random
Mesh snapped(Mesh mesh, double step);           ///< coordinates rounded to multiples of step
Mesh soup(const Mesh& mesh);                    ///< three vertices of its own per triangle
Mesh open(Mesh mesh, Index missing_faces = 1);  ///< the last faces left out

/// Returns the volume: the sum of the signed tetrahedra that triangles form with the origin.
double signed_volume(const Mesh& mesh);

/// sin and cos by a fixed polynomial, so that shapes do not depend on the platform's libm.
double sine(double angle);
double cosine(double angle);

// --- Convex and simple ------------------------------------------------------------------------

Mesh box(const Vec3& min, const Vec3& max);  ///< 8 vertices, 12 triangles
Mesh cube();                                 ///< the unit cube from the origin
Mesh tetrahedron();
Mesh tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);  ///< turned outwards
Mesh icosphere(int subdivisions, double radius = 1);
Mesh uv_sphere(int segments, int rings, double radius = 1);
Mesh cylinder(double radius, double height, int segments);

/// Turns a closed polygon in the half plane (radius, z) about the z axis. Points with radius 0
/// become single vertices. Oriented outwards whatever the polygon's direction.
Mesh revolved(const std::vector<std::pair<double, double>>& profile, int segments);

// --- Handles ----------------------------------------------------------------------------------

Mesh torus(double major = 1, double minor = 0.3, int major_segments = 48, int minor_segments = 24);
Mesh torus_chain(int links);            ///< linked rings, disjoint: `links` parts of genus 1
Mesh plate_with_holes(int nx, int ny);  ///< one part of genus nx * ny
Mesh voxels(int nx, int ny, int nz, const std::function<bool(int, int, int)>& filled);
Mesh stairs(int steps);  ///< all edges axis-parallel, many coplanar faces

// --- Thin, nested, overlapping ----------------------------------------------------------------

Mesh nested_spheres();                          ///< the inner one inverted: a hollow ball
Mesh nested_shells();                           ///< both outwards: the union is the outer ball
Mesh thin_walled_box(double wall = 1.0 / 500);  ///< closed cavity inside
Mesh glass(double wall = 1.0 / 200);            ///< a drinking glass: thin wall, genus 0
Mesh overlapping_cubes();                       ///< two unit cubes, one octant in common
Mesh face_to_face_cubes();                      ///< two unit cubes that share the plane x = 1
Mesh doubled_cube();                            ///< every face twice, on the same vertices
Mesh cube_with_flaps();                         ///< pairs of opposite faces without volume between
Mesh cubes_at_vertex();                         ///< two cubes that share one vertex number
Mesh cubes_at_edge();                           ///< two cubes that share one edge: four faces on it
Mesh swiss_cheese(int cavities, std::uint32_t seed = 1);  ///< a cube with disjoint round cavities

// --- Scenes -----------------------------------------------------------------------------------

/// Houses with window frames and doors, lamps, fences: many thin closed parts, some touching,
/// some overlapping; about as many triangles as asked for.
Mesh street(Index triangles = 88000);

// --- The list ---------------------------------------------------------------------------------

/// A shape with what is known about the solid it stands for (positive winding rule).
struct NamedShape {
  std::string name;
  Mesh mesh;
  std::optional<double> volume;  ///< of the solid; what lies in several parts counts once
  std::optional<Index>
      components;            ///< parts of the solid's boundary surface, once it is fine enough
  std::optional<int> euler;  ///< Euler characteristic of the solid's boundary surface
  bool embedded = true;      ///< the mesh is the boundary: nothing overlaps or touches
};

/// Tells GoogleTest how to name a shape in messages.
inline void PrintTo(const NamedShape& shape, std::ostream* stream) { *stream << shape.name; }

/// Returns every shape above at a size that a test can afford: under about 6,000 triangles.
std::vector<NamedShape> all_shapes();

}  // namespace kdm::shapes
