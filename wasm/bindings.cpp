// SPDX-License-Identifier: MIT
// What the module exports, and nothing else.
#include <emscripten/bind.h>

#include "module.h"

EMSCRIPTEN_BINDINGS(kdmanifold) {
  using namespace emscripten;
  class_<kdm::Grid>("Grid")
      .function("extract", &kdm::wasm::extract)
      .function("save", &kdm::wasm::save_grid)
      .function("stats", &kdm::wasm::grid_stats)
      .function("input", &kdm::wasm::grid_input);
  function("buildGrid", &kdm::wasm::build_grid);
  function("loadGrid", &kdm::wasm::load_grid);
  function("parseMesh", &kdm::wasm::parse_mesh);
  function("formatMesh", &kdm::wasm::format_mesh);
  function("analyze", &kdm::wasm::analyze);
  function("thicken", &kdm::wasm::thicken);
  function("describe", &kdm::wasm::describe);
  function("findSelfIntersections", &kdm::wasm::find_self_intersections);
  function("memory", &kdm::wasm::memory);
  function("version", &kdm::wasm::version);
}
