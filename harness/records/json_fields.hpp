#pragma once
// Fields of JSON objects: absent rather than empty, null or not finite.

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace signorini {

/// Writes a value if there is one; of numbers, if it is finite.
template <class T>
void put(nlohmann::ordered_json& json, const char* key, const std::optional<T>& value) {
  if constexpr (std::is_same_v<T, double>) {
    if (value && !std::isfinite(*value)) return;
  }
  if (value) json[key] = *value;
}

/// Writes a text unless it is empty.
inline void put(nlohmann::ordered_json& json, const char* key, const std::string& text) {
  if (!text.empty()) json[key] = text;
}

/// Writes an object unless it is empty.
inline void put_object(nlohmann::ordered_json& json, const char* key, nlohmann::ordered_json object) {
  if (!object.empty()) json[key] = std::move(object);
}

/// Reads a value if the key is there. Throws nlohmann's exceptions on wrong types.
template <class T>
void get(const nlohmann::ordered_json& json, const char* key, std::optional<T>& value) {
  if (const auto found = json.find(key); found != json.end()) value = found->template get<T>();
}

/// Reads a value if the key is there, and leaves it alone otherwise.
template <class T>
void get(const nlohmann::ordered_json& json, const char* key, T& value) {
  if (const auto found = json.find(key); found != json.end()) value = found->template get<T>();
}

}  // namespace signorini
