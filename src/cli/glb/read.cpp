// SPDX-License-Identifier: MIT
// Walks the nodes of a scene and collects its triangles. cli-glb-read.ts does the same, with the
// same sums in the same order, so that the same numbers come out.
#include "cli/glb/read.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>

#include "cli/glb/accessor.h"

namespace kdm::cli::glb {
namespace {

using Matrix = std::array<double, 16>;  // column by column
// Beyond this the library refuses coordinates.
constexpr double kFurthest = 1e150;
constexpr Matrix kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix result{};
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 4; ++row) {
      double sum = 0;
      for (std::size_t k = 0; k < 4; ++k) sum += a[4 * k + row] * b[4 * column + k];
      result[4 * column + row] = sum;
    }
  }
  return result;
}

double determinant(const Matrix& m) {
  return m[0] * (m[5] * m[10] - m[9] * m[6]) - m[4] * (m[1] * m[10] - m[9] * m[2]) +
         m[8] * (m[1] * m[6] - m[5] * m[2]);
}

template <std::size_t count>
std::array<double, count> numbers(const Container& file, const Json& node, const char* key,
                                  const std::string& path, std::array<double, count> standard) {
  const auto found = node.find(key);
  if (found == node.end()) return standard;
  bool right = found->is_array() && found->size() == count;
  for (std::size_t i = 0; right && i < count; ++i) {
    right = (*found)[i].is_number();
    if (right) standard[i] = (*found)[i].get<double>();
  }
  if (!right) file.fail(fmt::format("{}.{} is no list of {} numbers", path, key, count));
  return standard;
}

// Where a node puts its children and its mesh.
Matrix local_matrix(const Container& file, const Json& node, const std::string& path) {
  if (node.contains("matrix")) return numbers(file, node, "matrix", path, kIdentity);
  const auto t = numbers<3>(file, node, "translation", path, {0, 0, 0});
  const auto r = numbers<4>(file, node, "rotation", path, {0, 0, 0, 1});
  const auto s = numbers<3>(file, node, "scale", path, {1, 1, 1});
  const double x = r[0], y = r[1], z = r[2], w = r[3];
  return {(1 - 2 * (y * y + z * z)) * s[0],
          2 * (x * y + w * z) * s[0],
          2 * (x * z - w * y) * s[0],
          0,
          2 * (x * y - w * z) * s[1],
          (1 - 2 * (x * x + z * z)) * s[1],
          2 * (y * z + w * x) * s[1],
          0,
          2 * (x * z + w * y) * s[2],
          2 * (y * z - w * x) * s[2],
          (1 - 2 * (x * x + y * y)) * s[2],
          0,
          t[0],
          t[1],
          t[2],
          1};
}

// Cuts strips (5) and fans (6) into triangles, as the specification of glTF numbers their corners.
std::vector<Triangle> cut(const std::vector<Index>& corners, std::uint64_t mode) {
  std::vector<Triangle> triangles;
  if (mode == 4) {
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
      triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    }
    return triangles;
  }
  for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
    if (mode == 5) {
      triangles.push_back({corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
    } else {
      triangles.push_back({corners[i + 1], corners[i + 2], corners[0]});
    }
  }
  return triangles;
}

class Collector {
 public:
  explicit Collector(const Container& file) : file_(file) {}

  Scene collect() {
    const Json& nodes = list(file_, file_.json, "nodes", "the JSON");
    visited_.resize(nodes.size());
    if (nodes.empty()) {
      const std::size_t count = list(file_, file_.json, "meshes", "the JSON").size();
      for (std::size_t i = 0; i < count; ++i) add_mesh(i, "the JSON", kIdentity);
    }
    walk(roots(nodes.size()));
    return finish();
  }

 private:
  struct Visit {
    std::uint64_t node;
    std::string user;
    Matrix parent;
  };

  // The nodes of the scene; without a scene all that are no children.
  std::vector<Visit> roots(std::size_t node_count) const {
    std::vector<Visit> found;
    if (list(file_, file_.json, "scenes", "the JSON").empty()) {
      std::vector<bool> is_child(node_count);
      for (std::size_t i = 0; i < node_count; ++i) {
        const std::string path = fmt::format("nodes[{}]", i);
        for (const std::uint64_t child : children(element(file_, "nodes", i, path), path)) {
          if (child < node_count) is_child[child] = true;
        }
      }
      for (std::size_t i = 0; i < node_count; ++i) {
        if (!is_child[i]) found.push_back({i, "the JSON", kIdentity});
      }
      return found;
    }
    const std::uint64_t scene = whole(file_, file_.json, "scene", "the JSON", 0);
    const std::string path = fmt::format("scenes[{}]", scene);
    const Json& json = element(file_, "scenes", scene, "the JSON");
    for (const Json& node : list(file_, json, "nodes", path)) {
      found.push_back({whole(file_, node, path + ".nodes"), path, kIdentity});
    }
    return found;
  }

  std::vector<std::uint64_t> children(const Json& node, const std::string& path) const {
    std::vector<std::uint64_t> found;
    for (const Json& child : list(file_, node, "children", path)) {
      found.push_back(whole(file_, child, path + ".children"));
    }
    return found;
  }

