// SPDX-License-Identifier: MIT
#include "targets.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include "grid/grid_data.h"
#include "grid/saved/grid_format.h"
#include "grid/validate.h"
#include "io/bytes.h"
#include "kdmanifold/kdmanifold.h"
#include "support/mesh_check.h"
#include "support/random_meshes.h"

namespace kdm::fuzz {
namespace {

// Not assert(): release builds must stop as well.
void demand(bool condition, const std::string& rule) {
  if (condition) return;
  std::fprintf(stderr, "broken rule: %s\n", rule.c_str());
  std::abort();
}

void demand_sound(const Mesh& mesh) {
  demand(mesh.source_faces.size() == mesh.triangles.size() + mesh.quads.size(),
         "a source face for each face");
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t) demand(v < mesh.positions.size(), "corners name vertices");
  }
}

void demand_manifold(const Mesh& out, bool sheet) {
  if (out.triangles.empty() && out.quads.empty()) return;
  const check::MeshCheck result = check::check_mesh(out);
  demand(sheet ? result.manifold : result.two_manifold,
         "the surface is 2-manifold, but: " + result.faults());
  demand(std::isfinite(result.volume), "the volume is finite");
}

// Nothing may be left; that is an error.
ExtractedMesh extract_if_any(const Grid& grid, const ExtractOptions& options) {
  try {
    return extract(grid, options);
  } catch (const Error& error) {
    demand(error.code() == ErrorCode::kEmptyResult ||
               (error.code() == ErrorCode::kNotClosed && !grid.input().closed),
           error.what());
    return {};
  }
}

// Leaves out some faces and turns over others, another choice for each pattern.
Mesh torn(Mesh mesh, unsigned pattern) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const unsigned choice = ((pattern >> (i % 7)) ^ static_cast<unsigned>(i / 7)) & 7u;
    Triangle t = mesh.triangles[i];
    if (choice == 1) std::swap(t[0], t[1]);
    if (choice < 6) triangles.push_back(t);
  }
  mesh.triangles = triangles;
  return mesh;
}

}  // namespace

void parse_bytes(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return;
  const auto format = static_cast<MeshFormat>(bytes[0] % 4);
  Mesh mesh;
  std::vector<Warning> warnings;
  try {
    const std::string_view file(reinterpret_cast<const char*>(bytes + 1), size - 1);
    mesh = parse_mesh(file, format, "input", &warnings);
  } catch (const Error& error) {
    demand(error.code() == ErrorCode::kParseError,
           std::string("bad files give PARSE_ERROR, not: ") + error.what());
    return;
  }
  demand_sound(mesh);
  for (const Vec3& p : mesh.positions) demand(p.allFinite(), "coordinates are finite");
  for (const auto& [code, message] : warnings) {
    demand(!code.empty() && !message.empty() && message.find('\n') == std::string::npos,
           "a warning is a line");
  }
  for (int other = 0; other < 4; ++other) {
    const auto target = static_cast<MeshFormat>(other);
    try {
      const std::string written = format_mesh(mesh, target);
      const Mesh again = parse_mesh(written, target);
      demand_sound(again);
      demand(again.triangles.size() == mesh.triangles.size(), "as many faces read as written");
    } catch (const Error& error) {
      // Coordinates beyond 32-bit floats cannot be written in every format; nothing else may fail.
      bool large = false;
      for (const Vec3& p : mesh.positions) {
        large = large || !(p.cwiseAbs().maxCoeff() < 3e38);
      }
      demand(large, std::string("what was read can be written and read again: ") + error.what());
    }
  }
}

void build_from_bytes(const std::uint8_t* bytes, std::size_t size) {
  constexpr std::size_t kMaxSize = 4 + 12 * 64;
  if (size < 4 || size > kMaxSize) return;
  BuildOptions options;
  options.strategy = static_cast<SplitStrategy>(bytes[0] % 5);
  options.inside = static_cast<InsideRule>(bytes[0] / 5 % 5);
  options.pairing = static_cast<Pairing>(bytes[0] / 25 % 4);
  options.depth = 1 + bytes[1] % (options.strategy == SplitStrategy::kMedian ? 60 : 12);
  // Options without effect beside others are refused.
  const bool counts =
      options.strategy == SplitStrategy::kMedian || options.strategy == SplitStrategy::kUniform;
  if (!counts) options.relative_tolerance = bytes[3] / 1024.0;
  if (options.inside == InsideRule::kSheet && options.pairing >= Pairing::kInside) {
    options.pairing = Pairing::kHermite;
  }
  const ExtractOptions extraction{.quads = (bytes[2] & 1) != 0,
                                  .split_error = bytes[2] / 2 / 1024.0};
  const bool sheet = options.inside == InsideRule::kSheet;
  Mesh input = shapes::mesh_from_bytes(bytes + 4, size - 4);
  const bool open = sheet || options.inside == InsideRule::kRepair;
  if (open) input = torn(std::move(input), bytes[3]);
  const MeshDefects defects = analyze(input, {.self_intersections = true});
  demand(open || defects.balanced || defects.parts.empty(), "tetrahedra are closed");
  demand(!defects.balanced || defects.boundary_loops.empty(), "closed meshes have no boundary");
  Grid grid;
  try {
    grid = build_grid(input, options);
  } catch (const Error& error) {
    // Tetrahedra may cancel or shrink to nothing; open they never are.
    const bool nothing = open ? input.triangles.empty() : check::check_mesh(input).volume == 0;
    const bool repair = options.inside == InsideRule::kRepair;
    const bool told =
        error.code() == ErrorCode::kInvalidMesh || error.code() == ErrorCode::kNotClosed;
    demand(told && (nothing || repair), error.what());
    return;
  }
  validate(grid.data());
  const ExtractedMesh out = extract_if_any(grid, extraction);
  demand_manifold(out, sheet);
  demand(save_grid(load_grid(save_grid(grid))) == save_grid(grid), "grids come back");
  const ExtractedMesh again = extract_if_any(build_grid(input, options), extraction);
  demand(again.positions == out.positions && again.triangles == out.triangles &&
             again.quads == out.quads,
         "the same comes out twice");
}

void load_bytes(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view payload(reinterpret_cast<const char*>(bytes), size);
  std::string header(grid_format::kMagic);
  append_u32(header, grid_format::kVersion);
  append_u64(header, payload.size());
  append_u64(header, grid_format::checksum(payload));
  std::vector<std::uint8_t> file(header.begin(), header.end());
  file.insert(file.end(), payload.begin(), payload.end());
  Grid grid;
  try {
    grid = load_grid(file);
  } catch (const Error& error) {
    demand(error.code() == ErrorCode::kParseError,
           std::string("bad grids give PARSE_ERROR, not: ") + error.what());
    return;
  }
  validate(grid.data());
  const std::vector<std::uint8_t> saved = save_grid(grid);
  demand(save_grid(load_grid(saved)) == saved, "what was loaded can be saved and loaded again");
  demand_manifold(extract_if_any(grid, {.normals = true}), grid.data().sheet);
}

}  // namespace kdm::fuzz
