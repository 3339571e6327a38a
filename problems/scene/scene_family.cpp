#include "problems/scene/scene_family.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <random>
#include <set>

#include "problems/files/text_lines.hpp"
#include "problems/scene/scene_field.hpp"

namespace signorini {

namespace {

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
  if (!values.is_table() || values.keys().empty())
    values.refuse("must be a table of places in this file, each with a list of values");
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

TomlNode take_out(TomlNode& document, std::string_view key) {
  auto& entries = std::get<TomlTable>(document.value);
  const auto entry = std::ranges::find(entries, key, &TomlEntry::key);
  TomlNode value = std::move(entry->value);
  entries.erase(entry);
  return value;
}

// A number in [0, 1) that depends on these alone, the same with every compiler.
double share_of(std::uint64_t seed, int number, std::string_view name) {
  std::uint64_t hash = 14695981039346656037ULL;  // FNV-1a
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  const auto low = [](std::uint64_t value) { return static_cast<std::uint32_t>(value); };
  const auto high = [](std::uint64_t value) { return static_cast<std::uint32_t>(value >> 32U); };
  std::seed_seq words{low(seed), high(seed), static_cast<std::uint32_t>(number), low(hash), high(hash)};
  return static_cast<double>(std::mt19937_64(words)() >> 11U) * 0x1p-53;
}

// A number of six digits, as a person would write it into the file.
double six_digits(double value) { return number_of<double>(fmt::format("{:.6g}", value)).value_or(value); }

double drawn_from(const SceneField& range, double share) {
  constexpr std::string_view kEnds = "must be a number, above 0 for a logarithmic range";
  if (range["one_of"].given()) {
    for (const char* key : {"from", "to", "log"})
      if (range[key].given()) range[key].refuse("must not be there beside one_of");
    std::vector<double> values;
    for (const SceneField& item : range["one_of"].items("must be a list of numbers"))
      values.push_back(item.number("must be a number"));
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size()))];
  }
  const bool logarithmic = range["log"].given() && range["log"].truth("must be true or false");
  const double least = logarithmic ? kLeastPositive : std::numeric_limits<double>::lowest();
  const double from = range["from"].number(kEnds, least), to = range["to"].number(kEnds, least);
  if (!(from < to)) range["to"].refuse("must be more than from");
  return six_digits(logarithmic ? from * std::pow(to / from, share) : from + share * (to - from));
}

// Writes what is drawn for one range to its places.
void write_drawn(TomlNode& document, const SceneField& range, const SceneInstance& instance,
                 DrawnValues& drawn) {
  range.allow_only({"places", "from", "to", "log", "one_of"},
                   "must be a table with places, and from, to and log, or one_of");
  constexpr std::string_view kPlaces =
      "must be a list of places of numbers in this file, such as contact[0].gap";
  std::vector<std::string> places;
  for (const SceneField& item : range["places"].items(kPlaces)) places.push_back(item.text(kPlaces));
  const double value =
      drawn_from(range, share_of(instance.seed, instance.number, instance.scene + " " + places.front()));
  for (const std::string& place : places) {
    const SceneField field = SceneField(document, range.file()).at(place);
    if (!field.given()) range["places"].refuse(kPlaces);
    static_cast<void>(field.number(kPlaces));
    // The field is a reader's; it leads into the document, which is ours to write.
    const_cast<TomlNode&>(field.node()).value = value;
    drawn.emplace_back(place, value);
  }
}

// Seed and number of a label "7-3".
std::optional<SceneInstance> instance_of_label(std::string_view label) {
  const std::size_t dash = std::min(label.find('-'), label.size());
  const auto seed = number_of<std::uint64_t>(label.substr(0, dash));
  const auto number = number_of<int>(label.substr(std::min(dash + 1, label.size())));
  if (!seed || !number || *number < 1 || instance_label(*seed, *number) != label)  // "07-3"
    return std::nullopt;
  return SceneInstance{.seed = *seed, .number = *number};
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

std::optional<SceneInstance> draw_instance(TomlNode& document, const std::string& file,
                                           std::string_view label) {
  const SceneField root(document, file);
  if (root["family"].given()) root["range"].refuse("must not be there beside family");
  std::optional<SceneInstance> asked = instance_of_label(label);
  if (!asked && !label.empty())
    root["range"].refuse(
        fmt::format("is drawn from by SEED-NUMBER, as in NAME@7-3, not by {}", one_line(label)));
  // Ranges are checked where nothing is drawn, too.
  SceneInstance instance = asked.value_or(SceneInstance{});
  instance.scene = root["name"].text("must be a name in lower-kebab-case");
  TomlNode scene = document;
  const TomlNode ranges = take_out(scene, "range");
  TomlNode drawn = scene;
  for (const SceneField& range : SceneField(ranges, file).named("range").items("must be tables with places"))
    write_drawn(drawn, range, instance, instance.values);
  document = asked ? std::move(drawn) : std::move(scene);
  if (!asked) return std::nullopt;
  return instance;
}

std::optional<FamilyLevel> choose_level(TomlNode& document, const std::string& file, std::string_view label) {
  const SceneField asked = SceneField(document, file)["family"];
  if (!asked.given()) {
    if (label.empty()) return std::nullopt;
    asked.refuse(fmt::format("must be there for the scene to have a level {}", label));
  }
  asked.allow_only({"parameter", "levels", "values"}, "must be a table with parameter, levels and values");
  const std::vector<double> levels = read_levels(asked);
  const auto chosen = std::ranges::find_if(levels, [&](double level) { return means(label, level); });
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
  const TomlNode family = take_out(document, "family");
  write_values(document, SceneField(family, file).named("family")["values"], index, levels.size());
  return result;
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

std::string instance_label(std::uint64_t seed, int number) { return fmt::format("{}-{}", seed, number); }

bool has_ranges(const TomlNode& document) { return document.find("range") != nullptr; }

SceneVariant choose_variant(TomlNode& document, const std::string& file, std::string_view label) {
  if (has_ranges(document)) return {.instance = draw_instance(document, file, label)};
  return {.family = choose_level(document, file, label)};
}

}  // namespace signorini
