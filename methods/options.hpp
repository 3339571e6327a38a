#pragma once
// Options of a method: one `visit` per option struct drives parsing, validation, help and echo.

#include <array>
#include <concepts>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace signorini {

/// A bad option: what() reads "key = value (what is required)".
class InvalidOption : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// A physical constant given in SI units ("1e6") or relative to a stated scale ("100x").
struct Scaled {
  double value = 1.0;    ///< [SI unit] or multiple of the scale [-]
  bool relative = true;  ///< a multiple

  /// The value in SI units, `scale` being the unit of a relative one.
  [[nodiscard]] double in_units_of(double scale) const { return relative ? value * scale : value; }
  /// Member by member.
  friend bool operator==(const Scaled&, const Scaled&) = default;
};

/// Enumerations offered as options specialise this with the names of their values, in order:
/// `template <> struct EnumNames<Scheme> { static constexpr std::array values{"galerkin", ...}; };`
template <class Enum>
struct EnumNames;

/// One `key=value` as given by a user.
using OptionSetting = std::pair<std::string, std::string>;

/// The value of an option in a form that records keep; monostate: "auto", chosen by the method.
using OptionValue = std::variant<std::monostate, bool, long, double, std::string>;

/// An option that a method no longer has.
struct FormerOption {
  std::string_view name;  ///< as --set took it
  std::string_view said;  ///< to who sets it
};

/// One option as shown to a user and echoed into records.
struct OptionEcho {
  std::string name;     ///< as --set takes it
  OptionValue value;    ///< present or default
  std::string unit;     ///< "[-]", "[N/m]", ...
  std::string meaning;  ///< one line, with the range allowed
};

/// As --set takes it; "auto" where the method chooses.
std::string print_option(const OptionValue& value);

namespace option_detail {

std::string refuse(std::string_view key, std::string_view text, std::string_view requirement);
double parse_double(std::string_view key, std::string_view text);
long parse_integer(std::string_view key, std::string_view text);
bool parse_bool(std::string_view key, std::string_view text);
Scaled parse_scaled(std::string_view key, std::string_view text);
int parse_name(std::string_view key, std::string_view text, std::span<const std::string_view> names);
std::string print(const Scaled& value);

template <class T>
constexpr bool kIsOptional = false;
template <class T>
constexpr bool kIsOptional<std::optional<T>> = true;

template <class T>
void parse_into(T& field, std::string_view key, std::string_view text) {
  if constexpr (kIsOptional<T>) {
    field.reset();
    if (text != "auto") parse_into(field.emplace(), key, text);
  } else if constexpr (std::is_same_v<T, bool>) {
    field = parse_bool(key, text);
  } else if constexpr (std::is_enum_v<T>) {
    field = static_cast<T>(parse_name(key, text, EnumNames<T>::values));
  } else if constexpr (std::is_same_v<T, Scaled>) {
    field = parse_scaled(key, text);
  } else if constexpr (std::is_integral_v<T>) {
    field = static_cast<T>(parse_integer(key, text));
  } else {
    static_assert(std::is_same_v<T, double>, "option fields: bool, int, double, Scaled, enum, optional");
    field = parse_double(key, text);
  }
}

template <class T>
OptionValue echo_of(const T& field) {
  if constexpr (kIsOptional<T>) {
    return field ? echo_of(*field) : OptionValue{};
  } else if constexpr (std::is_same_v<T, bool>) {
    return field;
  } else if constexpr (std::is_enum_v<T>) {
    return std::string(EnumNames<T>::values[static_cast<std::size_t>(field)]);
  } else if constexpr (std::is_same_v<T, Scaled>) {
    return print(field);
  } else if constexpr (std::is_integral_v<T>) {
    return static_cast<long>(field);
  } else {
    return field;
  }
}

}  // namespace option_detail

/// Applies settings to an option struct, in order.
/// \param former  options of which more is said than that they are unknown
/// \throws InvalidOption on an unknown key (listing the known ones, or saying what became of it) or an
/// unreadable value.
/// Ranges are checked by the method's constructor, which sees all options together.
template <class Options>
void apply_settings(Options& options, std::span<const OptionSetting> settings,
                    std::span<const FormerOption> former = {}) {
  for (const OptionSetting& setting : settings) {
    const std::string& key = setting.first;
    const std::string& text = setting.second;
    bool known = false;
    std::string names;
    options.visit([&](std::string_view name, auto& field, auto&&...) {
      if (!names.empty()) names += ", ";
      names += name;
      if (name == key) {
        known = true;
        option_detail::parse_into(field, key, text);
      }
    });
    if (known) continue;
    for (const FormerOption& option : former)
      if (option.name == key) throw InvalidOption(option_detail::refuse(key, text, option.said));
    throw InvalidOption(option_detail::refuse(key, text, "unknown option; known: " + names));
  }
}

/// Every option with its present value, in declaration order.
template <class Options>
std::vector<OptionEcho> echo_options(Options options) {
  std::vector<OptionEcho> echo;
  options.visit([&](std::string_view name, auto& field, std::string_view unit, std::string_view meaning) {
    echo.push_back(
        {std::string(name), option_detail::echo_of(field), std::string(unit), std::string(meaning)});
  });
  return echo;
}

/// Refuses an option value out of range: throws InvalidOption unless `ok`.
template <class T>
void require_option(bool ok, std::string_view name, const T& value, std::string_view requirement) {
  if (ok) return;
  throw InvalidOption(option_detail::refuse(name, print_option(option_detail::echo_of(value)), requirement));
}

}  // namespace signorini
