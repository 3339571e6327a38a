#include "methods/options.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace signorini {

namespace {

struct OptionPrinter {
  std::string operator()(std::monostate) const { return "auto"; }
  std::string operator()(const auto& value) const { return fmt::format("{}", value); }
};

}  // namespace

std::string print_option(const OptionValue& value) { return std::visit(OptionPrinter{}, value); }

namespace option_detail {

std::string refuse(std::string_view key, std::string_view text, std::string_view requirement) {
  return fmt::format("{} = {} ({})", key, text, requirement);
}

namespace {

/// A number that the whole text is, and that its type holds.
template <class Number>
Number parsed(std::string_view key, std::string_view text, std::string_view requirement) {
  Number value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    throw InvalidOption(refuse(key, text, requirement));
  return value;
}

}  // namespace

double parse_double(std::string_view key, std::string_view text) {
  return parsed<double>(key, text, "must be a finite number");
}

long parse_integer(std::string_view key, std::string_view text) {
  return parsed<int>(key, text, "must be a whole number");
}

bool parse_bool(std::string_view key, std::string_view text) {
  if (text == "true" || text == "1") return true;
  if (text == "false" || text == "0") return false;
  throw InvalidOption(refuse(key, text, "must be true or false"));
}

Scaled parse_scaled(std::string_view key, std::string_view text) {
  const bool relative = text.ends_with('x');
  try {
    return {parse_double(key, relative ? text.substr(0, text.size() - 1) : text), relative};
  } catch (const InvalidOption&) {
    throw InvalidOption(refuse(key, text, "must be a number in SI units, or a multiple such as 100x"));
  }
}

int parse_name(std::string_view key, std::string_view text, std::span<const std::string_view> names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == text) return static_cast<int>(i);
  }
  throw InvalidOption(refuse(key, text, fmt::format("must be one of {}", fmt::join(names, ", "))));
}

std::string print(const Scaled& value) { return fmt::format("{}{}", value.value, value.relative ? "x" : ""); }

}  // namespace option_detail

}  // namespace signorini
