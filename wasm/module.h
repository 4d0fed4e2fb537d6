// SPDX-License-Identifier: MIT
// The functions of the main module: each takes its arguments over from JavaScript, calls the
// library and returns what `guard` makes of the result.
#pragma once

#include "fields.h"
#include "kdmanifold/kdmanifold.h"
#include "marshal.h"

namespace kdm::wasm {

inline val build_grid(val mesh, val options, val progress) {
  return guard([&] {
    return val(
        kdm::build_grid(to_mesh(mesh), to_options<BuildOptions>(options), to_progress(progress)));
  });
}

inline val load_grid(val bytes, std::string name) {
  return guard([&] {
    const std::string copy = to_bytes(bytes);
    return val(
        kdm::load_grid({reinterpret_cast<const std::uint8_t*>(copy.data()), copy.size()}, name));
  });
}

inline val save_grid(const Grid& grid) {
  return guard([&] {
    const std::vector<std::uint8_t> bytes = kdm::save_grid(grid);
    return copy_out("Uint8Array", bytes.size(), bytes.data());
  });
}

inline val extract(const Grid& grid, val options, val progress) {
  return guard([&] {
    const ExtractedMesh mesh =
        kdm::extract(grid, to_options<ExtractOptions>(options), to_progress(progress));
    val to = from_mesh(mesh, "Float32Array");
    val report = from_report(mesh.report);
    report.set("warnings", from_warnings(mesh.warnings));
    to.set("report", report);
    return to;
  });
}

inline val compare(const Grid& grid, val input, val result, bool error) {
  return guard([&] {
    const Account account = kdm::compare(to_mesh(input), grid, to_mesh(result), {.error = error});
    val to = val::object();
    to.set("lost", from_report(account.lost));
    to.set("error", account.error ? from_report(*account.error) : val::null());
    to.set("warnings", from_warnings(account.warnings));
    return to;
  });
}

inline val thicken(val mesh, double thickness) {
  return guard([&] { return from_mesh(kdm::thicken(to_mesh(mesh), thickness), "Float64Array"); });
}

inline val grid_stats(const Grid& grid) { return from_report(grid.stats()); }

inline val grid_input(const Grid& grid) { return from_report(grid.input()); }

inline val find_self_intersections(val mesh) {
  return guard([&] { return from_report(kdm::find_self_intersections(to_mesh(mesh))); });
}

inline val describe(val mesh) {
  return guard([&] { return from_report(kdm::describe(to_mesh(mesh))); });
}

}  // namespace kdm::wasm