  // Parents before children, children in their order.
  void walk(std::vector<Visit> stack) {
    std::reverse(stack.begin(), stack.end());
    while (!stack.empty()) {
      const Visit visit = std::move(stack.back());
      stack.pop_back();
      const Json& node = element(file_, "nodes", visit.node, visit.user);
      const std::string path = fmt::format("nodes[{}]", visit.node);
      if (visited_[visit.node]) file_.fail(path + " has two parents");
      visited_[visit.node] = true;
      const Matrix world = product(visit.parent, local_matrix(file_, node, path));
      if (node.contains("mesh")) add_mesh(whole(file_, node, "mesh", path), path, world);
      if (node.contains("skin")) skins_ = true;
      const std::vector<std::uint64_t> below = children(node, path);
      for (std::size_t i = below.size(); i-- > 0;) stack.push_back({below[i], path, world});
    }
  }

  void add_mesh(std::uint64_t index, const std::string& user, const Matrix& world) {
    const Json& json = element(file_, "meshes", index, user);
    const std::string path = fmt::format("meshes[{}]", index);
    const Json& primitives = list(file_, json, "primitives", path);
    placed_.clear();
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const std::string name = fmt::format("{}.primitives[{}]", path, i);
      if (!primitives[i].is_object()) file_.fail(name + " is no object");
      add_primitive(primitives[i], name, world);
    }
  }

  void add_primitive(const Json& json, const std::string& path, const Matrix& world) {
    const std::uint64_t mode = whole(file_, json, "mode", path, 4);
    if (mode > 6) file_.fail(fmt::format("{}.mode is {}, which does not exist", path, mode));
    const auto attributes = json.find("attributes");
    const bool has_points =
        attributes != json.end() && attributes->is_object() && attributes->contains("POSITION");
    if (mode < 4 || !has_points) {
      ++left_out_;
      return;
    }
    const std::uint64_t accessor = whole(file_, *attributes, "POSITION", path + ".attributes");
    const Placed placed = place(accessor, path, world);
    const std::vector<Index> corners = corners_of(json, path, placed.count);
    if (mode == 4 && corners.size() % 3 != 0) {
      file_.fail(fmt::format("{} has {} corners, which is no multiple of 3", path, corners.size()));
    }
    const bool mirrored = determinant(world) < 0;
    for (Triangle t : cut(corners, mode)) {
      if (mirrored) std::swap(t[1], t[2]);
      mesh_.triangles.push_back({t[0] + placed.first, t[1] + placed.first, t[2] + placed.first});
    }
  }

  std::vector<Index> corners_of(const Json& json, const std::string& path, Index count) {
    std::vector<Index> corners;
    if (!json.contains("indices")) {
      corners.resize(count);
      for (Index i = 0; i < count; ++i) corners[i] = i;
      return corners;
    }
    corners = read_numbers(file_, whole(file_, json, "indices", path), path);
    for (const Index corner : corners) {
      if (corner < count) continue;
      file_.fail(
          fmt::format("{}: index {} is out of range, there are {} vertices", path, corner, count));
    }
    return corners;
  }

  // Vertices of the result, one after the other.
  struct Placed {
    Index first, count;
  };

  // Adds the points; those that primitives of a mesh share are added once.
  Placed place(std::uint64_t accessor, const std::string& path, const Matrix& m) {
    const auto known = placed_.find(accessor);
    if (known != placed_.end()) return known->second;
    const std::vector<Vec3> points = read_points(file_, accessor, path);
    if (mesh_.positions.size() + points.size() > 0x7fffffff) {
      file_.fail("it has 2^31 vertices or more");
    }
    const Placed added{static_cast<Index>(mesh_.positions.size()),
                       static_cast<Index>(points.size())};
    for (const Vec3& p : points) {
      const Vec3 placed(m[0] * p[0] + m[4] * p[1] + m[8] * p[2] + m[12],
                        m[1] * p[0] + m[5] * p[1] + m[9] * p[2] + m[13],
                        m[2] * p[0] + m[6] * p[1] + m[10] * p[2] + m[14]);
      if (!(placed.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= kFurthest)) {
        file_.fail(fmt::format("{}: vertex {} lies at no finite place", path,
                               mesh_.positions.size() - added.first));
      }
      mesh_.positions.push_back(placed);
    }
    placed_.emplace(accessor, added);
    return added;
  }

  Scene finish() {
    Scene scene{std::move(mesh_), {}};
    const auto warn = [&scene](std::string message) {
      scene.warnings.push_back({"NOT_READ", std::move(message)});
    };
    if (left_out_ > 0) {
      warn(
          fmt::format("{} primitives without triangles (points or lines) are left out", left_out_));
    }
    if (skins_) warn("skins are left out: meshes are as they were modelled");
    for (const Json& used : list(file_, file_.json, "extensionsUsed", "the JSON")) {
      if (used == "EXT_mesh_gpu_instancing") {
        warn("EXT_mesh_gpu_instancing is left out: meshes are there once a node");
      }
    }
    return scene;
  }

  const Container& file_;
  Mesh mesh_;
  std::vector<bool> visited_;               // nodes
  std::map<std::uint64_t, Placed> placed_;  // accessors of the mesh that is being added
  std::uint64_t left_out_ = 0;              // primitives
  bool skins_ = false;
};

}  // namespace

Scene read(std::string_view bytes, const std::string& name) {
  const Container file = open(bytes, name);
  return Collector(file).collect();
}

}  // namespace kdm::cli::glb
