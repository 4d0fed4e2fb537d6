// SPDX-License-Identifier: MIT
// The surface of filled cells is a complex of square faces. Its Euler characteristic is faces -
// edges + fans of faces round vertices. An edge of four faces is two edges of the parted surface:
// parted, they join the faces of the one and of the other solid cell; joined, the faces of the one
// and of the other void. Which is chosen decides what fans there are and which faces hang together.
#include "truth/account.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <numeric>
#include <vector>

namespace kdm::truth {
namespace {

constexpr int kMostChoices = 8;  // 2^8 combinations are tried
constexpr int kNoFace = -1;

// Sets that grow together.
class Sets {
 public:
  explicit Sets(std::size_t count) : above_(count) { std::iota(above_.begin(), above_.end(), 0); }
  int root(int i) {
    while (above_[i] != i) i = above_[i] = above_[above_[i]];
    return i;
  }
  void join(int a, int b) { above_[root(a)] = root(b); }
  int count() {
    int roots = 0;
    for (std::size_t i = 0; i < above_.size(); ++i) roots += above_[i] == static_cast<int>(i);
    return roots;
  }

 private:
  std::vector<int> above_;
};

Place moved(Place at, int axis, int by) {
  at[axis] += by;
  return at;
}

// An edge of the surface: its faces in the order round it; pair (0, 1), (2, 3) belongs to the cells
// that are parted from each other if `parted_first`, else pair (1, 2), (3, 0).
struct SurfaceEdge {
  int count = 0;
  std::array<int, 4> faces = {};
  bool parted_first = false;
  int choice = -1;  // of an edge of four faces
};

class Surface {
 public:
  explicit Surface(const Cells& cells) : cells_(cells) {
    for (int axis = 0; axis < 3; ++axis) {
      each_place([&](const Place& at) { add_face(axis, at); });
    }
    for (int axis = 0; axis < 3; ++axis) {
      each_place([&](const Place& at) { add_edge(axis, at); });
    }
    each_place([&](const Place& at) { add_vertex(at); });
  }

  int choices() const { return choices_; }

  // The topology if the contacts whose bits are set are joined, the others parted.
  Topology topology(unsigned joined) const {
    Sets parts(faces_.size());
    int euler = static_cast<int>(faces_.size());
    for (const auto& [where, edge] : edges_) {
      euler -= edge.count / 2;
      for (const auto& [a, b] : pairs(edge, joined)) parts.join(a, b);
    }
    for (const auto& [where, vertex] : vertices_) {
      euler += fans(vertex.edges, joined);
      if (vertex.choice < 0 || (joined >> vertex.choice & 1) == 0) continue;
      euler -= 2;  // a tube from the one fan to the other
      for (const int face : vertex.faces) parts.join(face, vertex.faces[0]);
    }
    return {parts.count(), euler};
  }

  // The least and the most that parts and characteristic can be.
  void bounds(Topology& least, Topology& most) const {
    Sets all(faces_.size());
    Sets sure(faces_.size());
    int low = static_cast<int>(faces_.size());
    for (const auto& [where, edge] : edges_) {
      low -= edge.count / 2;
      for (int i = 1; i < edge.count; ++i) all.join(edge.faces[0], edge.faces[i]);
      if (edge.count == 2) sure.join(edge.faces[0], edge.faces[1]);
    }
    int high = low;
    for (const auto& [where, vertex] : vertices_) {
      if (vertex.choice >= 0) {
        for (const int face : vertex.faces) all.join(face, vertex.faces[0]);
        high += 2;
        continue;
      }
      const auto [fewest, largest] = fan_bounds(vertex.edges);
      low += fewest;
      high += largest;
    }
    least = {all.count(), low};
    most = {sure.count(), high};
  }

 private:
  struct Vertex {
    std::vector<const SurfaceEdge*> edges;
    std::vector<int> faces;
    int choice = -1;
  };
  using Where = std::pair<int, Place>;  // axis, place of the lower end

  template <typename Visit>
  void each_place(const Visit& visit) const {
    for (int z = 0; z <= cells_.count(2); ++z) {
      for (int y = 0; y <= cells_.count(1); ++y) {
        for (int x = 0; x <= cells_.count(0); ++x) visit(Place{x, y, z});
      }
    }
  }

  void add_face(int axis, const Place& above) {
    if (cells_.filled(above) == cells_.filled(moved(above, axis, -1))) return;
    faces_.emplace(Where(axis, above), static_cast<int>(faces_.size()));
  }

  int face(int axis, const Place& above) const {
    const auto found = faces_.find(Where(axis, above));
    return found == faces_.end() ? kNoFace : found->second;
  }

