// Checks of the options of a method: they are declared and echoed, and any bad value is refused, not worse.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <set>

#include "harness/conformance/checked_method.hpp"
#include "harness/failure.hpp"
#include "harness/plan/plan.hpp"
#include "problems/files/kebab_case.hpp"

namespace signorini {

namespace {

constexpr std::array kBadTexts{"0",          "-0",         "-1",       "1",     "nan",
                               "-nan",       "inf",        "-inf",     "1e300", "-1e300",
                               "1e-300",     "1e999",      "0x10",     "1.5",   "99999999999999999999",
                               "2147483648", "4294967301", "10000001", "",      " ",
                               "auto",       "text",       "1e6x",     "nanx",  "-1x",
                               "true",       "1 ",         "1,5",      "infx"};
constexpr std::array<std::string_view, 6> kNotFinite{"nan", "-nan", "inf", "-inf", "infx", "1e999"};

/// What is wrong with one option as it is shown to a user; empty if nothing is.
std::string echo_defect(const OptionEcho& option) {
  if (option.meaning.empty()) return fmt::format("option {} has no meaning", option.name);
  if (!option.unit.starts_with('[') || !option.unit.ends_with(']'))
    return fmt::format("option {} has unit '{}', not one in brackets such as [-] or [m]", option.name,
                       option.unit);
  return {};
}

std::string options_defect(const std::vector<OptionEcho>& options) {
  std::set<std::string> names;
  for (const OptionEcho& option : options) {
    if (option.name == kStartSetting) return fmt::format("option {} is the harness's own", option.name);
    if (!names.insert(option.name).second) return fmt::format("option {} is there twice", option.name);
    if (std::string defect = echo_defect(option); !defect.empty()) return defect;
  }
  for (const char* needed : {"tolerance", "max_iterations"}) {
    if (!names.contains(needed)) return fmt::format("option {}, which all methods have, is missing", needed);
  }
  return {};
}

/// Every setting of the ladder; \throws UsageError if it cannot be read.
std::string ladder_defect(const MethodEntry& entry) {
  std::vector<Settings> ladder;
  try {
    ladder = ladder_of(entry);
  } catch (const UsageError& error) {
    return fmt::format("the ladder {} cannot be read: {}", entry.ladder, error.what());
  }
  if (ladder.empty() || ladder.front().empty())
    return fmt::format("the ladder '{}' names no option (key=value|value)", entry.ladder);
  for (const Settings& settings : ladder) {
    try {
      (void)entry.make(settings);
    } catch (const InvalidOption& error) {
      return fmt::format("the ladder {} is refused: {}", entry.ladder, error.what());
    }
  }
  return {};
}

std::string refusal_defect(const InvalidOption& refusal, const std::string& key) {
  const std::string what = refusal.what();
  if (what.starts_with(key + " = ") && what.ends_with(')') && what.find('\n') == std::string::npos) return {};
  return fmt::format("the refusal of {} reads '{}', not one line '{} = value (what is required)'", key, what,
                     key);
}

/// How a value was taken: what is wrong with its refusal, or with its being accepted.
std::string value_defect(const MethodEntry& entry, std::size_t options, const std::string& key,
                         const std::string& text) {
  try {
    const std::vector<OptionEcho> echo = entry.make(Settings{{key, text}})->options();
    if (echo.size() != options) return fmt::format("{} = {} changes the number of options", key, text);
    const auto is_word = [&](const OptionEcho& option) {
      return option.name == key && std::holds_alternative<std::string>(option.value);
    };
    if (std::ranges::any_of(echo, is_word)) return {};  // any word will do
  } catch (const InvalidOption& refusal) {
    return refusal_defect(refusal, key);
  }
  if (std::ranges::find(kNotFinite, text) != kNotFinite.end())
    return fmt::format("{} = {} is accepted", key, text);
  return {};
}

std::string unknown_defect(const MethodEntry& entry, const std::vector<OptionEcho>& options) {
  const std::string key = "flux_capacitance";
  try {
    (void)entry.make(Settings{{key, "1"}});
  } catch (const InvalidOption& refusal) {
    if (std::string defect = refusal_defect(refusal, key); !defect.empty()) return defect;
    for (const OptionEcho& option : options) {
      if (std::string_view(refusal.what()).find(option.name) == std::string_view::npos)
        return fmt::format("the refusal of an unknown option does not name {}, which is known", option.name);
    }
    return {};
  }
  return fmt::format("the unknown option {} is accepted", key);
}

/// A text split into the number it begins with, if any, and the rest: "1e2x" is 100 and "x".
std::pair<std::optional<double>, std::string> as_number_and_rest(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (end == text.c_str()) return {std::nullopt, text};
  return {number, end};
}

bool echoes(const OptionValue& value, const std::string& text) {
  const auto given = as_number_and_rest(text);
  if (const std::optional<double> number = as_number(value))
    return given.second.empty() && given.first == number;
  if (const auto* word = std::get_if<std::string>(&value)) return as_number_and_rest(*word) == given;
  if (const auto* flag = std::get_if<bool>(&value)) return text == (*flag ? "true" : "false");
  return text == "auto";
}

std::string echo_defect(const MethodEntry& entry, const Settings& settings) {
  const std::vector<OptionEcho> options = entry.make(settings)->options();
  for (const OptionSetting& setting : settings) {
    const OptionValue* value = value_of(options, setting.first);
    if (value == nullptr) return fmt::format("{} is set and not echoed", setting.first);
    if (!echoes(*value, setting.second))
      return fmt::format("{} = {} is echoed as another value", setting.first, setting.second);
  }
  return {};
}

}  // namespace

CheckResult check_declaration(const MethodEntry& entry) {
  if (!is_lower_kebab_case(entry.name))
    return failed(fmt::format("the name '{}' is not in lower-kebab-case", entry.name));
  if (entry.title.empty()) return failed("it has no title");
  if (entry.laws.empty()) return failed("it does not say which laws it represents");
  if (entry.order && !(*entry.order > 0.0 && *entry.order <= 20.0))
    return failed(fmt::format("its order {} is none", *entry.order));
  if (std::string defect = options_defect(entry.make({})->options()); !defect.empty()) return failed(defect);
  return passed_unless(ladder_defect(entry));
}

CheckResult check_echo(const MethodEntry& entry) {
  for (const Settings& settings : usable_ladder(entry)) {
    if (std::string defect = echo_defect(entry, settings); !defect.empty()) return failed(defect);
  }
  for (const OptionEcho& option : entry.make({})->options()) {
    const auto* word = std::get_if<std::string>(&option.value);
    if (word == nullptr) continue;
    if (std::string defect = echo_defect(entry, {{option.name, *word}}); !defect.empty())
      return failed(defect);
  }
  return passed();
}

CheckResult check_refusals(const MethodEntry& entry) {
  const std::vector<OptionEcho> options = entry.make({})->options();
  if (std::string defect = unknown_defect(entry, options); !defect.empty()) return failed(defect);
  for (const OptionEcho& option : options) {
    for (const char* text : kBadTexts) {
      if (std::string defect = value_defect(entry, options.size(), option.name, text); !defect.empty())
        return failed(defect);
    }
  }
  return passed();
}

}  // namespace signorini
