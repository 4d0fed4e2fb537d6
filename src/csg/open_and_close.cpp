// SPDX-License-Identifier: MIT
#include "csg/open_and_close.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "construct/grid_of_surface.h"
#include "inside/thick_field.h"
#include "inside/winding_field.h"
#include "inside/winding_oracle.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "mesh/measure.h"
#include "mesh/progress.h"
#include "text/compose.h"

namespace kdm {
namespace {

// The boundary's area in squares of the size: about 20 points are looked at in each.
constexpr double kMostSquares = 250000;
// The part of the size by which it may be missed, at most.
constexpr double kMostSlack = 1.0 / 16;

using Side = ThickField::Side;

// Where the field of a surface changes at its triangles.
std::shared_ptr<const PointField> field_of(const Surface& surface, const BuildOptions& options,
                                           double tolerance) {
  constexpr double kClosed = 0.5;
  return std::make_shared<WindingField>(
      surface.triangles, surface.repair ? options.winding_threshold : kClosed, tolerance);
}

std::vector<ThickField::Corners> boundary_of(const Mesh& mesh, const Lattice& lattice) {
  std::vector<ThickField::Corners> boundary;
  boundary.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    ThickField::Corners corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = lattice.to_lattice(mesh.positions[t[i]]);
    boundary.push_back(corners);
  }
  return boundary;
}

void check_size(const char* name, double size, double area) {
  const double least = std::sqrt(area / kMostSquares);
  if (size >= least) return;
  throw Error(
      ErrorCode::kInvalidOption,
      compose("`{}` is {}; for a surface of this area it must be {} at least", name, size, least));
}

// The field that a surface has, and becomes.
class OpenedAndClosed {
 public:
  OpenedAndClosed(Grid plain, Surface surface, const BuildOptions& options, double tolerance,
                  const Progress& progress)
      : grid_(std::move(plain)),
        surface_(std::move(surface)),
        options_(options),
        tolerance_(tolerance),
        progress_(progress),
        field_(field_of(surface_, options, tolerance)) {
    surface_.repair = true;  // from here on the field decides, and not the crossings
  }

  void run() {
    if (options_.minimum_thickness > 0) {
      change("minimum_thickness", options_.minimum_thickness, Side::kInside, thin_area_);
    }
    if (options_.minimum_gap > 0) {
      change("minimum_gap", options_.minimum_gap, Side::kOutside, narrow_area_);
    }
  }

  Grid take() { return std::move(grid_); }

 private:
  void change(const char* name, double size, Side side, double& area) {
    const Mesh solid = extract(grid_, {.strict = Strict::kManifold});
    check_size(name, size, area_of(solid));
    const Lattice& lattice = surface_.lattice;
    const double width = size / lattice.step;
    auto field = std::make_shared<ThickField>(field_, boundary_of(solid, lattice), side, width,
                                              std::min(tolerance_, kMostSlack * width));
    if (field->thin_area() == 0) return;
    if (side == Side::kInside && field->nothing_is_thick()) {
      throw Error(ErrorCode::kEmptyResult, "all of the solid is thinner than `minimum_thickness`");
    }
    area = field->thin_area() * lattice.step * lattice.step;
    field_ = std::move(field);
    build();
  }

  void build() {
    WindingOracle model(surface_, field_, tolerance_);
    std::unique_ptr<GridData> data =
        grid_of_surface(surface_, model, options_, tolerance_, {}, progress_);
    data->stats.thin_area = thin_area_;
    data->stats.narrow_area = narrow_area_;
    grid_ = Grid(std::move(data));
  }

  Grid grid_;
  Surface surface_;
  const BuildOptions& options_;
  double tolerance_;
  const Progress& progress_;
  std::shared_ptr<const PointField> field_;
  double thin_area_ = 0;
  double narrow_area_ = 0;
};

}  // namespace

Grid open_and_close(Grid plain, Surface surface, const BuildOptions& options, double tolerance,
                    const Progress& progress) {
  OpenedAndClosed work(std::move(plain), std::move(surface), options, tolerance, progress);
  work.run();
  return work.take();
}

}  // namespace kdm
