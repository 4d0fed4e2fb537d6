// SPDX-License-Identifier: MIT
#include "truth/judge.h"

#include <Eigen/Geometry>

#include <chrono>
#include <cmath>
#include <optional>
#include <sstream>

#include "kdmanifold/account.h"
#include "kdmanifold/boolean.h"
#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "support/mesh_check.h"
#include "support/random.h"
#include "truth/near.h"
#include "truth/parts.h"

namespace kdm::truth {
namespace {

// The documented bound on distances, measured both ways.
constexpr double kDistance = 1.5;
// How far the volume of an expression may be off: a share of itself, and one of tolerance x area.
constexpr double kShare = 1e-4;
constexpr double kSwept = 0.125;

double seconds_now() {
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

// Corners, middles of sides and of triangles, and points by area.
std::vector<Vec3> samples_of(const Mesh& mesh) {
  constexpr int kByArea = 600;
  std::vector<Vec3> samples;
  check::Random random(7);
  const double area = area_of(mesh);
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vec3& a = mesh.positions[i];
    const Vec3& b = mesh.positions[j];
    const Vec3& c = mesh.positions[k];
    samples.insert(samples.end(), {a, (a + b) / 2, (b + c) / 2, (a + b + c) / 3});
    const double share = (b - a).cross(c - a).norm() / 2 / area;
    const int count = static_cast<int>(kByArea * share + random.unit());
    for (int s = 0; s < count; ++s) {
      double u = random.unit();
      double v = random.unit();
      if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      samples.push_back(a + u * (b - a) + v * (c - a));
    }
  }
  return samples;
}

bool has_triangle_without_area(const Mesh& mesh) {
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 normal =
        (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
    if (normal.isZero(0)) return true;
  }
  return false;
}

class Judgement {
 public:
  explicit Judgement(const Solid& solid) : solid_(solid) {
    reach_ = kDistance * solid.tolerance + solid.slack;
    area_ = area_of(solid.account.boundary);
  }

  Verdict take() {
    Grid grid;
    try {
      const double start = seconds_now();
      grid = built();
      verdict_.seconds += seconds_now() - start;
      verdict_.topology_resolved = grid.stats().topology_resolved;
      verdict_.topology_right = true;
      look_at("manifold", grid, Strict::kManifold);
      verdict_.manifold_right = verdict_.right();
      look_at("embedded", grid, Strict::kEmbedded);
      if (solid_.expression) look_at_reduced();
    } catch (const Error& error) {
      // The documented answer to what encloses nothing.
      const bool nothing = solid_.account.volume == 0;
      const bool empty = error.code() == ErrorCode::kEmptyResult;
      verdict_.topology_right = nothing && (empty || error.code() == ErrorCode::kNotClosed);
      verdict_.manifold_right = verdict_.topology_right;
      if (!verdict_.topology_right) {
        fail(empty ? kMissing : kThrows)
            << error_code_name(error.code()) << ": " << error.what() << '\n';
      }
    } catch (const std::exception& error) {
      verdict_.topology_right = false;
      fail(kThrows) << error.what() << '\n';
    }
    verdict_.words = words_.str();
    return verdict_;
  }

 private:
  std::ostream& fail(Check check) {
    verdict_.failed.set(check);
    return words_ << check_name(check) << ": ";
  }

  Grid built() const {
    const BuildOptions options{.tolerance = solid_.tolerance};
    if (!solid_.expression) return build_grid(solid_.input, options);
    return build_csg_grid(operands(), *solid_.expression, options);
  }

  std::vector<Operand> operands() const { return {solid_.operands.begin(), solid_.operands.end()}; }

  void look_at(const char* name, const Grid& grid, Strict strict) {
    const double start = seconds_now();
    const ExtractedMesh result = extract(grid, {.strict = strict});
    verdict_.seconds += seconds_now() - start;
    // What a result lacks of its input cannot be told of an expression.
    std::optional<kdm::Account> account;
    if (!solid_.expression) account = compare(solid_.input, grid, result, {.error = true});
    check_result(name, result, account, strict, verdict_.topology_resolved);
  }

  // What users get of Boolean operations.
  void look_at_reduced() {
    const double start = seconds_now();
    const BooleanMesh result =
        boolean(*solid_.expression, operands(), {.tolerance = solid_.tolerance});
    verdict_.seconds += seconds_now() - start;
    check_result("reduced", result, std::nullopt, Strict::kEmbedded,
                 result.stats.topology_resolved);
  }

  // What everybody is told, also who does not ask for the error.
  static bool says_lost(const kdm::Account& account) {
    return std::any_of(account.warnings.begin(), account.warnings.end(),
                       [](const Warning& warning) { return warning.code == "AREA_LOST"; });
  }

