#pragma once
// How the fields of a struct are listed, and their JSON: one `visit_fields` per struct serves writers,
// readers, tables and tests, as `visit` does for the options of a method. JSON objects and the structs that
// they hold: every visited struct is written and read by the functions here.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "harness/failure.hpp"
#include "harness/text/json.hpp"
#include "harness/text/words.hpp"
#include "methods/options.hpp"
#include "problems/files/toml_tree.hpp"

namespace signorini {

/// Whether a file holds a field that is empty: no value, no text, no entry, or no finite number.
enum class Presence {
  required,     ///< always written; a file without it is refused
  always,       ///< always written; a file without it is read
  unless_empty  ///< left out where it is empty
};

/// What a field is called in files, and what it is measured in.
struct Field {
  const char* name = "";
  std::string_view unit = "";  ///< SI; empty for what is dimensionless or no number
  Presence presence = Presence::unless_empty;
};

/// A field without which there is no such object.
constexpr Field required(const char* name, std::string_view unit = "") {
  return {name, unit, Presence::required};
}

/// `Struct`, constant or not: `visit_fields` serves writers and readers alike.
template <class T, class Struct>
concept Either = std::same_as<std::remove_const_t<T>, Struct>;

/// Takes any field; only there to ask whether a struct is visited.
struct AnyField {
  void operator()(const Field& /*field*/, const auto& /*value*/) const {}
};

/// A struct with a `visit_fields(Either<Struct> auto& object, auto&& field)` that calls
/// `field(Field, member)` for each of its members, in the order of the file.
template <class T>
concept Visited = requires(T& object) {
  visit_fields(object, AnyField{});
};

/// A file or a line that does not hold what it should; what() is one line for the user.
class BadRecord : public OneLineError {
 public:
  using OneLineError::OneLineError;
};

/// The JSON of a type that is neither number nor text, list of these, enumeration nor visited struct:
/// specialised with `static nlohmann::ordered_json write(const T&)` and
/// `static T read(const nlohmann::ordered_json&)`.
template <class T>
struct JsonForm;

/// The name of an enumerator, by EnumNames.
template <class Enum>
std::string_view enum_name(Enum value) {
  return EnumNames<Enum>::values[static_cast<std::size_t>(value)];
}

/// The enumerator of a name, by EnumNames. \throws BadRecord that names the field
template <class Enum>
Enum enum_from_name(std::string_view field, std::string_view name) {
  try {
    return static_cast<Enum>(option_detail::parse_name(field, name, EnumNames<Enum>::values));
  } catch (const InvalidOption& error) {
    throw BadRecord(error.what());
  }
}

/// Pairs of a name and a value, such as options: an object, in their order.
template <class Value>
struct JsonForm<std::vector<std::pair<std::string, Value>>> {
  using Pairs = std::vector<std::pair<std::string, Value>>;
  static nlohmann::ordered_json write(const Pairs& pairs);  ///< {"contact[0].gap": 0.2}
  static Pairs read(const nlohmann::ordered_json& json);    ///< in the order of the file
};

/// A number that counts, signed or not.
template <class T>
concept Whole = std::integral<T> && !std::same_as<T, bool>;

/// A whole number that T holds; 3.0 is one. A conversion by the JSON library would be undefined for 1e49.
/// \throws BadRecord that names the field
template <Whole T>
T whole_number(std::string_view field, const nlohmann::ordered_json& json) {
  if (json.is_number_unsigned()) {
    const auto value = json.get<std::uint64_t>();
    if (std::in_range<T>(value)) return static_cast<T>(value);
  } else if (json.is_number_integer()) {
    const auto value = json.get<std::int64_t>();
    if (std::in_range<T>(value)) return static_cast<T>(value);
  } else if (json.is_number_float()) {
    // Up to 2^53 every whole number is a double.
    const double exact = std::ldexp(1.0, std::numeric_limits<double>::digits);
    const auto value = json.get<double>();
    if (std::abs(value) <= exact && std::trunc(value) == value &&
        std::in_range<T>(static_cast<std::int64_t>(value)))
      return static_cast<T>(value);
  }
  throw BadRecord(std::string(field) + " = " + (json.is_number() ? json_text(json) : json.type_name()) +
                  " (must be a whole number from " + std::to_string(std::numeric_limits<T>::min()) + " to " +
                  std::to_string(std::numeric_limits<T>::max()) + ")");
}

/// A visited struct as a JSON object, its fields in the order of the visit.
template <class T>
nlohmann::ordered_json write_fields(const T& object);

/// Reads the fields of a visited struct that the object holds; others keep their values.
/// Throws nlohmann's exceptions on missing keys and wrong types. \throws BadRecord for unknown names
template <class T>
void read_fields(const nlohmann::ordered_json& json, T& object);

/// \throws BadRecord for a key that the visited struct has not: it may be one that is misspelt. \param group
/// what stands before the key in the message, "work."
template <Visited T>
void require_known_keys(const nlohmann::ordered_json& json, const std::string& group = {}) {
  std::vector<std::string> names;
  const T none;
  visit_fields(none, [&](const Field& field, const auto&) { names.emplace_back(field.name); });
  for (const auto& [key, value] : json.items()) {
    if (std::find(names.begin(), names.end(), key) == names.end())
      throw BadRecord(group + one_line(key) + " = unknown (must be one of " + joined(names, ", ") + ")");
  }
}

namespace json_detail {

using Json = nlohmann::ordered_json;

template <class T>
concept Special = requires(const T& value) {
  JsonForm<T>::write(value);
};

template <class T>
concept Named = std::is_enum_v<T> && requires {
  EnumNames<T>::values;
};

template <class T>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

/// Lists whose entries the JSON library does not know, or converts without looking.
template <class T>
inline constexpr bool kIsList = false;
template <class T>
inline constexpr bool kIsList<std::vector<T>> = Visited<T> || Special<T> || Whole<T>;

template <class T>
bool is_empty(const T& value) {
  if constexpr (std::is_same_v<T, std::optional<double>>) {
    return !value || !std::isfinite(*value);
  } else if constexpr (kIsOptional<T>) {
    return !value;
  } else if constexpr (requires { value.empty(); }) {
    return value.empty();
  } else {
    return false;
  }
}

template <class T>
Json written(const T& value) {
  if constexpr (kIsOptional<T>) {
    return written(*value);
  } else if constexpr (Special<T>) {
    return JsonForm<T>::write(value);
  } else if constexpr (Named<T>) {
    return enum_name(value);
  } else if constexpr (Visited<T>) {
    return write_fields(value);
  } else if constexpr (kIsList<T>) {
    Json list = Json::array();
    for (const auto& item : value) list.push_back(written(item));
    return list;
  } else {
    return value;
  }
}

template <class T>
void read_into(std::string_view field, const Json& json, T& value) {
  if constexpr (kIsOptional<T>) {
    read_into(field, json, value.emplace());
  } else if constexpr (Special<T>) {
    value = JsonForm<T>::read(json);
  } else if constexpr (Named<T>) {
    value = enum_from_name<T>(field, json.get<std::string>());
  } else if constexpr (Whole<T>) {
    value = whole_number<T>(field, json);
  } else if constexpr (Visited<T>) {
    read_fields(json, value);
  } else if constexpr (kIsList<T>) {
    value.clear();
    for (const Json& item : json.get_ref<const Json::array_t&>()) {
      try {
        read_into(field, item, value.emplace_back());
      } catch (const BadRecord& error) {
        if constexpr (!Visited<typename T::value_type>) throw;
        throw BadRecord(std::string(field) + "." + error.what());
      }
    }
  } else {
    value = json.get<T>();
  }
}

}  // namespace json_detail

template <class Value>
nlohmann::ordered_json JsonForm<std::vector<std::pair<std::string, Value>>>::write(const Pairs& pairs) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [name, value] : pairs) json[name] = json_detail::written(value);
  return json;
}

