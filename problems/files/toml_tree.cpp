#include "problems/files/toml_tree.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <sstream>

namespace signorini {

namespace {

constexpr std::size_t kLongestPrint = 60;    // of a value
constexpr std::size_t kLongestReason = 200;  // of the parser
// Keys "a.b.c": each part is a table in a table, which the library and `convert` visit by recursion. The
// library bounds the nesting of values, not that of keys.
constexpr int kMostParts = 100;

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

/// Where a quoted text that begins at `at` ends, past its last quote; the end where it does not.
std::size_t end_of_quoted(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string three(3, quote);
  const bool multiline = text.substr(at, 3) == three;
  const std::string_view closing = multiline ? std::string_view(three) : text.substr(at, 1);
  for (std::size_t i = at + closing.size(); i < text.size(); ++i) {
    if (text.substr(i).starts_with(closing)) return i + closing.size();
    if (!multiline && text[i] == '\n') return i;  // no TOML; the parser says so
    if (quote == '"' && text[i] == '\\') ++i;     // whatever is escaped, if anything is left
  }
  return text.size();
}

[[noreturn]] void refuse(const std::string& file, int line, std::string_view reason) {
  throw SceneError(fmt::format("{}:{}: file = not TOML (must be valid TOML 1.0; {})", file, line,
                               one_line(reason, kLongestReason)));
}

/// toml_number_mistake of a line of a text.
std::string mistake_in_line(std::string_view text, int number) {
  for (int i = 1; i < number; ++i) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  return toml_number_mistake(text.substr(0, text.find('\n')));
}

/// Refuses keys of more than kMostParts parts before the library sees them. \throws SceneError
void require_short_keys(std::string_view text, const std::string& file) {
  constexpr std::string_view kBare = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_- \t";
  int dots = 0;  // since the last character that can be no part of a key
  int line = 1;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    const std::size_t begin = i;
    if (c == '"' || c == '\'') {
      i = end_of_quoted(text, i);
    } else if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
    } else {
      if (c == '.') ++dots;
      if (c != '.' && kBare.find(c) == std::string_view::npos) dots = 0;
      ++i;
    }
    if (dots >= kMostParts) refuse(file, line, fmt::format("a key has more than {} parts", kMostParts));
    line += static_cast<int>(std::ranges::count(text.substr(begin, i - begin), '\n'));
  }
}

bool is_control_character(char c) { return static_cast<unsigned char>(c) < 0x20U || c == 0x7F; }

/// Bytes of the UTF-8 character at the front of the text; 0 where none begins there.
std::size_t length_of_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  const std::size_t length = first < 0x80U                     ? 1
                             : first >= 0xC2U && first < 0xE0U ? 2
                             : (first & 0xF0U) == 0xE0U        ? 3
                             : first >= 0xF0U && first < 0xF5U ? 4
                                                               : 0;
  if (length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
  }
  return length;
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
  const auto entry = std::ranges::find(*table, key, &TomlEntry::key);
  return entry == table->end() ? nullptr : &entry->value;
}

TomlNode parse_toml(std::string_view text, const std::string& file) {
  require_short_keys(text, file);
  try {
    return convert(toml::parse(text));
  } catch (const toml::parse_error& error) {
    const int line = line_of(error.source());
    refuse(file, line, std::string(error.description()) + mistake_in_line(text, line));
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

bool has_control_characters(std::string_view text) { return std::ranges::any_of(text, is_control_character); }

std::string one_line(std::string_view text, std::size_t length) {
  std::string line;
  while (!text.empty()) {
    if (line.size() >= length) return line + "...";
    const auto byte = static_cast<unsigned char>(text.front());
    std::size_t size = length_of_character(text);
    // C1 control characters, U+0080 to U+009F, mean as much to a terminal as ESC does.
    const bool second_control = size == 2 && byte == 0xC2U && static_cast<unsigned char>(text[1]) < 0xA0U;
    if (byte == '\n') {
      line += "\\n";
    } else if (size == 0 || is_control_character(text.front()) || second_control) {
      size = second_control ? 2 : 1;
      for (const char c : text.substr(0, size))
        line += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    } else {
      line += text.substr(0, size);
    }
    text.remove_prefix(size);
  }
  return line;
}

std::string number_mistake(std::string_view text) {
  const auto digit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view here = text.substr(i, 3);
    const bool minus = here == "\xE2\x88\x92" || here == "\xE2\x80\x93" || here == "\xE2\x80\x94";
    if (minus && (digit(i + 3) || text.substr(i + 3).starts_with('.')))
      return "; the minus sign is one of a text processor: write -";
    if (text[i] == ',' && i > 0 && digit(i - 1) && digit(i + 1))
      return "; a decimal comma: write a point, as in 1.5";
  }
  return "";
}

std::string toml_number_mistake(std::string_view line) {
  line = line.substr(0, line.find('#'));
  for (std::size_t at = line.find('='); at != std::string_view::npos; at = line.find('=', at + 1)) {
    std::string_view value = line.substr(at + 1);
    value.remove_prefix(std::min(value.find_first_not_of(" \t"), value.size()));
    value = value.substr(0, value.find_first_not_of("+-.,0123456789"));
    if (std::string mistake = number_mistake(value); !mistake.empty()) return mistake;
  }
  std::string without_commas(line);
  std::ranges::replace(without_commas, ',', ' ');
  return number_mistake(without_commas);
}

}  // namespace signorini
