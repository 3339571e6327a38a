#pragma once
// JSON as one line of text, as in records.jsonl and between processes.

#include <nlohmann/json.hpp>
#include <string>

namespace signorini {

/// One line; bytes that are not UTF-8 (a method may print any) become U+FFFD rather than an exception.
inline std::string json_line(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace signorini