  void check_result(const char* name, const ExtractedMesh& result,
                    const std::optional<kdm::Account>& account, Strict strict, bool resolved) {
    words_ << name << ": " << result.triangles.size() << " triangles";
    for (const Warning& warning : result.warnings) words_ << ", " << warning.code;
    verdict_.warned = !result.warnings.empty();
    if (account) {
      for (const Warning& warning : account->warnings) words_ << ", " << warning.code;
      verdict_.warned = verdict_.warned || says_lost(*account);
    }
    words_ << (resolved ? ", resolved" : "") << '\n';
    if (solid_.account.volume == 0) {
      fail(kVolume) << "a solid, where nothing is enclosed\n";
      return;
    }
    verdict_.triangles = double(result.triangles.size()) / double(solid_.input.triangles.size());
    check_surface(result, strict, resolved);
    check_volume(result);
    check_distances(result, account);
  }

  void check_surface(const ExtractedMesh& result, Strict strict, bool resolved) {
    const check::MeshCheck found = check::check_mesh(result);
    if (!found.two_manifold) fail(kFaulty) << found.faults() << '\n';
    const Topology topology(found.components, static_cast<int>(found.euler_characteristic));
    if (!solid_.account.topology.holds(topology)) {
      verdict_.topology_right = false;
      words_ << "topology: " << topology.first << " parts of characteristic " << topology.second
             << '\n';
      if (resolved) fail(kFalseClaim) << "said to be resolved\n";
    }
    if (strict != Strict::kEmbedded) return;
    if (has_triangle_without_area(result)) fail(kFaulty) << "a triangle without area\n";
    const SelfIntersections crossings = find_self_intersections(result);
    if (crossings.pairs > 0) {
      fail(kCrossing) << crossings.pairs << " pairs, of which the report has "
                      << result.report.crossings.value_or(0) << '\n';
    }
  }

  // A surface that is within the tolerance everywhere sweeps no more than tolerance x area. Blocks
  // have nothing between their corners, and what several of them leave is hardly off at all.
  void check_volume(const ExtractedMesh& result) {
    const double bound = (solid_.tolerance + solid_.slack) * area_;
    const double off = std::abs(volume_of(result) - solid_.account.volume);
    verdict_.volume = std::max(verdict_.volume, off / bound);
    if (solid_.expression && off > kShare * solid_.account.volume + kSwept * bound) {
      fail(kInexact) << off / solid_.account.volume << " of the volume\n";
    }
    if (off <= bound) return;
    fail(kVolume) << volume_of(result) << " for " << solid_.account.volume << ", " << off / bound
                  << " of the bound off\n";
    if (!verdict_.warned) fail(kSilent) << "wrong volume\n";
  }

  void check_distances(const ExtractedMesh& result, const std::optional<kdm::Account>& account) {
    Mesh expected = solid_.input;
    append(expected, solid_.account.boundary);
    const Miss far = worst(result.positions, Near(expected));
    if (far.tolerances > 0) {
      fail(kFar) << "a vertex by " << far.tolerances << " tolerances, at " << far.at.transpose()
                 << '\n';
    }
    const Miss missing = worst(samples_of(solid_.account.boundary), Near(result));
    if (missing.tolerances > 0) {
      fail(kMissing) << "surface by " << missing.tolerances << " tolerances, at "
                     << missing.at.transpose() << '\n';
      if (!verdict_.warned) fail(kSilent) << "missing surface\n";
    }
    verdict_.far = std::max(verdict_.far, far.tolerances);
    verdict_.missing = std::max(verdict_.missing, missing.tolerances);
    if (!account) return;
    if (account->error->to_input.largest < (1 - 1e-9) * far.tolerances * solid_.tolerance) {
      fail(kAccount) << "a vertex is further away than is said\n";
    }
    if (says_lost(*account) && missing.tolerances == 0) check_lost(result, account->lost);
    // Gaps that were given up count as within the solid; that they were is told.
    if (missing.tolerances > 0 && account->warnings.empty() && result.warnings.empty()) {
      fail(kAccount) << "the error is measured, and nothing is said of it\n";
    }
  }

  // The solid's surface is all there. What is said to be lost of the input all the same, as faces
  // on each other that bound nothing, must be far from the result.
  void check_lost(const ExtractedMesh& result, const LostArea& lost) {
    Mesh faces;
    faces.positions = solid_.input.positions;
    for (const Index face : lost.faces) faces.triangles.push_back(solid_.input.triangles[face]);
    if (worst(samples_of(faces), Near(result)).tolerances > 0) return;
    fail(kAccount) << 100 * lost.share << " % are said to be lost\n";
  }

  // The point that is furthest, among those that are too far.
  struct Miss {
    Vec3 at = Vec3::Zero();
    double tolerances = 0;
  };
  Miss worst(const std::vector<Vec3>& points, Near near) const {
    Miss found;
    for (const Vec3& point : points) {
      if (near.within(point, reach_)) continue;
      const double distance = near.distance(point) / solid_.tolerance;
      if (distance > found.tolerances) found = {point, distance};
    }
    return found;
  }

  const Solid& solid_;
  Verdict verdict_;
  std::ostringstream words_;
  double reach_ = 0;
  double area_ = 0;
};

}  // namespace

const char* check_name(std::size_t check) {
  constexpr std::array<const char*, kChecks> kNames = {
      "throws", "faulty",  "volume", "false claim", "crossing",
      "far",    "missing", "silent", "account",     "inexact"};
  return kNames[check];
}

Verdict judge(const Solid& solid) { return Judgement(solid).take(); }

}  // namespace kdm::truth
