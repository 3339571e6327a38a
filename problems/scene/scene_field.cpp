#include "problems/scene/scene_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace signorini {

SceneField::SceneField(const TomlNode& document, const std::string& file)
    : SceneField(&document, "", document.line, &file) {}

SceneField::SceneField(const TomlNode* node, std::string path, int line, const std::string* file)
    : node_(node), path_(std::move(path)), line_(line), file_(file) {}

SceneField SceneField::operator[](std::string_view key) const {
  const TomlNode* entry = given() ? node_->find(key) : nullptr;
  std::string path = path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
  return {entry, std::move(path), entry != nullptr ? entry->line : line_, file_};
}

SceneField SceneField::item(std::size_t index) const {
  const auto* array = as<TomlArray>();
  const TomlNode* entry = array != nullptr && index < array->size() ? &(*array)[index] : nullptr;
  return {entry, fmt::format("{}[{}]", path_, index), entry != nullptr ? entry->line : line_, file_};
}

SceneField SceneField::at(std::string_view path) const {
  SceneField field = *this;
  while (!path.empty()) {
    const std::optional<PathStep> step = take_step(path);
    if (!step) return field[path];
    field = step->index ? field.item(*step->index) : field[step->key];
  }
  return field;
}

std::vector<std::string> SceneField::keys() const {
  std::vector<std::string> names;
  if (!is_table()) return names;
  for (const TomlEntry& entry : *as<TomlTable>()) names.push_back(entry.key);
  return names;
}

void SceneField::allow_only(std::initializer_list<std::string_view> keys,
                            std::string_view requirement) const {
  const auto* table = as<TomlTable>();
  if (table == nullptr) refuse(requirement);
  for (const TomlEntry& entry : *table) {
    if (std::find(keys.begin(), keys.end(), entry.key) != keys.end()) continue;
    (*this)[entry.key].refuse(fmt::format("unknown key; known: {}", fmt::join(keys, ", ")));
  }
}

bool SceneField::has_any(std::initializer_list<std::string_view> keys) const {
  return std::ranges::any_of(keys, [&](std::string_view key) { return (*this)[key].given(); });
}

void SceneField::forbid(std::initializer_list<std::string_view> keys, std::string_view why) const {
  for (const std::string_view key : keys)
    if ((*this)[key].given()) (*this)[key].refuse(fmt::format("must be absent: {}", why));
}

std::vector<SceneField> SceneField::items(std::string_view requirement, std::size_t count) const {
  const auto* array = as<TomlArray>();
  if (array == nullptr || array->empty() || (count != 0 && array->size() != count)) refuse(requirement);
  std::vector<SceneField> fields;
  for (std::size_t i = 0; i < array->size(); ++i) fields.push_back(item(i));
  return fields;
}

std::vector<SceneField> SceneField::items_or_none(std::string_view requirement) const {
  return given() ? items(requirement) : std::vector<SceneField>();
}

double SceneField::number(std::string_view requirement, double least) const {
  double value = std::numeric_limits<double>::quiet_NaN();
  if (const auto* whole = as<std::int64_t>()) value = static_cast<double>(*whole);
  if (const auto* real = as<double>()) value = *real;
  if (!std::isfinite(value) || value < least) refuse(requirement);
  return value;
}

double SceneField::number_or(double otherwise, std::string_view requirement, double least) const {
  return given() ? number(requirement, least) : otherwise;
}

int SceneField::whole(std::string_view requirement, int least, int most) const {
  const auto* value = as<std::int64_t>();
  const auto* real = as<double>();
  if (real != nullptr && *real >= least && *real <= most && *real == std::floor(*real))
    refuse(fmt::format("{:.1f}", *real),
           fmt::format("{}: {:.0f}, without a decimal point", requirement, *real));
  if (value == nullptr || *value < least || *value > most) refuse(requirement);
  return static_cast<int>(*value);
}

int SceneField::in_range(std::string_view what, int least, int most) const {
  return whole(fmt::format("must be {}, {}..{}", what, least, most), least, most);
}

int SceneField::whole_or(int otherwise, std::string_view requirement, int least, int most) const {
  return given() ? whole(requirement, least, most) : otherwise;
}

bool SceneField::truth(std::string_view requirement) const {
  const auto* value = as<bool>();
  if (value == nullptr) refuse(requirement);
  return *value;
}

std::string SceneField::text(std::string_view requirement) const {
  const auto* value = as<std::string>();
  if (value == nullptr || has_control_characters(*value)) refuse(requirement);
  return *value;
}

std::string SceneField::one_of(const std::vector<std::string_view>& words, std::string_view remark) const {
  const std::string requirement = fmt::format("must be {}{}", alternatives(words), remark);
  const std::string word = text(requirement);
  if (std::ranges::find(words, word) == words.end()) refuse(requirement);
  return word;
}

void SceneField::refuse(std::string_view requirement) const {
  refuse(given() ? print(*node_) : "missing", requirement);
}

void SceneField::refuse(std::string_view found, std::string_view requirement) const {
  constexpr std::size_t kLongestPath = 200;  // bytes: keys are a stranger's text
  throw SceneError(
      fmt::format("{}:{}: {} = {} ({})", *file_, line_, one_line(path_, kLongestPath), found, requirement));
}

std::string alternatives(const std::vector<std::string_view>& words) {
  return fmt::format("\"{}\" or \"{}\"", fmt::join(words.begin(), words.end() - 1, "\", \""), words.back());
}

}  // namespace signorini
