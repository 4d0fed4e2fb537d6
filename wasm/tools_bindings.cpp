// SPDX-License-Identifier: MIT
// What the module of tools exports, and nothing else: files, and what is wrong with a mesh.
#include <emscripten/bind.h>

#include "instance.h"
#include "tools.h"

EMSCRIPTEN_BINDINGS(kdmanifold_tools) {
  using namespace emscripten;
  function("parseMesh", &kdm::wasm::parse_mesh);
  function("formatMesh", &kdm::wasm::format_mesh);
  function("analyze", &kdm::wasm::analyze);
  function("memory", &kdm::wasm::memory);
  function("version", &kdm::wasm::version);
}
