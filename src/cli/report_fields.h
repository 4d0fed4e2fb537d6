// SPDX-License-Identifier: MIT
// Turns reports into JSON objects by their tables in kdmanifold/reports.h.
#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "kdmanifold/reports.h"

namespace kdm::cli {

using Json = nlohmann::ordered_json;

/// Sets `json` to the value. A list is represented by its length.
template <typename Value>
requires std::is_arithmetic_v<Value>
void set_value(Json& json, Value value) { json = value; }
template <typename Element>
void set_value(Json& json, const std::vector<Element>& list) {
  json = list.size();
}
template <typename Value>
void set_value(Json& json, const std::optional<Value>& value) {
  json = value ? Json(*value) : Json();
}
inline void set_value(Json& json, const std::vector<Vec3>& points) {
  json = Json::array();
  for (const Vec3& p : points) json.push_back({p[0], p[1], p[2]});
}
inline void set_value(Json& json, const Deviation& deviation) {
  json = {{"largest", deviation.largest}, {"rms", deviation.rms}};
}
/// Other structures have no place in these objects; no key names one.
inline void set_value(Json&, const Box&) {}
inline void set_value(Json&, const MeshReport&) {}

/// Adds all fields of the report. Keys that are there already keep their places.
template <typename Report>
void add_fields(Json& json, const Report& report) {
  for_each_field(report, [&](const ReportField& field, const auto& value) {
    set_value(json[camel_case(field.name)], value);
  });
}

/// Adds the named fields only, in the order of the names.
template <typename Report>
void add_fields(Json& json, const Report& report, std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) {
    for_each_field(report, [&](const ReportField& field, const auto& value) {
      if (name == field.name) set_value(json[camel_case(name)], value);
    });
  }
}

}  // namespace kdm::cli
