#include "problems/scene/scene_family.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <set>

#include "problems/scene/scene_field.hpp"

namespace signorini {

namespace {

constexpr std::string_view kValues = "must be a table of places in this file, each with a list of values";

std::vector<double> read_levels(const SceneField& family) {
  constexpr std::string_view kRequirement = "must be a list of different numbers, easiest first";
  constexpr std::size_t kMostLevels = 1000;  // each is a scene, read from the whole file
  std::vector<double> levels;
  const std::vector<SceneField> items = family["levels"].items(kRequirement);
  if (items.size() > kMostLevels) {
    family["levels"].refuse(fmt::format("{} levels", items.size()),
                            fmt::format("must be at most {}", kMostLevels));
  }
  std::set<double> known;
  for (const SceneField& item : items) {
    levels.push_back(item.number("must be a number"));
    if (!known.insert(levels.back()).second) item.refuse(kRequirement);
  }
  return levels;
}

// Writes the value of this level to every place that the family names.
void write_values(TomlNode& document, const SceneField& values, std::size_t level, std::size_t levels) {
  if (!values.is_table() || values.keys().empty()) values.refuse(kValues);
  for (const std::string& path : values.keys()) {
    const SceneField given = values[path];
    const std::string requirement = fmt::format(
        "must be a list of {} values, one per level, for something that stands in this file", levels);
    const SceneField place = SceneField(document, values.file()).at(path);
    if (!place.given() || given.items(requirement).size() != levels) given.refuse(requirement);
    // The field is a reader's; it leads into the document, which is ours to write.
    const_cast<TomlNode&>(place.node()) = given.items(requirement)[level].node();
  }
}

TomlNode take_family(TomlNode& document) {
  auto& entries = std::get<TomlTable>(document.value);
  const auto entry = std::find_if(entries.begin(), entries.end(),
                                  [](const TomlEntry& candidate) { return candidate.key == "family"; });
  TomlNode family = std::move(entry->value);
  entries.erase(entry);
  return family;
}

std::string shortest(double value, std::chars_format format) {
  std::array<char, 512> text{};  // of the largest number 309 digits
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, format);
  return {text.data(), end.ptr};
}

// The level that a label asks for, however it is written.
bool means(std::string_view label, double level) {
  double asked = 0.0;
  const auto end = std::from_chars(label.data(), label.data() + label.size(), asked);
  return end.ec == std::errc() && end.ptr == label.data() + label.size() && asked == level;
}

}  // namespace

std::string level_label(double level) {
  const std::string fixed = shortest(level, std::chars_format::fixed);
  std::string scientific = shortest(level, std::chars_format::scientific);  // "1e-08", "1e+06"
  const std::size_t digits = scientific.find('e') + 2;
  scientific.erase(digits, scientific.find_first_not_of('0', digits) - digits);
  std::erase(scientific, '+');
  return scientific.size() < fixed.size() ? scientific : fixed;
}

std::vector<std::string> family_labels(const TomlNode& document, const std::string& file) {
  const SceneField family = SceneField(document, file)["family"];
  std::vector<std::string> labels;
  if (!family.given()) return labels;
  for (const double level : read_levels(family)) labels.push_back(level_label(level));
  return labels;
}

std::optional<FamilyLevel> choose_level(TomlNode& document, const std::string& file, std::string_view label) {
  const SceneField asked = SceneField(document, file)["family"];
  if (!asked.given()) {
    if (label.empty()) return std::nullopt;
    asked.refuse(fmt::format("must be there for the scene to have a level {}", label));
  }
  asked.allow_only({"parameter", "levels", "values"}, "must be a table with parameter, levels and values");
  const std::vector<double> levels = read_levels(asked);
  const auto chosen =
      std::find_if(levels.begin(), levels.end(), [&](double level) { return means(label, level); });
  if (chosen == levels.end()) {
    asked["levels"].refuse(fmt::format("must hold the level asked for, {}, as in NAME@{}",
                                       label.empty() ? "none" : label, level_label(levels.front())));
  }
  FamilyLevel result{.parameter = asked["parameter"].text("must say what the levels are"),
                     .severity = static_cast<int>(chosen - levels.begin()) + 1,
                     .levels = static_cast<int>(levels.size())};
  const auto index = static_cast<std::size_t>(result.severity - 1);
  result.level = levels[index];
  // Fields point into the document: from here on those of the table that has left it.
  const TomlNode family = take_family(document);
  write_values(document, SceneField(family, file).named("family")["values"], index, levels.size());
  return result;
}

}  // namespace signorini
