// SPDX-License-Identifier: MIT
// Checks options against the table in kdmanifold/options.h.
#include <cmath>
#include <initializer_list>
#include <limits>

#include "kdmanifold/error.h"
#include "kdmanifold/options.h"
#include "text/compose.h"

namespace kdm {
namespace {

[[noreturn]] void refuse(const char* name, double value, const std::string& legal) {
  throw Error(ErrorCode::kInvalidOption, compose("{} is {}; it must be {}", name, value, legal));
}

// Takes what it needs of a field, so that compilers drop the other texts.
void check_number(const char* name, Range range, const char* unset, double value,
                  const char* kind) {
  const bool may_be_unset = unset[0] != '\0';
  if (contains(range, value) || (may_be_unset && value == 0)) return;
  std::string legal = compose("a {} {}", kind, range_text(range));
  if (may_be_unset) legal += compose(", or 0, which stands for {}", unset);
  refuse(name, value, legal);
}

template <typename Choice>
void check_choice(const char* name, Choice value) {
  if (word_of(value) != nullptr) return;
  refuse(name, static_cast<double>(value), "one of " + joined_words<Choice>(", "));
}

void check_list(const char* name, Range range, const std::vector<Index>& numbers) {
  double last = std::numeric_limits<double>::infinity();
  for (const Index number : numbers) {
    if (contains(range, number) && number < last) {
      last = number;
      continue;
    }
    refuse(name, number,
           compose("a whole number {}, smaller than the one before", range_text(range)));
  }
}

void check_box(const char* name, const std::optional<BoxCorners>& box) {
  if (!box || is_box(*box)) return;
  throw Error(ErrorCode::kInvalidOption,
              compose("{}: it must be a box of finite numbers, with the lowest corner before the "
                      "highest",
                      name));
}

template <typename Options>
void check_fields(const Options& options) {
  for_each_field(options, [](const OptionField& field, const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_enum_v<Value>) {
      check_choice(field.name, value);
    } else if constexpr (std::is_same_v<Value, std::vector<Index>>) {
      check_list(field.name, field.range, value);
    } else if constexpr (std::is_same_v<Value, std::optional<BoxCorners>>) {
      check_box(field.name, value);
    } else if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>) {
      check_number(field.name, field.range, field.unset, value,
                   std::is_integral_v<Value> ? "whole number" : "number");
    }
  });
}

// An option that may have no effect.
struct Effect {
  const char* name;
  bool exists;
  const char* when;
};

// Refuses the first option that was given and has no effect.
void demand(std::initializer_list<Effect> effects, const IsGiven& given) {
  for (const Effect& effect : effects) {
    if (effect.exists || !given(effect.name)) continue;
    throw Error(ErrorCode::kInvalidOption, compose("`{}`: {}", effect.name, effect.when));
  }
}

}  // namespace

bool is_box(const BoxCorners& corners) {
  bool ascends = true;
  bool has_extent = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const double low = corners[i];
    const double high = corners[i + 3];
    ascends = ascends && std::isfinite(low) && std::isfinite(high) && low <= high;
    has_extent = has_extent || low < high;
  }
  return ascends && has_extent;
}

