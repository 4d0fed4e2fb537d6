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

/// The operands of a Boolean operation, with the meshes that they refer to.
struct Solids {
  std::vector<Mesh> meshes;
  std::vector<Operand> operands;
};

/// Takes over 16 numbers, column by column.
inline Transform to_transform(const val& from) {
  Eigen::Matrix4d matrix;
  copy_in(from, 16, matrix.data());
  return matrix.topRows<3>();
}

/// Takes over an array of meshes that may have a `transform` of 16 numbers, column by column, and
/// the word of an inside rule.
inline Solids to_solids(val operands) {
  const std::size_t count = length(operands);
  Solids solids;
  solids.meshes.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const val operand = operands[i];
    solids.meshes[i] = to_mesh(operand);
    Operand& given = solids.operands.emplace_back(solids.meshes[i]);
    const val transform = operand["transform"];
    if (present(transform)) given.transform = to_transform(transform);
    const val inside = operand["inside"];
    if (present(inside)) given.inside = to_choice<InsideRule>(inside, "inside");
  }
  return solids;
}

/// `expression` is in postfix order: numbers of operands, and below zero operations (-1 union, -2
/// intersection, -3 difference, -4 symmetric difference, -5 complement). The wrapper has checked
/// it.
inline val build_boolean_grid(val operands, val expression, val options, val progress) {
  return guard([&] {
    const Solids solids = to_solids(operands);
    return val(build_csg_grid(solids.operands, to_expression(expression),
                              to_options<BuildOptions>(options), to_progress(progress)));
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

/// `expression` is as in `build_boolean_grid`, over the first grid and the second.
inline val merge_grids(const Grid& first, const Grid& second, val expression, val progress) {
  return guard([&] {
    return val(kdm::merge_grids(first, second, to_expression(expression), to_progress(progress)));
  });
}

inline val from_levels(const std::vector<ReducedLevel>& levels) {
  val to = val::array();
  for (const ReducedLevel& level : levels) {
    val made = from_mesh(level, "Float32Array");
    made.set("error", from_report(level.error));
    to.call<void>("push", made);
  }
  return to;
}

inline val from_extracted(const ExtractedMesh& mesh) {
  val to = from_mesh(mesh, "Float32Array");
  val report = from_report(mesh.report);
  report.set("warnings", from_warnings(mesh.warnings));
  to.set("report", report);
  return to;
}

/// Makes what `extract` gives, with `levels` and `reduce` (null: it was not).
inline val from_reduced(const MadeMesh& made) {
  val to = from_extracted(made);
  to.set("levels", from_levels(made.levels));
  to.set("simplify", made.simplified ? from_report(*made.simplified) : val::null());
  to.set("reduce", made.reduced ? from_report(*made.reduced) : val::null());
  return to;
}

/// The same with the grid's `stats`.
inline val from_made(const MadeMesh& made) {
  val to = from_reduced(made);
  to.set("stats", from_report(made.stats));
  return to;
}

/// The same with the `grid`.
inline val from_manifold(MadeManifold made) {
  val to = from_made(made);
  to.set("grid", val(std::move(made.grid)));
  return to;
}

/// Reads the options of a kind of reduction, with the groups that their tables do not have.
template <typename Options>
Options to_reduction(const val& from) {
  Options options = to_options<Options>(from);
  read_option(from, "keep_groups", options.keep_groups);
  return options;
}

inline MakeOptions to_make_options(val options) {
  return {to_options<BuildOptions>(options), to_options<ExtractOptions>(options),
          to_reduction<ReductionOptions>(options)};
}

inline val make_manifold(val mesh, val options, val begin) {
  return guard([&] {
    return from_manifold(
        make_manifold_in_steps(to_mesh(mesh), to_make_options(options), to_steps(begin)));
  });
}

inline val make_solids(val operands, val expression, val options, val begin) {
  return guard([&] {
    const Solids solids = to_solids(operands);
    return from_manifold(make_solids_in_steps(to_expression(expression), solids.operands,
                                              to_make_options(options), to_steps(begin)));
  });
}

/// A scene with the meshes that it refers to.
struct SceneOfMeshes {
  std::vector<Mesh> meshes;
  BooleanScene scene;
};

inline val make_scene(val operands, val expression, val options) {
  return guard([&] {
    Solids solids = to_solids(operands);
    BooleanScene scene(to_expression(expression), solids.operands, to_make_options(options));
    return val(SceneOfMeshes{std::move(solids.meshes), std::move(scene)});
  });
}

inline val place_in_scene(SceneOfMeshes& scene, Index operand, val transform) {
  return guard([&] {
    scene.scene.place(
        operand, present(transform) ? to_transform(transform) : Transform(Transform::Identity()));
    return val::undefined();
  });
}

inline val make_of_scene(SceneOfMeshes& scene, val begin) {
  return guard([&] { return from_manifold(scene.scene.make_in_steps(to_steps(begin))); });
}

inline val make_from_grid(Grid& grid, val options, val begin) {
  return guard([&] {
    return from_made(kdm::make_from_grid(grid, to_options<ExtractOptions>(options),
                                         to_reduction<ReductionOptions>(options), to_steps(begin)));
  });
}

inline val extract_reduced(const Grid& grid, val options, val reduce, val begin) {
  return guard([&] {
    return from_reduced(kdm::extract_reduced(grid, to_options<ExtractOptions>(options),
                                             to_reduction<ReduceOptions>(reduce), to_steps(begin)));
  });
}

inline val simplify(Grid& grid, val options, val progress) {
  return guard([&] {
    return from_report(
        kdm::simplify(grid, to_options<SimplifyOptions>(options), to_progress(progress)));
  });
}

inline val simplify_mesh(val mesh, val options, val begin) {
  return guard([&] {
    const SimplifiedMesh few =
        kdm::simplify_mesh(to_mesh(mesh), to_reduction<ReduceOptions>(options), to_steps(begin));
    val to = val::object();
    to.set("mesh", from_mesh(few.mesh, "Float32Array"));
    to.set("levels", from_levels(few.levels));
    val report = from_report(few.report);
    report.set("rebuilt", few.rebuilt);
    report.set("warnings", from_warnings(few.warnings));
    to.set("report", report);
    return to;
  });
}

inline val extract(const Grid& grid, val options, val progress) {
  return guard([&] {
    const ExtractedMesh mesh =
        kdm::extract(grid, to_options<ExtractOptions>(options), to_progress(progress));
    return from_extracted(mesh);
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

inline val grid_operands(const Grid& grid) {
  val to = val::array();
  for (const InputReport& operand : grid.operands()) to.call<void>("push", from_report(operand));
  return to;
}

inline val find_self_intersections(val mesh) {
  return guard([&] { return from_report(kdm::find_self_intersections(to_mesh(mesh))); });
}

inline val describe(val mesh) {
  return guard([&] { return from_report(kdm::describe(to_mesh(mesh))); });
}

}  // namespace kdm::wasm
