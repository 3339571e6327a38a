#include "problems/scene/toml_tree.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <sstream>

namespace signorini {

namespace {

constexpr std::size_t kLongestPrint = 60;    // of a value
constexpr std::size_t kLongestReason = 200;  // of the parser

int line_of(const toml::source_region& region) { return std::max(1, static_cast<int>(region.begin.line)); }

TomlNode convert(const toml::node& node);

TomlTable converted(const toml::table& table) {
  TomlTable entries;
  for (const auto& [key, value] : table)
    entries.push_back({std::string(key.str()), line_of(key.source()), convert(value)});
  std::ranges::stable_sort(entries, {}, &TomlEntry::line);
  return entries;
}

TomlArray converted(const toml::array& array) {
  TomlArray items;
  for (const toml::node& item : array) items.push_back(convert(item));
  return items;
}

/// Strings, numbers and booleans as they are, dates and times by their text.
template <class Value>
auto converted(const toml::value<Value>& value) {
  if constexpr (toml::is_chronological<Value>) {
    std::ostringstream stream;
    stream << value.get();
    return TomlMoment{stream.str()};
  } else {
    return value.get();
  }
}

TomlNode convert(const toml::node& node) {
  TomlNode result{.line = line_of(node.source()), .value = {}};
  node.visit([&](const auto& value) { result.value = converted(value); });
  return result;
}

struct Printer {
  std::string text;

  void operator()(const TomlTable& table) {
    text += '{';
    for (const TomlEntry& entry : table) {
      if (&entry != &table.front()) text += ", ";
      text += entry.key + " = ";
      if (!long_enough()) std::visit(*this, entry.value.value);
    }
    text += '}';
  }
  void operator()(const TomlArray& array) {
    text += '[';
    for (const TomlNode& item : array) {
      if (long_enough()) break;
      if (&item != &array.front()) text += ", ";
      std::visit(*this, item.value);
    }
    text += ']';
  }
  void operator()(const std::string& value) { text += '"' + value + '"'; }
  void operator()(const TomlMoment& value) { text += value.text; }
  void operator()(const auto& value) { text += fmt::format("{}", value); }

  [[nodiscard]] bool long_enough() const { return text.size() > kLongestPrint; }
};

}  // namespace

const TomlNode* TomlNode::find(std::string_view key) const {
  const auto* table = std::get_if<TomlTable>(&value);
  if (table == nullptr) return nullptr;
  const auto entry = std::find_if(table->begin(), table->end(),
                                  [&](const TomlEntry& candidate) { return candidate.key == key; });
  return entry == table->end() ? nullptr : &entry->value;
}

TomlNode parse_toml(std::string_view text, const std::string& file) {
  try {
    return convert(toml::parse(text));
  } catch (const toml::parse_error& error) {
    throw SceneError(fmt::format("{}:{}: file = not TOML (must be valid TOML 1.0; {})", file,
                                 line_of(error.source()), one_line(error.description(), kLongestReason)));
  }
}

std::optional<PathStep> take_step(std::string_view& path) {
  if (path.front() != '[') {
    if (path.front() == '.') path.remove_prefix(1);
    const std::string_view key = path.substr(0, path.find_first_of(".["));
    path.remove_prefix(key.size());
    return PathStep{.key = key};
  }
  std::size_t index = 0;
  const char* end = path.data() + path.size();
  const auto [rest, failure] = std::from_chars(path.data() + 1, end, index);
  if (failure != std::errc{} || rest == end || *rest != ']') return std::nullopt;
  const std::string_view after(rest + 1, end);
  if (!after.empty() && after.front() != '.' && after.front() != '[') return std::nullopt;
  path = after;
  return PathStep{.index = index};
}

std::string print(const TomlNode& node) {
  Printer printer;
  std::visit(printer, node.value);
  return one_line(printer.text, kLongestPrint);
}

std::string one_line(std::string_view text, std::size_t length) {
  std::string line;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool begins_character = (byte & 0xC0U) != 0x80U;
    if (line.size() >= length && begins_character) return line + "...";
    if (c == '\n') {
      line += "\\n";
    } else if (byte < 0x20U || byte == 0x7FU) {
      line += fmt::format("\\x{:02x}", byte);
    } else {
      line += c;
    }
  }
  return line;
}

}  // namespace signorini
