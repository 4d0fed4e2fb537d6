// SPDX-License-Identifier: MIT
// Takes the open parts out of faces that also have closed ones.
#pragma once

#include <vector>

#include "kdmanifold/build.h"
#include "mesh/marks.h"
#include "prepare/faces.h"

namespace kdm {

/// Parts of faces, joined by sides that are opposite to each other.
struct FaceParts {
  std::vector<Index> of;  ///< per triangle
  Marks open;             ///< per part: a side has no opposite

  bool open_triangle(TriangleId t) const { return open.test(of[t]); }
  bool some_closed() const { return open.count() < open.size(); }
};

FaceParts parts_of(const InputFaces& faces);

/// Some parts as a mesh over all points, and the part of each of its triangles.
struct PartsMesh {
  Mesh mesh;
  std::vector<Index> part_of;
};

/// Returns the parts whose flag in `parts.open` is `open`.
PartsMesh mesh_of_parts(const InputFaces& faces, const FaceParts& parts, bool open);

/// Inserts the triangles of a closed mesh before those of patches, which are the last ones. The
/// topology becomes invalid.
void insert_closed(const Mesh& solid, InputFaces& faces);

/// Adds how much was sewn and patched to another report.
void add_repairs(const InputReport& more, InputReport& sum);

/// What is made of open parts.
struct OpenParts {
  InputFaces faces;  ///< what stays open, prepared; there may be none
  Mesh closed;       ///< what closed once it was prepared by itself; `faces` does not hold it
  InputReport done;  ///< how much was sewn and patched; no more than that
};

/// Prepares open parts by themselves, again and again as long as that closes some of them. Throws
/// `kNotClosed` if the first time shows that they enclose nothing.
OpenParts prepare_by_themselves(Mesh open, const BuildOptions& options);

}  // namespace kdm