void check_combination(const BuildOptions& options, const IsGiven& given) {
  const bool counts =
      options.strategy == SplitStrategy::kMedian || options.strategy == SplitStrategy::kUniform;
  const bool repair = options.inside == InsideRule::kRepair;
  const bool sided = options.pairing == Pairing::kInside || options.pairing == Pairing::kOutside;
  const bool sheets = options.thicken_what == ThickenWhat::kSheets;
  const bool shells_all = options.thicken > 0 && !sheets;
  const char* const by_tolerance = "only with `strategy` adaptive, octree or feature";
  const char* const by_repair = "only with `inside` repair";
  const bool solid = repair || options.inside == InsideRule::kPositive;
  const char* const by_solid = "only with `inside` repair or positive";
  const bool regular =
      options.strategy == SplitStrategy::kUniform || options.strategy == SplitStrategy::kOctree;
  const char* const instead_of_cells = "not together with `cells`";
  demand({{"cells", regular, "only with `strategy` octree or uniform"},
          {"depth", options.cells == 0, instead_of_cells},
          {"tolerance", options.cells == 0, instead_of_cells},
          {"relative_tolerance", options.cells == 0, instead_of_cells},
          {"relative_tolerance", options.tolerance == 0, "not together with `tolerance`"},
          {"tolerance", !counts, by_tolerance},
          {"relative_tolerance", !counts, by_tolerance},
          {"winding_threshold", repair, by_repair},
          {"largest_hole", repair, by_repair},
          {"largest_hole", !shells_all, "not together with `thicken`, which leaves no holes"},
          {"thicken_what", options.thicken > 0, "only with `thicken`"},
          {"thicken_what", !sheets || repair, "sheets only with `inside` repair"},
          {"thicken_what", !sheets || options.winding_threshold == 0,
           "not sheets together with `winding_threshold`"},
          {"minimum_thickness", !counts, by_tolerance},
          {"minimum_gap", !counts, by_tolerance},
          {"minimum_thickness", options.cells == 0, instead_of_cells},
          {"minimum_gap", options.cells == 0, instead_of_cells},
          {"minimum_thickness", solid, by_solid},
          {"minimum_gap", solid, by_solid},
          {"pairing", !sided || options.inside != InsideRule::kSheet,
           "only trace or hermite with `inside` sheet"}},
         given);
}

void check_combination(const ExtractOptions& options, const IsGiven& given) {
  demand({{"strict", !options.quads || options.strict != Strict::kEmbedded,
           "not embedded together with `quads`"},
          {"link_error", !options.quads, "not together with `quads`"},
          {"drop_handles", !options.quads, "not together with `quads`"},
          {"drop_handles", options.strict != Strict::kOff, "not together with `strict` off"},
          {"crease_angle", options.normals, "only with `normals`"}},
         given);
}

void check_combination(const ReductionOptions& options, const IsGiven& given) {
  const char* const by_simplify = "only with `simplify`";
  demand({{"remove_material", options.simplify > 0, by_simplify},
          {"add_material", options.simplify > 0, by_simplify}},
         given);
}

void check_options(const BuildOptions& options) {
  check_fields(options);
  const BuildOptions standard;
  check_combination(options, [&](std::string_view name) {
    if (name == "cells") return options.cells != standard.cells;
    if (name == "depth") return options.depth != standard.depth;
    if (name == "tolerance") return options.tolerance != standard.tolerance;
    if (name == "relative_tolerance") {
      return options.relative_tolerance != standard.relative_tolerance;
    }
    if (name == "winding_threshold") return options.winding_threshold != standard.winding_threshold;
    if (name == "largest_hole") return options.largest_hole != standard.largest_hole;
    if (name == "thicken_what") return options.thicken_what != standard.thicken_what;
    if (name == "minimum_thickness") return options.minimum_thickness != standard.minimum_thickness;
    if (name == "minimum_gap") return options.minimum_gap != standard.minimum_gap;
    return options.pairing != standard.pairing;
  });
}

void check_options(const ExtractOptions& options) {
  check_fields(options);
  const ExtractOptions standard;
  check_combination(options, [&](std::string_view name) {
    if (name == "strict") return options.strict != standard.strict;
    if (name == "link_error") return options.link_error != standard.link_error;
    if (name == "drop_handles") return options.drop_handles != standard.drop_handles;
    return options.crease_angle != standard.crease_angle;
  });
}

void check_options(const ReductionOptions& options) {
  check_fields(options);
  check_combination(options, [&](std::string_view name) {
    return (name == "remove_material" ? options.remove_material : options.add_material) > 0;
  });
}

void check_options(const ReduceOptions& options) {
  check_fields(options);
  if (options.error > 0 || !options.target_triangles.empty()) return;
  throw Error(ErrorCode::kInvalidOption,
              "error is 0; it must be above 0, or target_triangles given");
}

void check_options(const SimplifyOptions& options) {
  check_fields(options);
  if (options.surface_error > 0) return;
  throw Error(ErrorCode::kInvalidOption, "surface_error is 0; it must be above 0");
}

}  // namespace kdm
