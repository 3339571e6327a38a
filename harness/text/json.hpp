#pragma once
// JSON from text and to text. Parser and writer of the JSON library are compiled here alone: they take longer
// than most files that call them.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace signorini {

/// \throws nlohmann::ordered_json::parse_error where the text is no JSON
nlohmann::ordered_json parse_json(std::string_view text);

/// The same without an exception: `is_discarded()` where the text is no JSON.
nlohmann::ordered_json try_parse_json(std::string_view text);

/// In one line. \throws nlohmann::ordered_json::type_error where a text is not UTF-8
std::string json_text(const nlohmann::ordered_json& json);

/// In lines that are indented by so many blanks per level. \throws the same
std::string json_text(const nlohmann::ordered_json& json, int indent);

/// In one line; bytes that are not UTF-8 (a method may print any) become U+FFFD rather than an exception.
std::string json_line(const nlohmann::ordered_json& json);

}  // namespace signorini
