// SPDX-License-Identifier: MIT
// What the main module exports, and nothing else: all that making a manifold takes. With threads
// there is one function more.
#include <emscripten/bind.h>

#include "instance.h"
#include "module.h"

EMSCRIPTEN_BINDINGS(kdmanifold) {
  using namespace emscripten;
  class_<kdm::Grid>("Grid")
      .function("extract", &kdm::wasm::extract)
      .function("extractReduced", &kdm::wasm::extract_reduced)
      .function("make", &kdm::wasm::make_from_grid)
      .function("simplify", &kdm::wasm::simplify)
      .function("compare", &kdm::wasm::compare)
      .function("merge", &kdm::wasm::merge_grids)
      .function("save", &kdm::wasm::save_grid)
      .function("stats", &kdm::wasm::grid_stats)
      .function("input", &kdm::wasm::grid_input)
      .function("operands", &kdm::wasm::grid_operands);
  class_<kdm::wasm::SceneOfMeshes>("BooleanScene")
      .function("place", &kdm::wasm::place_in_scene)
      .function("make", &kdm::wasm::make_of_scene);
  function("buildGrid", &kdm::wasm::build_grid);
  function("buildBooleanGrid", &kdm::wasm::build_boolean_grid);
  function("loadGrid", &kdm::wasm::load_grid);
  function("makeManifold", &kdm::wasm::make_manifold);
  function("makeSolids", &kdm::wasm::make_solids);
  function("makeScene", &kdm::wasm::make_scene);
  function("simplifyMesh", &kdm::wasm::simplify_mesh);
  function("thicken", &kdm::wasm::thicken);
  function("describe", &kdm::wasm::describe);
  function("findSelfIntersections", &kdm::wasm::find_self_intersections);
  function("memory", &kdm::wasm::memory);
  function("version", &kdm::wasm::version);
#ifdef __EMSCRIPTEN_PTHREADS__
  function("setThreadCount", &kdm::set_thread_count);
#endif
}