  void add_edge(int axis, const Place& at) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    SurfaceEdge edge;
    for (const int f :
         {face(u, moved(at, v, -1)), face(v, at), face(u, at), face(v, moved(at, u, -1))}) {
      if (f != kNoFace) edge.faces[edge.count++] = f;
    }
    if (edge.count == 0) return;
    if (edge.count == 4) {
      // The cell between the first two faces.
      edge.parted_first = cells_.filled(moved(at, v, -1));
      const auto before = edges_.find(Where(axis, moved(at, axis, -1)));
      const bool goes_on = before != edges_.end() && before->second.count == 4 &&
                           before->second.parted_first == edge.parted_first;
      edge.choice = goes_on ? before->second.choice : choices_++;
    }
    edges_.emplace(Where(axis, at), edge);
  }

  void add_vertex(const Place& at) {
    Vertex vertex;
    bool touches = false;
    for (int axis = 0; axis < 3; ++axis) {
      for (const int by : {-1, 0}) {
        const auto found = edges_.find(Where(axis, moved(at, axis, by)));
        if (found == edges_.end()) continue;
        vertex.edges.push_back(&found->second);
        touches = touches || found->second.count == 4;
        const auto& faces = found->second.faces;
        vertex.faces.insert(vertex.faces.end(), faces.begin(), faces.begin() + found->second.count);
      }
    }
    if (vertex.edges.empty()) return;
    // Without edges of four faces, two fans are those of two opposite cells that touch here.
    if (!touches && fans(vertex.edges, 0) == 2) vertex.choice = choices_++;
    vertices_.emplace(at, std::move(vertex));
  }

  static std::vector<std::pair<int, int>> pairs(const SurfaceEdge& edge, unsigned joined) {
    const auto& f = edge.faces;
    if (edge.count == 2) return {{f[0], f[1]}};
    const bool join = (joined >> edge.choice & 1) != 0;
    if (edge.parted_first != join) return {{f[0], f[1]}, {f[2], f[3]}};
    return {{f[1], f[2]}, {f[3], f[0]}};
  }

  static int fans(const std::vector<const SurfaceEdge*>& edges, unsigned joined) {
    std::map<int, int> local;
    for (const SurfaceEdge* edge : edges) {
      for (int i = 0; i < edge->count; ++i) local.try_emplace(edge->faces[i], int(local.size()));
    }
    Sets fans(local.size());
    for (const SurfaceEdge* edge : edges) {
      for (const auto& [a, b] : pairs(*edge, joined)) fans.join(local[a], local[b]);
    }
    return fans.count();
  }

  // Over all choices at the edges of one vertex.
  static std::pair<int, int> fan_bounds(std::vector<const SurfaceEdge*> edges) {
    std::vector<SurfaceEdge> own;
    for (const SurfaceEdge* edge : edges) own.push_back(*edge);
    std::map<int, int> bits;
    for (SurfaceEdge& edge : own) {
      if (edge.count == 4)
        edge.choice = bits.try_emplace(edge.choice, int(bits.size())).first->second;
    }
    for (std::size_t i = 0; i < own.size(); ++i) edges[i] = &own[i];
    std::pair<int, int> found = {1000, 0};
    for (unsigned joined = 0; joined < 1u << bits.size(); ++joined) {
      const int n = fans(edges, joined);
      found = {std::min(found.first, n), std::max(found.second, n)};
    }
    return found;
  }

  const Cells& cells_;
  std::map<Where, int> faces_;
  std::map<Where, SurfaceEdge> edges_;
  std::map<Place, Vertex> vertices_;
  int choices_ = 0;
};

}  // namespace

bool AllowedTopology::holds(const Topology& found) const {
  if (any_of.contains(found)) return true;
  return ranges && found.first >= least.first && found.first <= most.first &&
         found.second >= least.second && found.second <= most.second;
}

Account account_of(const Cells& cells, check::Random& diagonals) {
  Account account;
  account.volume = cells.volume();
  account.boundary = boundary_of(cells, diagonals);
  const Surface surface(cells);
  account.contacts = surface.choices();
  AllowedTopology& allowed = account.topology;
  if (account.contacts <= kMostChoices) {
    for (unsigned joined = 0; joined < 1u << account.contacts; ++joined) {
      allowed.any_of.insert(surface.topology(joined));
    }
  } else {
    allowed.ranges = true;
    surface.bounds(allowed.least, allowed.most);
  }
  return account;
}

double volume_of(const Mesh& mesh) {
  if (mesh.positions.empty()) return 0;
  double six = 0;
  const Vec3 o = mesh.positions.front();
  for (const auto& [a, b, c] : mesh.triangles) {
    six += (mesh.positions[a] - o).dot((mesh.positions[b] - o).cross(mesh.positions[c] - o));
  }
  return six / 6;
}

double area_of(const Mesh& mesh) {
  double twice = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    twice +=
        (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]).norm();
  }
  return twice / 2;
}

}  // namespace kdm::truth
