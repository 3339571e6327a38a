#pragma once
// How the fields of a struct are listed: one `visit_fields` per struct, which writers, readers, tables and
// tests go by, as `visit` is for the options of a method.

#include <concepts>
#include <string_view>
#include <type_traits>

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

}  // namespace signorini
