#include "harness/sweep/response_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace signorini {

namespace {

Cell number_cell(const Measure& value) {
  return value ? Cell(fmt::format("{:.6g}", *value), *value) : Cell("-");
}

/// The largest value over the contacts; absent without contacts.
Measure largest(const std::vector<double>& values) {
  return values.empty() ? Measure{} : *std::max_element(values.begin(), values.end());
}

std::string_view way_name(const SweepPoint& point) { return point.back ? "back" : "there"; }

std::string stability_text(const SweepPoint& point) {
  if (!point.stable) return "-";
  return *point.stable ? "stable" : "unstable";
}

}  // namespace

Table response_table(const std::vector<SweepPoint>& points, bool certified) {
  Table table;
  table.header = {"omega [rad/s]", "way", "status", "x max [m]", "amplitude [m]", "contact ratio"};
  if (certified) table.header.emplace_back("stability");
  for (const SweepPoint& point : points) {
    std::vector<Cell> row{number_cell(point.frequency),           std::string(way_name(point)),
                          std::string(status_name(point.status)), number_cell(largest(point.x_max)),
                          number_cell(largest(point.amplitude)),  number_cell(point.contact_ratio)};
    if (certified) row.emplace_back(stability_text(point));
    table.rows.push_back(std::move(row));
  }
  return table;
}

nlohmann::ordered_json to_json(const SweepPoint& point) {
  nlohmann::ordered_json json{
      {"frequency", point.frequency}, {"way", way_name(point)}, {"status", status_name(point.status)}};
  if (!point.message.empty()) json["message"] = point.message;
  if (!point.x_max.empty()) json["x_max"] = point.x_max;
  if (!point.amplitude.empty()) json["amplitude"] = point.amplitude;
  if (point.contact_ratio) json["contact_ratio"] = *point.contact_ratio;
  if (point.stable) json["stable"] = *point.stable;
  return json;
}

}  // namespace signorini
