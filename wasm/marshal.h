// SPDX-License-Identifier: MIT
// How values cross between JavaScript and C++: typed arrays to vectors and back, exceptions to
// {code, message}. The wrapper in web/src has checked the arguments.
#pragma once

#include <emscripten/val.h>

#include <array>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "kdmanifold/error.h"
#include "kdmanifold/expression.h"
#include "kdmanifold/make_manifold.h"
#include "kdmanifold/mesh.h"
#include "kdmanifold/progress.h"
#include "kdmanifold/warnings.h"

namespace kdm::wasm {

using emscripten::typed_memory_view;
using emscripten::val;

// A mesh's arrays are read and written as runs of plain numbers.
static_assert(sizeof(Vec3) == 3 * sizeof(double));
static_assert(sizeof(std::array<float, 3>) == 3 * sizeof(float));
static_assert(sizeof(Triangle) == 3 * sizeof(Index) && sizeof(Quad) == 4 * sizeof(Index));

/// Copies a typed array of any kind into `to`, which has room for `count` numbers. The view is
/// made after every allocation, so growing memory cannot detach it.
template <typename T>
void copy_in(const val& array, std::size_t count, T* to) {
  if (count > 0) val(typed_memory_view(count, to)).call<void>("set", array);
}

/// Makes a typed array of class `type` with a copy of the numbers; 64-bit positions become 32-bit
/// on the way if the class says so.
template <typename T>
val copy_out(const char* type, std::size_t count, const T* from) {
  return val::global(type).new_(val(typed_memory_view(count, from)));
}

inline std::size_t length(const val& array) { return array["length"].as<std::size_t>(); }

inline bool present(const val& value) { return !value.isUndefined() && !value.isNull(); }

/// Copies a mesh {positions, indices?, quads?, sourceFaces?, cornerNormals?}; without indices every
/// three positions are a triangle.
inline Mesh to_mesh(const val& from) {
  Mesh mesh;
  const val positions = from["positions"];
  const std::size_t numbers = length(positions);
  mesh.positions.resize(numbers / 3);
  copy_in(positions, numbers, reinterpret_cast<double*>(mesh.positions.data()));
  const val indices = from["indices"];
  if (present(indices)) {
    mesh.triangles.resize(length(indices) / 3);
    copy_in(indices, mesh.triangles.size() * 3, reinterpret_cast<Index*>(mesh.triangles.data()));
  } else {
    mesh.triangles.resize(mesh.positions.size() / 3);
    Index* const first = reinterpret_cast<Index*>(mesh.triangles.data());
    std::iota(first, first + mesh.triangles.size() * 3, Index{0});
  }
  const val quads = from["quads"];
  if (present(quads)) {
    mesh.quads.resize(length(quads) / 4);
    copy_in(quads, mesh.quads.size() * 4, reinterpret_cast<Index*>(mesh.quads.data()));
  }
  const val source_faces = from["sourceFaces"];
  if (present(source_faces)) {
    mesh.source_faces.resize(length(source_faces));
    copy_in(source_faces, mesh.source_faces.size(), mesh.source_faces.data());
  }
  const val corner_normals = from["cornerNormals"];
  if (present(corner_normals)) {
    mesh.corner_normals.resize(length(corner_normals) / 3);
    copy_in(corner_normals, mesh.corner_normals.size() * 3,
            reinterpret_cast<float*>(mesh.corner_normals.data()));
  }
  return mesh;
}

/// Makes a mesh object of copies that JavaScript owns; `real` is the class of the positions.
inline val from_mesh(const Mesh& mesh, const char* real) {
  val to = val::object();
  to.set("positions", copy_out(real, mesh.positions.size() * 3,
                               reinterpret_cast<const double*>(mesh.positions.data())));
  to.set("indices", copy_out("Uint32Array", mesh.triangles.size() * 3,
                             reinterpret_cast<const Index*>(mesh.triangles.data())));
  if (!mesh.quads.empty()) {
    to.set("quads", copy_out("Uint32Array", mesh.quads.size() * 4,
                             reinterpret_cast<const Index*>(mesh.quads.data())));
  }
  to.set("sourceFaces",
         copy_out("Uint32Array", mesh.source_faces.size(), mesh.source_faces.data()));
  if (!mesh.source_operands.empty()) {
    to.set("sourceOperands",
           copy_out("Uint32Array", mesh.source_operands.size(), mesh.source_operands.data()));
  }
  if (!mesh.corner_normals.empty()) {
    to.set("cornerNormals", copy_out("Float32Array", mesh.corner_normals.size() * 3,
                                     reinterpret_cast<const float*>(mesh.corner_normals.data())));
  }
  return to;
}

/// Makes an expression of an Int32Array (see build_boolean_grid).
inline Expression to_expression(const val& from) {
  std::vector<std::int32_t> codes(length(from));
  copy_in(from, codes.size(), codes.data());
  std::vector<Expression> stack;
  for (const std::int32_t code : codes) {
    if (code >= 0) {
      stack.emplace_back(static_cast<Index>(code));
      continue;
    }
    const Expression last = std::move(stack.back());
    if (code == -5) {
      stack.back() = complement(last);
      continue;
    }
    stack.pop_back();
    Expression& first = stack.back();
    first = code == -1   ? union_of(first, last)
            : code == -2 ? intersection(first, last)
            : code == -3 ? difference(first, last)
                         : symmetric_difference(first, last);
  }
  return std::move(stack.back());
}

/// Makes a Uint32Array of numbers, or of small arrays of numbers one after the other.
template <typename T>
val from_indices(const std::vector<T>& from) {
  return copy_out("Uint32Array", from.size() * (sizeof(T) / sizeof(Index)),
                  reinterpret_cast<const Index*>(from.data()));
}

inline std::string to_bytes(const val& array) {
  std::string bytes(length(array), '\0');
  copy_in(array, bytes.size(), reinterpret_cast<std::uint8_t*>(bytes.data()));
  return bytes;
}

inline val from_bytes(std::string_view bytes) {
  return copy_out("Uint8Array", bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
}

/// Makes a progress callback of a JavaScript function that must not throw: a JavaScript exception
/// would not unwind C++ frames properly. The wrapper catches what the user's callback throws.
inline Progress to_progress(const val& callback) {
  if (!present(callback)) return {};
  return [callback](double fraction, std::string_view phase) {
    return callback(fraction, std::string(phase)).template as<bool>();
  };
}

/// Makes a function of steps of a JavaScript function that must not throw: it is told which step
/// begins, and returns a callback as `to_progress` takes it.
inline StepProgress to_steps(const val& begin) {
  return [begin](MakeStep step) {
    constexpr std::array kNames = {"build", "simplify", "extract", "reduce"};
    return to_progress(begin(std::string(kNames[static_cast<std::size_t>(step)])));
  };
}

/// Makes {code, message}.
inline val from_coded(std::string_view code, std::string_view message) {
  val to = val::object();
  to.set("code", std::string(code));
  to.set("message", std::string(message));
  return to;
}

/// Makes an array of {code, message}.
inline val from_warnings(const std::vector<Warning>& warnings) {
  val to = val::array();
  for (const auto& [code, message] : warnings) to.call<void>("push", from_coded(code, message));
  return to;
}

/// Makes {code, message} of the exception that is being handled. Once for all functions: handlers
/// are much code.
[[gnu::noinline]] inline val from_exception() {
  try {
    throw;
  } catch (const Error& error) {
    return from_coded(error_code_name(error.code()), error.what());
  } catch (const std::bad_alloc&) {
    return from_coded("OUT_OF_MEMORY", "not enough memory for this mesh and these options");
  } catch (const std::length_error&) {
    return from_coded("OUT_OF_MEMORY", "an array would be longer than memory allows");
  } catch (const std::exception& error) {
    return from_coded("INTERNAL", error.what());
  } catch (...) {
    return from_coded("INTERNAL", "an exception of unknown type");
  }
}

/// Runs `work` and returns {value} or, whatever C++ exception it ends with, {code, message}.
template <typename Work>
val guard(Work&& work) {
  try {
    val answer = val::object();
    answer.set("value", work());
    return answer;
  } catch (...) {
    return from_exception();
  }
}

}  // namespace kdm::wasm
