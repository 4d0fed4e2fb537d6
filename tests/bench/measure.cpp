// SPDX-License-Identifier: MIT
// Says what a mesh file is and how far it is from another, as one JSON object: the judge for
// benchmark tables, the same for this library's results and its peers'.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "distance.h"
#include "edges.h"
#include "kdmanifold/mesh_io.h"
#include "support/mesh_check.h"

namespace {

using nlohmann::json;

json to_json(const kdm::bench::Distance& distance, double unit) {
  return {
      {"max", distance.max / unit}, {"mean", distance.mean / unit}, {"rms", distance.rms / unit}};
}

json to_json(const kdm::bench::EdgeDistance& edges, double unit) {
  return {{"referenceLength", edges.reference_length / unit},
          {"length", edges.length / unit},
          {"toSurface", to_json(edges.to_surface, unit)},
          {"toEdges", to_json(edges.to_edges, unit)}};
}

json measure(const std::string& path, const std::string& reference_path, kdm::Index samples,
             double sharp_degrees) {
  const kdm::Mesh mesh = kdm::read_mesh(path);
  const kdm::check::MeshCheck check = kdm::check::check_mesh(mesh);
  json report = {{"vertices", mesh.positions.size()},
                 {"triangles", mesh.triangles.size()},
                 {"closed", check.closed},
                 {"oriented", check.oriented},
                 {"twoManifold", check.two_manifold},
                 {"faults", check.faults()},
                 {"components", check.components},
                 {"eulerCharacteristic", check.euler_characteristic},
                 {"volume", check.volume}};
  if (!reference_path.empty()) {
    const kdm::Mesh reference = kdm::read_mesh(reference_path);
    const double unit = kdm::bench::diagonal(reference);
    report["toReference"] = to_json(kdm::bench::one_sided_distance(mesh, reference, samples), unit);
    report["fromReference"] =
        to_json(kdm::bench::one_sided_distance(reference, mesh, samples), unit);
    if (sharp_degrees > 0) {
      report["sharpEdges"] =
          to_json(kdm::bench::sharp_edge_distance(reference, mesh, sharp_degrees, samples), unit);
    }
  }
  return report;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Judges a mesh; distances are fractions of the reference's bounding-box diagonal.");
  std::string path;
  std::string reference;
  kdm::Index samples = 50000;
  app.add_option("mesh", path, "the mesh file")->required();
  app.add_option("--reference", reference, "measure distances to this mesh, both ways");
  double sharp_degrees = 0;
  app.add_option("--sharp-edges", sharp_degrees,
                 "also say how far the reference's edges sharper than so many degrees are");
  app.add_option("--samples", samples, "points on each surface")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    std::puts(measure(path, reference, samples, sharp_degrees).dump().c_str());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "measure: %s\n", error.what());
    return 2;
  }
}
