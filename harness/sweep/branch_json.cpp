#include "harness/sweep/branch_json.hpp"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "harness/records/json_fields.hpp"
#include "harness/records/record_check.hpp"
#include "harness/text/json.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

Json multipliers_json(const Eigen::VectorXcd& multipliers) {
  Json list = Json::array();
  for (const auto& mu : multipliers) list.push_back({mu.real(), mu.imag()});
  return list;
}

Json motion_json(const Eigen::MatrixXd& motion) {
  Json rows = Json::array();
  for (const auto& row : motion.rowwise()) rows.push_back(std::vector<double>(row.begin(), row.end()));
  return rows;
}

void add_point(Json& json, const SolutionPoint& point) {
  const bool told = point.stability == OrbitStability::stable || point.stability == OrbitStability::unstable;
  json["omega"] = point.frequency;
  json["order"] = point.order;
  json["amplitude"] = point.amplitude;
  json["x_max"] = point.x_max;
  json["impacts"] = point.impacts;
  json["stable"] = told ? Json(point.stability == OrbitStability::stable) : Json();
  json["stability"] = enum_name(point.stability);
  if (!point.undefined.empty()) json["stability_reason"] = point.undefined;
  json["multipliers"] = multipliers_json(point.multipliers);
  if (point.parameter != point.frequency) json["value"] = point.parameter;
  if (point.energy) json["energy"] = *point.energy;
  if (point.damping_ratio) json["damping_ratio"] = *point.damping_ratio;
  if (point.second) json["second"] = *point.second;
  if (point.motion.size() > 0) json["motion"] = motion_json(point.motion);
}

Json special_json(const SpecialPoint& special) {
  Json json{{"kind", enum_name(special.kind)}};
  add_point(json, special.point);
  json["after"] = special.after;
  if (!special.text.empty()) json["text"] = special.text;
  return json;
}

double number_of_json(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

std::vector<double> numbers_of_json(const Json& json) {
  std::vector<double> numbers;
  for (const Json& one : json.get_ref<const Json::array_t&>()) numbers.push_back(number_of_json(one));
  return numbers;
}

std::size_t count_of_json(const Json& json, const char* field, std::size_t least, std::size_t most) {
  const Json& value = json.at(field);
  if (!value.is_number_integer() || value < least || value > most)
    throw BadRecord(fmt::format("{} = {} (must be a whole number, {}..{})", field,
                                as_message(json_text(value)), least, most));
  return value.get<std::size_t>();
}

Eigen::MatrixXd motion_from_json(const Json& json, std::size_t contacts) {
  const auto& rows = json.get_ref<const Json::array_t&>();
  Eigen::MatrixXd motion(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(contacts));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<double> row = numbers_of_json(rows[i]);
    if (row.size() != contacts)
      throw BadRecord(
          fmt::format("motion = {} numbers (must be {}, one of each contact)", row.size(), contacts));
    motion.row(static_cast<Eigen::Index>(i)) =
        Eigen::Map<const Eigen::RowVectorXd>(row.data(), motion.cols());
  }
  return motion;
}

SolutionPoint point_from_json(const Json& json) {
  SolutionPoint point;
  point.frequency = number_of_json(json.at("omega"));
  point.parameter = json.contains("value") ? number_of_json(json.at("value")) : point.frequency;
  point.order = static_cast<int>(count_of_json(json, "order", 1, 1000));
  point.amplitude = numbers_of_json(json.at("amplitude"));
  point.x_max = numbers_of_json(json.at("x_max"));
  point.impacts = static_cast<int>(count_of_json(json, "impacts", 0, 1'000'000'000));
  point.stability = enum_from_name<OrbitStability>("stability", json.at("stability").get<std::string>());
  point.undefined = json.value("stability_reason", "");
  const auto& multipliers = json.at("multipliers").get_ref<const Json::array_t&>();
  point.multipliers.resize(static_cast<Eigen::Index>(multipliers.size()));
  for (std::size_t i = 0; i < multipliers.size(); ++i)
    point.multipliers[static_cast<Eigen::Index>(i)] = {number_of_json(multipliers[i].at(0)),
                                                       number_of_json(multipliers[i].at(1))};
  if (json.contains("energy")) point.energy = number_of_json(json.at("energy"));
  if (json.contains("damping_ratio")) point.damping_ratio = number_of_json(json.at("damping_ratio"));
  if (json.contains("second")) point.second = number_of_json(json.at("second"));
  if (json.contains("motion")) point.motion = motion_from_json(json.at("motion"), point.amplitude.size());
  return point;
}

SpecialPoint special_from_json(const Json& json, std::size_t points) {
  return {.kind = enum_from_name<SpecialKind>("kind", json.at("kind").get<std::string>()),
          .point = point_from_json(json),
          .text = json.value("text", std::string()),
          .after = count_of_json(json, "after", 0, points)};
}

// What `read` makes of a value whose texts are plain. \throws BadRecord for what is none
template <class Read>
auto read_plain(const char* what, const Json& json, Read&& read) {
  require_plain_texts(json);
  try {
    return read();
  } catch (const Json::exception& error) {
    throw BadRecord(fmt::format("{} = unreadable (must be one as sweep writes it: {})", what, error.what()));
  }
}

}  // namespace

Json to_json(const SolutionPoint& point) {
  Json json = Json::object();
  add_point(json, point);
  return json;
}

Json to_json(const Branch& branch, const std::string& method, const std::string& other_law) {
  Json points = Json::array(), special = Json::array();
  for (const SolutionPoint& point : branch.points) points.push_back(to_json(point));
  for (const SpecialPoint& at : branch.special) special.push_back(special_json(at));
  Json json{{"method", method},   {"sequence", branch.sequence}, {"points", points},
            {"special", special}, {"began", branch.began},       {"ended", branch.ended}};
  if (branch.by_steps) json["by_steps"] = true;
  if (!other_law.empty()) json["other_law"] = other_law;
  return json;
}

Branch branch_from_json(const Json& json) {
  return read_plain("branch", json, [&] {
    Branch branch{.sequence = json.at("sequence").get<std::string>(),
                  .began = json.at("began").get<std::string>(),
                  .ended = json.at("ended").get<std::string>()};
    branch.by_steps = json.value("by_steps", false);
    for (const Json& point : json.at("points").get_ref<const Json::array_t&>())
      branch.points.push_back(point_from_json(point));
    for (const Json& special : json.at("special").get_ref<const Json::array_t&>())
      branch.special.push_back(special_from_json(special, branch.points.size()));
    return branch;
  });
}

Json to_json(const SweepPoint& step, const std::string& method, const std::string& other_law) {
  Json line{{"method", method}};
  line.update(to_json(step));
  if (!other_law.empty()) line["other_law"] = other_law;
  return line;
}

SweepPoint step_from_json(const Json& json) {
  return read_plain("step", json, [&] {
    SweepPoint step{.frequency = number_of_json(json.at("frequency")),
                    .down = json.at("way").get<std::string>() == "down",
                    .status = enum_from_name<Status>("status", json.at("status").get<std::string>()),
                    .message = json.value("message", std::string())};
    if (json.contains("x_max")) step.x_max = numbers_of_json(json.at("x_max"));
    if (json.contains("amplitude")) step.amplitude = numbers_of_json(json.at("amplitude"));
    if (json.contains("contact_ratio")) step.contact_ratio = number_of_json(json.at("contact_ratio"));
    if (json.contains("stable")) step.stable = json.at("stable").get<bool>();
    step.undefined = json.value("stability_reason", std::string());
    return step;
  });
}

}  // namespace signorini