template <class Value>
auto JsonForm<std::vector<std::pair<std::string, Value>>>::read(const nlohmann::ordered_json& json) -> Pairs {
  Pairs pairs;
  for (const auto& [name, value] : json.items())
    json_detail::read_into(name, value, pairs.emplace_back(name, Value()).second);
  return pairs;
}

/// Adds a field to an object, unless it is empty and may be absent.
template <class T>
void write_field(nlohmann::ordered_json& json, const Field& field, const T& value) {
  const bool optional = field.presence == Presence::unless_empty;
  if (optional && json_detail::is_empty(value)) return;
  nlohmann::ordered_json written = json_detail::written(value);
  // A group of which nothing is known is as empty as a value that is not there.
  if constexpr (Visited<T>) {
    if (optional && written.empty()) return;
  }
  json[field.name] = std::move(written);
}

/// Reads a field if the object holds it. Throws nlohmann's exceptions where a required one is missing.
template <class T>
void read_field(const nlohmann::ordered_json& json, const Field& field, T& value) {
  const auto found = json.find(field.name);
  if (found == json.end()) {
    if (field.presence == Presence::required) static_cast<void>(json.at(field.name));
    return;
  }
  if constexpr (Visited<T>) {
    if (found->empty()) return;
  }
  json_detail::read_into(field.name, *found, value);
}

template <class T>
nlohmann::ordered_json write_fields(const T& object) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  visit_fields(object, [&](const Field& field, const auto& value) { write_field(json, field, value); });
  return json;
}

template <class T>
void read_fields(const nlohmann::ordered_json& json, T& object) {
  visit_fields(object, [&](const Field& field, auto& value) { read_field(json, field, value); });
}

}  // namespace signorini
