#include "harness/plan/case_name.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace signorini {

std::string method_label(std::string_view method, const Settings& settings) {
  if (settings.empty()) return std::string(method);
  std::string inside;
  for (const auto& [option, value] : settings)
    inside += fmt::format("{}{}={}", inside.empty() ? "" : ",", option, value);
  return fmt::format("{}[{}]", method, inside);
}

bool is_plain(const Settings& settings) {
  return std::ranges::find(settings, OptionSetting{"plain", "true"}) != settings.end();
}

CaseName parse_method_label(std::string_view label) {
  const std::size_t open = label.find('[');
  CaseName name{.method = std::string(label.substr(0, open))};
  if (open == std::string_view::npos) return name;
  std::string_view rest = label.substr(open + 1, label.rfind(']') - open - 1);
  while (!rest.empty()) {
    const std::string_view item = rest.substr(0, rest.find(','));
    const std::size_t equals = std::min(item.find('='), item.size());
    name.settings.emplace_back(item.substr(0, equals), item.substr(std::min(equals + 1, item.size())));
    rest.remove_prefix(std::min(item.size() + 1, rest.size()));
  }
  return name;
}

CaseName parse_case_name(std::string_view name) {
  const std::size_t slash = name.find('/');
  if (slash == std::string_view::npos) return parse_method_label(name);
  CaseName parts = parse_method_label(name.substr(slash + 1));
  parts.scene = name.substr(0, slash);
  return parts;
}

}  // namespace signorini
