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

struct Command {
  std::string path;
  std::string reference;
  double sharp_degrees = 0;
  kdm::Index samples = 50000;
  bool no_check = false;
  bool weld = false;
};

json measure(const Command& command) {
  kdm::Mesh mesh = kdm::read_mesh(command.path);
  if (command.weld) mesh = kdm::check::welded_in_single(mesh);
  json report = {{"vertices", mesh.positions.size()}, {"triangles", mesh.triangles.size()}};
  if (!command.no_check) {
    const kdm::check::MeshCheck check = kdm::check::check_mesh(mesh);
    report.update({{"closed", check.closed},
                   {"oriented", check.oriented},
                   {"twoManifold", check.two_manifold},
                   {"faults", check.faults()},
                   {"components", check.components},
                   {"eulerCharacteristic", check.euler_characteristic},
                   {"volume", check.volume}});
  }
  if (!command.reference.empty()) {
    const kdm::Mesh reference = kdm::read_mesh(command.reference);
    const double unit = kdm::bench::diagonal(reference);
    report["toReference"] =
        to_json(kdm::bench::one_sided_distance(mesh, reference, command.samples), unit);
    report["fromReference"] =
        to_json(kdm::bench::one_sided_distance(reference, mesh, command.samples), unit);
    report["falseCreases"] = kdm::bench::count_false_creases(reference, mesh);
    if (command.sharp_degrees > 0) {
      report["sharpEdges"] = to_json(
          kdm::bench::sharp_edge_distance(reference, mesh, command.sharp_degrees, command.samples),
          unit);
    }
  }
  return report;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Judges a mesh; distances are fractions of the reference's bounding-box diagonal.");
  Command command;
  app.add_option("mesh", command.path, "the mesh file")->required();
  app.add_option("--reference", command.reference, "measure distances to this mesh, both ways");
  app.add_option("--sharp-edges", command.sharp_degrees,
                 "also say how far the reference's edges sharper than so many degrees are");
  app.add_option("--samples", command.samples, "points on each surface")->capture_default_str();
  app.add_flag("--weld", command.weld, "join vertices of equal position first");
  app.add_flag("--no-check", command.no_check, "distances only, which is faster");
  CLI11_PARSE(app, argc, argv);
  try {
    std::puts(measure(command).dump().c_str());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "measure: %s\n", error.what());
    return 2;
  }
}
