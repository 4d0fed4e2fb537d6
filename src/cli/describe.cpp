// SPDX-License-Identifier: MIT
// Writes the tables of options and reports as JSON.
#include "cli/describe.h"

#include <regex>

#include "cli/help.h"
#include "cli/report_json.h"

namespace kdm::cli {
namespace {

// Names in backticks become those of JavaScript.
std::string in_javascript(const std::string& text) {
  static const std::regex kName("`[a-z]+(_[a-z]+)+`");
  std::string result;
  std::size_t done = 0;
  for (std::sregex_iterator name(text.begin(), text.end(), kName), end; name != end; ++name) {
    const auto at = static_cast<std::size_t>(name->position());
    result += text.substr(done, at - done) + camel_case(name->str());
    done = at + static_cast<std::size_t>(name->length());
  }
  return result + text.substr(done);
}

void add_text(Json& json, const char* key, const char* text) {
  if (text[0] != '\0') json[key] = in_javascript(text);
}

// Texts have neither range nor default.
void add_type(Json& json, const std::string&) { json["type"] = "text"; }

void add_type(Json& json, Repeated) {
  json["type"] = "text";
  json["repeats"] = true;
}

void add_type(Json& json, bool standard) {
  json["type"] = "boolean";
  json["default"] = standard;
}

void add_type(Json& json, const std::optional<bool>&) {
  json["type"] = "boolean";
  json["default"] = true;
}

void add_type(Json& json, const std::vector<Index>&) { json["type"] = "numbers"; }

void add_type(Json& json, const std::optional<BoxCorners>&) { json["type"] = "box"; }

template <typename Choice>
requires std::is_enum_v<Choice>
void add_type(Json& json, Choice standard) {
  json["type"] = "choice";
  if (word_of(standard) != nullptr) json["default"] = word_of(standard);
  for (const Word<Choice>& word : words_of<Choice>()) {
    json["words"].push_back({{"word", word.word}, {"help", in_javascript(word.help)}});
  }
}

template <typename Number>
requires std::is_arithmetic_v<Number>
void add_type(Json& json, Number standard) {
  json["type"] = std::is_integral_v<Number> ? "integer" : "number";
  json["default"] = standard;
}

void add_range(Json& json, const Range& range) {
  json["least"] = range.least;
  if (has_end(range)) json[range.most_excluded ? "below" : "most"] = range.most;
}

template <typename Value>
Json option_json(const OptionField& field, const Value& standard) {
  Json json = {{"name", camel_case(field.name)}, {"flag", flag_of(field, standard)}};
  add_text(json, "shortName", field.short_name);
  add_type(json, standard);
  if constexpr ((std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>) ||
                std::is_same_v<Value, std::vector<Index>>) {
    add_range(json, field.range);
  }
  add_text(json, "unset", field.unset);
  if (field.unset[0] != '\0') json.erase("default");
  add_text(json, "unit", unit_name(field.unit));
  add_text(json, "letter", field.letter);
  add_text(json, "help", field.help);
  add_text(json, "zero", field.zero);
  add_text(json, "details", field.details);
  return json;
}

template <typename Options>
Json options_json() {
  Json json = Json::array();
  const Options standard;
  for_each_field(standard, [&](const OptionField& field, const auto& value) {
    json.push_back(option_json(field, value));
  });
  return json;
}

// The types of values, `list` for numbers of faces or vertices one after the other.
template <typename Number>
requires std::is_arithmetic_v<Number>
const char* type_name(Number) { return std::is_integral_v<Number> ? "integer" : "number"; }
const char* type_name(bool) { return "boolean"; }
const char* type_name(const OrNone&) { return "integer or null"; }
const char* type_name(const std::optional<std::uint64_t>&) { return "integer or null"; }
const char* type_name(const Box&) { return "box"; }
const char* type_name(const MeshReport&) { return "MeshReport"; }
const char* type_name(const Deviation&) { return "Deviation"; }
const char* type_name(const std::vector<Vec3>&) { return "points"; }
const char* type_name(const std::vector<Index>&) { return "list"; }
const char* type_name(const std::vector<Edge>&) { return "list"; }
const char* type_name(const std::vector<std::vector<Index>>&) { return "lists"; }
const char* type_name(const std::vector<MeshPart>&) { return "MeshPart list"; }

template <typename Report>
Json report_json(const char* help) {
  Json keys = Json::array();
  const Report report;
  for_each_field(report, [&](const ReportField& field, const auto& value) {
    Json key = {{"name", camel_case(field.name)}, {"type", type_name(value)}};
    add_text(key, "unit", unit_name(field.unit));
    add_text(key, "help", field.help);
    keys.push_back(key);
  });
  return {{"help", help}, {"keys", keys}};
}

Json names_of(const Json& object) {
  Json names = Json::array();
  for (const auto& item : object.items()) names.push_back(item.key());
  return names;
}

// The part `output` of a run's report has keys of both: where both have one, it is the account's.
Json output_report(const Json& account, const Json& counts) {
  Json keys = Json::array();
  for (const Json& name : names_of(output_json({}, {}))) {
    const auto find_in = [&](const Json& report) {
      for (const Json& key : report["keys"]) {
        if (key["name"] == name) return key;
      }
      return Json();
    };
    const Json key = find_in(account);
    keys.push_back(key.is_null() ? find_in(counts) : key);
  }
  return {{"help", "The part of a report about the result"}, {"keys", keys}};
}

}  // namespace

std::string description() {
  Json json;
  json["options"] = {
      {"build", options_json<BuildOptions>()},         {"extract", options_json<ExtractOptions>()},
      {"reduction", options_json<ReductionOptions>()}, {"reduce", options_json<ReduceOptions>()},
      {"simplify", options_json<SimplifyOptions>()},   {"analyze", options_json<AnalyzeOptions>()},
      {"files", options_json<FileOptions>()},          {"report", options_json<ReportOptions>()},
      {"solids", options_json<SolidOptions>()}};
  Json& reports = json["reports"];
  reports["InputReport"] = report_json<InputReport>("What the grid was built from");
  reports["GridStats"] = report_json<GridStats>("The size of a grid");
  reports["ExtractReport"] = report_json<ExtractReport>("How a mesh was made of a grid");
  reports["SimplifyReport"] = report_json<SimplifyReport>("How a grid was simplified");
  reports["ReduceReport"] = report_json<ReduceReport>("How a mesh was reduced");
  reports["LostArea"] = report_json<LostArea>("What of the input the result does not come near");
  reports["Deviation"] = report_json<Deviation>("How far points of one surface are from another");
  reports["MeshError"] = report_json<MeshError>("How far a result and its input are apart");
  reports["MeshReport"] = report_json<MeshReport>(
      "What can be said about a mesh; two faces meet where they use the same vertex numbers. "
      "Degenerate faces are counted and take no part in anything else");
  reports["OutputReport"] = output_report(reports["ExtractReport"], reports["MeshReport"]);
  reports["SelfIntersections"] = report_json<SelfIntersections>(
      "Faces that cross or touch others where they share no vertex or edge");
  reports["MeshPart"] =
      report_json<MeshPart>("Faces joined by edges, as far as they are not degenerate");
  reports["MeshDefects"] = report_json<MeshDefects>(
      "What is wrong with a mesh, with the faces, edges and vertices at fault. Vertices of exactly "
      "equal position count as one: in lists the lowest of them stands for all. Faces are numbered "
      "as given, triangles first, then quads. Faces and vertices ascend; edges, two vertices each, "
      "do so by the lower, then by the higher vertex. Faces with a repeated vertex are in "
      "`degenerateFaces` and play no part in any other list");
  json["check"] = names_of(check_json({}));
  json["defects"] = names_of(defects_json({}));
  json["help"] = help_text();
  return json.dump(2) + "\n";
}

}  // namespace kdm::cli
