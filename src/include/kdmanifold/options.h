// SPDX-License-Identifier: MIT
// The one table of all options: names, legal values, meaning. The checks of the library, both
// command lines with their help, the JavaScript package with its types, and the table in README.md
// are made from it. A new option is a member of its struct with a default, and an entry here.
#pragma once

#include <array>
#include <concepts>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "kdmanifold/analyze.h"
#include "kdmanifold/build.h"
#include "kdmanifold/extract.h"
#include "kdmanifold/field.h"
#include "kdmanifold/make_manifold.h"
#include "kdmanifold/mesh_io.h"
#include "kdmanifold/reduce.h"
#include "kdmanifold/simplify.h"

namespace kdm {

inline constexpr std::array kStrategyWords = {
    Word{"adaptive", SplitStrategy::kAdaptive,
         "until the surface is met within the tolerance and its topology is resolved"},
    Word{"octree", SplitStrategy::kOctree, "the same, but at midpoints, x, y, z in turn"},
    Word{"feature", SplitStrategy::kFeature,
         "the same, but through or near features of the cell (paper 5.1.2 (2))"},
    Word{"median", SplitStrategy::kMedian,
         "median of triangle centres, until every triangle is hit by a grid edge (paper 5.1.2 "
         "(1))"},
    Word{"uniform", SplitStrategy::kUniform,
         "midpoints in turn, to the full depth wherever a cell meets the surface"}};

inline constexpr std::array kInsideWords = {
    Word{
        "repair", InsideRule::kRepair,
        "`positive` if the surface is closed, once its parts that are inside out are turned; any "
        "other becomes a solid: it is sewn and turned, patches over their corners close its holes, "
        "and small parts that bound nothing are left out; where much bounds nothing, the "
        "generalised winding number tells inside from outside"},
    Word{"positive", InsideRule::kPositive,
         "above 0, the union of overlapping and nested shells; closed input only, taken as its "
         "parts are turned"},
    Word{"odd", InsideRule::kOdd,
         "odd numbers, so that a part within another is a cavity however it is turned; closed "
         "input only"},
    Word{"nonzero", InsideRule::kNonzero, "all but 0; closed input only"},
    Word{"sheet", InsideRule::kSheet,
         "there is no inside: all of the surface is kept, as it is turned, and open surfaces stay "
         "open; the result is a manifold with boundary. Any mesh will do; it comes apart where "
         "neighbours are turned against each other"}};

inline constexpr std::array kPairingWords = {
    Word{"trace", Pairing::kTrace, "as the input's surface crosses the face"},
    Word{"hermite", Pairing::kHermite, "by the least deviation from the hits' tangents"},
    Word{"inside", Pairing::kInside,
         "the two hits at the ends of an inside stretch of the outline (paper 2.1)"},
    Word{"outside", Pairing::kOutside,
         "the two hits at the ends of an outside stretch of the outline (paper 2.1)"}};

inline constexpr std::array kThickenWords = {
    Word{"all", ThickenWhat::kAll, "all of it, whatever it bounds"},
    Word{"sheets", ThickenWhat::kSheets,
         "parts that bound nothing, also fins and ribs on solids, which stay as they are; of "
         "`repair`"}};

inline constexpr std::array kPositionWords = {
    Word{"constrained", VertexPosition::kConstrained, "to the best place within the cell"},
    Word{"projection", VertexPosition::kProjection,
         "to the point of the cell that is nearest to the best place"}};

inline constexpr std::array kPartsWords = {
    Word{"all", Parts::kAll,
         "all but crumbs, slivers thinner than the tolerance beside holes that were closed"},
    Word{"outer", Parts::kOuter,
         "only those that lie in no other: no cavities, and nothing within cavities"},
    Word{"largest", Parts::kLargest, "only the one that encloses most, without its cavities"}};

inline constexpr std::array kStrictWords = {
    Word{"off", Strict::kOff,
         "the raw dual surface, whose half-edges are manifold but not its vertex numbers"},
    Word{"manifold", Strict::kManifold,
         "2-manifold: vertices are added where two parts of the surface would share an edge, parts "
         "without volume are dropped"},
    Word{"embedded", Strict::kEmbedded,
         "the same, and no two triangles cross or touch but where they share vertices, none is "
         "without area; holds for the 32-bit coordinates, so vertices may be told by their "
         "positions alone, as in STL files. With `quads` as `manifold`"}};

inline constexpr std::array kFormatWords = {
    Word{"obj", MeshFormat::kObj, "Wavefront OBJ"}, Word{"stl", MeshFormat::kStl, "STL"},
    Word{"ply", MeshFormat::kPly, "PLY"}, Word{"off", MeshFormat::kOff, "OFF"}};

/// Returns the words of a choice, the default first or in the order in which they are best read.
template <typename Choice>
constexpr std::span<const Word<Choice>> words_of() {
  if constexpr (std::is_same_v<Choice, SplitStrategy>)
    return kStrategyWords;
  else if constexpr (std::is_same_v<Choice, InsideRule>)
    return kInsideWords;
  else if constexpr (std::is_same_v<Choice, Pairing>)
    return kPairingWords;
  else if constexpr (std::is_same_v<Choice, ThickenWhat>)
    return kThickenWords;
  else if constexpr (std::is_same_v<Choice, VertexPosition>)
    return kPositionWords;
  else if constexpr (std::is_same_v<Choice, Parts>)
    return kPartsWords;
  else if constexpr (std::is_same_v<Choice, Strict>)
    return kStrictWords;
  else
    return kFormatWords;
}

/// The words of a choice without their help, which programs that look words up need not hold.
template <typename Choice>
inline constexpr auto kBareWords = [] {
  std::array<std::pair<const char*, Choice>, words_of<Choice>().size()> bare{};
  for (std::size_t i = 0; i < bare.size(); ++i) {
    bare[i] = {words_of<Choice>()[i].word, words_of<Choice>()[i].value};
  }
  return bare;
}();

/// Returns the word for a value; null if the number behind it is that of no word.
template <typename Choice>
constexpr const char* word_of(Choice value) {
  for (const auto& bare : kBareWords<Choice>) {
    if (bare.second == value) return bare.first;
  }
  return nullptr;
}

/// Returns what a word stands for; nothing if it is none of the choice's.
template <typename Choice>
constexpr std::optional<Choice> value_of(std::string_view text) {
  for (const auto& bare : kBareWords<Choice>) {
    if (text == bare.first) return bare.second;
  }
  return std::nullopt;
}

/// Writes the words of a choice with the separator between them.
template <typename Choice>
std::string joined_words(std::string_view separator) {
  std::string text;
  for (const auto& bare : kBareWords<Choice>) {
    if (!text.empty()) text += separator;
    text += bare.first;
  }
  return text;
}

/// The struct itself, const or not.
template <typename T, typename Struct>
concept Either = std::same_as<std::remove_const_t<T>, Struct>;

/// Calls `visit(const OptionField&, member)` for every option, in the order in which help lists
/// them; members are const if the struct is.
template <Either<BuildOptions> Options, typename Visit>
void for_each_field(Options& options, Visit&& visit) {
  visit(OptionField{.name = "strategy", .help = "how cells are split"}, options.strategy);
  visit(OptionField{.name = "tolerance",
                    .letter = "T",
                    .help = "how far the result may be from the input",
                    .zero = "the relative tolerance counts instead",
                    .details = "Of `adaptive`, `octree` and `feature`.",
                    .unit = Unit::kModelUnits},
        options.tolerance);
  visit(OptionField{.name = "relative_tolerance",
                    .letter = "R",
                    .help = "the same, relative to the model's size",
                    .zero = "all that is not flat is split down to the depth limit",
                    .unit = Unit::kDiagonals},
        options.relative_tolerance);
  visit(OptionField{.name = "depth",
                    .letter = "N",
                    .help = "limit of the tree's depth",
                    .details = "Three levels halve a cell in each axis.",
                    .range = {.least = 1, .most = 60},
                    .unset = "60, or 18 for uniform, 64 cells an axis"},
        options.depth);
  visit(OptionField{.name = "cells",
                    .letter = "N",
                    .help = "resolution of `uniform` and `octree`: cells along the longest side",
                    .details = "Not together with `depth` and the tolerances.",
                    .range = {.least = 1, .most = 500'000},
                    .unset = "what the depth and the tolerance say"},
        options.cells);
  visit(OptionField{.name = "inside", .help = "which winding numbers are inside"}, options.inside);
  visit(OptionField{.name = "winding_threshold",
                    .letter = "W",
                    .help = "`repair`: winding numbers above this are inside",
                    .zero = "patches close holes; for parts that these do not close, what keeps "
                            "most of their area, at most 0.5",
                    .details = "Above 0 there are no patches, and it holds for closed parts as "
                               "well. Lower values close wider gaps, and let what bulges over the "
                               "gaps bulge further.",
                    .range = {.most = 1, .most_excluded = true}},
        options.winding_threshold);
  visit(OptionField{.name = "largest_hole",
                    .letter = "D",
                    .help = "`repair`: holes wider than this are refused",
                    .zero = "all are closed",
                    .details = "The width of a hole is the diagonal of its bounding box. The error "
                               "is `NOT_CLOSED`.",
                    .unit = Unit::kModelUnits},
        options.largest_hole);
  visit(OptionField{.name = "pairing",
                    .help = "how hits are linked where a face of the grid has more than two"},
        options.pairing);
  visit(OptionField{.name = "thicken",
                    .letter = "T",
                    .help = "build a shell of this thickness around the surface, which may be open",
                    .zero = "the input itself is built",
                    .details = "The report's `input` is that of the shell, unless only sheets get "
                               "one.",
                    .unit = Unit::kModelUnits},
        options.thicken);
  visit(OptionField{.name = "thicken_what", .help = "`thicken`: what gets a thickness"},
        options.thicken_what);
  visit(OptionField{.name = "minimum_thickness",
                    .letter = "T",
                    .help = "leave out what of the solid is thinner than this",
                    .zero = "nothing",
                    .details = "Up to 0.6 times as much stays where it ends in something thicker, "
                               "and edges of less than 54 degrees become blunt. Measured as "
                               "exactly as the tolerance.",
                    .unit = Unit::kModelUnits},
        options.minimum_thickness);
  visit(OptionField{.name = "minimum_gap",
                    .letter = "T",
                    .help = "fill gaps, holes and cavities that are narrower than this",
                    .zero = "none",
                    .details = "In the same way, after `minimum_thickness`.",
                    .unit = Unit::kModelUnits},
        options.minimum_gap);
  visit(
      OptionField{.name = "box",
                  .letter = "X,Y,Z,X,Y,Z",
                  .help = "the box over which the grid is laid, its lowest and its highest corner",
                  .details = "It must hold the model. Grids over the same box can be merged. One "
                             "that is much larger than the model costs precision: positions are "
                             "decided in steps of a millionth of its longest side.",
                  .unit = Unit::kModelUnits,
                  .unset = "the model's own bounding box"},
      options.box);
}

/// See `for_each_field` of `BuildOptions`.
template <Either<ExtractOptions> Options, typename Visit>
void for_each_field(Options& options, Visit&& visit) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  visit(OptionField{.name = "split_error",
                    .letter = "E",
                    .help = "split vertices that lie further than this from a plane they stand for",
                    .zero = "where a cell has two features",
                    .details = "A cell can then hold several features (paper 2.3.1). More than "
                               "the model's size: never. 0 splits where vertices are further off "
                               "than the grid's tolerance and 0.3 times the way to the furthest of "
                               "their hits, but never with `quads`.",
                    .unit = Unit::kModelUnits,
                    .range = {.most = kInfinity}},
        options.split_error);
  visit(OptionField{.name = "position",
                    .help = "where vertices go whose best place lies outside of their cell",
                    .details = "The best place is where the sum of squared distances to the planes "
                               "of the hits is least (paper 2.2.1)."},
        options.position);
  visit(OptionField{.name = "quads",
                    .help = "make quads where four cells meet",
                    .details = "The two triangles of such an edge are joined: everywhere on a "
                               "uniform grid. Quads need not be planar."},
        options.quads);
  visit(OptionField{.name = "unfold",
                    .help = "flip edges of triangles that are folded over or thin",
                    .details = "Folded over their neighbours, where that lays them flat; thin with "
                               "an angle below two degrees, where that makes their smallest angle "
                               "twice as wide. Takes away most self-intersections and most thin "
                               "triangles. Not with `quads`."},
        options.unfold);
  visit(OptionField{.name = "link_error",
                    .letter = "E",
                    .help = "put vertices where edges pass between cells further than this from "
                            "the surface",
                    .zero = "the grid's tolerance",
                    .details = "More than the model's size: never. Not with `quads`.",
                    .unit = Unit::kModelUnits,
                    .range = {.most = kInfinity}},
        options.link_error);
  visit(OptionField{.name = "parts",
                    .help = "which parts of the result are kept",
                    .details = "Sheets keep all."},
        options.parts);
  visit(OptionField{.name = "drop_parts",
                    .letter = "S",
                    .help = "leave out parts of the result smaller than this",
                    .zero = "none",
                    .details = "The size is the diagonal of the bounding box. What lies in them "
                               "goes too; parts within cavities count. Not for sheets.",
                    .unit = Unit::kModelUnits},
        options.drop_parts);
  visit(OptionField{.name = "drop_cavities",
                    .letter = "S",
                    .help = "fill cavities of the result smaller than this",
                    .zero = "none",
                    .details = "The size is the diagonal of the bounding box. What lies in them "
                               "becomes solid too. Not for sheets.",
                    .unit = Unit::kModelUnits},
        options.drop_cavities);
  visit(OptionField{.name = "drop_handles",
                    .letter = "S",
                    .help = "close tunnels and cut bridges of the result smaller than this",
                    .zero = "none",
                    .details = "The size is the length of the shortest closed path round a bridge "
                               "or along the wall of a tunnel: of a round hole its circumference. "
                               "It is closed or cut at its narrowest place. Not for sheets, nor "
                               "with `quads`, nor with `strict` off.",
                    .unit = Unit::kModelUnits},
        options.drop_handles);
  visit(OptionField{.name = "strict", .help = "what the result must be as an index mesh"},
        options.strict);
  visit(OptionField{.name = "normals",
                    .help =
                        "give the corners of faces normals for shading (of the files, OBJ and GLB "
                        "have them)",
                    .details = "Unit normals, from the input's normals at the hits. Vertices on a "
                               "crease are not doubled."},
        options.normals);
  visit(OptionField{.name = "crease_angle",
                    .letter = "A",
                    .help = "`normals`: they differ where faces turn by more than this",
                    .details = "At 0 they differ at all edges but in flat parts, at 180 "
                               "nowhere.",
                    .unit = Unit::kDegrees,
                    .range = {.most = 180}},
        options.crease_angle);
}

/// The numbers of triangles that both kinds of reduction take.
constexpr OptionField target_triangles_field(const char* help, const char* details) {
  return {.name = "target_triangles",
          .letter = "N[,N...]",
          .help = help,
          .details = details,
          .range = {.least = 1},
          .unset = "as few as the distance allows"};
}

/// See `for_each_field` of `BuildOptions`.
template <Either<ReductionOptions> Options, typename Visit>
void for_each_field(Options& options, Visit&& visit) {
  visit(
      OptionField{.name = "reduce",
                  .help = "collapse edges as long as the result stays within the tolerance",
                  .details = "The grid is then built at 0.8 times the tolerance, and the result is "
                             "embedded whatever `strict` says. Left out where `quads`, `strict` "
                             "off, a `strategy` without tolerance or a tolerance of 0 excludes "
                             "it; asked for beside one of these, it is refused."},
      options.reduce);
  visit(target_triangles_field(
            "how many triangles are to be left; several numbers, each smaller than the one before, "
            "make several levels: for -o name.obj the files name.1.obj, name.2.obj and so on",
            "The tolerance counts too, so that there may be more."),
        options.target_triangles);
  visit(OptionField{.name = "simplify",
                    .letter = "E",
                    .help = "remove splits of the grid as long as its surface stays this near to "
                            "what it was (paper section 4), which makes saved grids smaller",
                    .zero = "none",
                    .details = "The distance comes on top of the tolerance. For few triangles "
                               "alone, `reduce` does far more.",
                    .unit = Unit::kModelUnits},
        options.simplify);
  visit(OptionField{.name = "remove_material",
                    .letter = "T",
                    .help = "with `simplify`: bodies go from the grid into which no ball fits that "
                            "is wider than this, each with the cavities in it",
                    .zero = "none",
                    .details = "Nothing is cut off a body that stays; `minimum_thickness` does so.",
                    .unit = Unit::kModelUnits},
        options.remove_material);
  visit(OptionField{.name = "add_material",
                    .letter = "T",
                    .help = "with `simplify`: cavities are filled into which no ball fits that is "
                            "wider than this, once thin bodies have gone",
                    .zero = "none",
                    .details = "Tunnels, and gaps that lead outside, stay open; `minimum_gap` "
                               "closes them.",
                    .unit = Unit::kModelUnits},
        options.add_material);
}

/// See `for_each_field` of `BuildOptions`. Command lines do not have these.
template <Either<ReduceOptions> Options, typename Visit>
void for_each_field(Options& options, Visit&& visit) {
  visit(OptionField{.name = "error",
                    .letter = "E",
                    .help = "how far result and mesh may be apart",
                    .zero = "without limit, `target_triangles` decides",
                    .unit = Unit::kModelUnits},
        options.error);
  visit(target_triangles_field(
            "how many triangles are to be left; several numbers, each smaller than the one before, "
            "make several levels",
            "The error counts too, so that there may be more."),
        options.target_triangles);
}

/// See `for_each_field` of `BuildOptions`. Command lines do not have these.
template <Either<SimplifyOptions> Options, typename Visit>
void for_each_field(Options& options, Visit&& visit) {
  visit(OptionField{.name = "surface_error",
                    .letter = "E",
                    .help = "how far the surface may be, either way, from what it was when the "
                            "grid was built",
                    .details = "What calls before have used up counts.",
                    .unit = Unit::kModelUnits},
        options.surface_error);
  visit(OptionField{.name = "plane_error",
                    .letter = "E",
                    .help = "the paper's on-metric as a further limit: the root mean square "
                            "distance of merged hits from the plane that fits them best",
                    .zero = "no limit",
                    .unit = Unit::kModelUnits},
        options.plane_error);
  visit(OptionField{.name = "removed_material",
                    .letter = "T",
                    .help = "bodies go into which no ball fits that is wider than this, each with "
                            "the cavities in it",
                    .zero = "none",
                    .details = "Nothing is cut off a body that stays.",
                    .unit = Unit::kModelUnits},
        options.removed_material);
  visit(OptionField{.name = "added_material",
                    .letter = "T",
                    .help = "cavities are filled into which no ball fits that is wider than this, "
                            "once thin bodies have gone",
                    .zero = "none",
                    .details = "Tunnels, and gaps that lead outside, stay open.",
                    .unit = Unit::kModelUnits},
        options.added_material);
}

/// See `for_each_field` of `BuildOptions`. Command lines, whose --stats looks for everything, do
/// not have these.
template <Either<AnalyzeOptions> Options, typename Visit>
void for_each_field(Options& options, Visit&& visit) {
  visit(OptionField{.name = "self_intersections",
                    .help = "look for self-intersections too",
                    .details = "Takes several times as long as all the rest, and far longer where "
                               "many faces overlap that are no copies of each other."},
        options.self_intersections);
}

/// Throws `kInvalidOption` for the first option that is outside of its range, is no number or has a
/// value without a word; the message names the option, its value and what is legal. Then for the
/// first that differs from its default and has no effect beside the others.
void check_options(const BuildOptions& options);
/// See above.
void check_options(const ExtractOptions& options);
/// See above.
void check_options(const ReductionOptions& options);
/// See above. One of the two must be given.
void check_options(const ReduceOptions& options);
/// See above. The surface error must be above 0.
void check_options(const SimplifyOptions& options);

/// Says whether an option was given, by its name.
using IsGiven = std::function<bool(std::string_view)>;

/// Throws `kInvalidOption` for the first option that was given and has no effect beside the others.
/// In the message, names of options stand in backticks.
void check_combination(const BuildOptions& options, const IsGiven& given);
/// See above.
void check_combination(const ExtractOptions& options, const IsGiven& given);
/// See above.
void check_combination(const ReductionOptions& options, const IsGiven& given);

}  // namespace kdm
