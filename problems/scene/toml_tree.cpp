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

TomlTable convert_table(const toml::table& table) {
  TomlTable entries;
  for (const auto& [key, value] : table) {
    entries.push_back({std::string(key.str()), line_of(key.source()), convert(value)});
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const TomlEntry& a, const TomlEntry& b) { return a.line < b.line; });
  return entries;
}

TomlArray convert_array(const toml::array& array) {
  TomlArray items;
  items.reserve(array.size());
  for (const toml::node& item : array) items.push_back(convert(item));
  return items;
}

template <class T>
std::string printed(const T& value) {
  std::ostringstream stream;
  stream << value;
  return stream.str();
}

TomlNode convert(const toml::node& node) {
  TomlNode result{.line = line_of(node.source()), .value = {}};
  switch (node.type()) {
    case toml::node_type::table:
      result.value = convert_table(*node.as_table());
      break;
    case toml::node_type::array:
      result.value = convert_array(*node.as_array());
      break;
    case toml::node_type::string:
      result.value = node.as_string()->get();
      break;
    case toml::node_type::integer:
      result.value = node.as_integer()->get();
      break;
    case toml::node_type::floating_point:
      result.value = node.as_floating_point()->get();
      break;
    case toml::node_type::boolean:
      result.value = node.as_boolean()->get();
      break;
    case toml::node_type::date:
      result.value = TomlMoment{printed(node.as_date()->get())};
      break;
    case toml::node_type::time:
      result.value = TomlMoment{printed(node.as_time()->get())};
      break;
    case toml::node_type::date_time:
      result.value = TomlMoment{printed(node.as_date_time()->get())};
      break;
    case toml::node_type::none:
      break;
  }
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

TomlNode parse_toml(std::string_view text) {
  try {
    return convert(toml::parse(text));
  } catch (const toml::parse_error& error) {
    throw TomlSyntaxError(one_line(error.description(), kLongestReason), line_of(error.source()));
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
