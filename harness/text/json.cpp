#include "harness/text/json.hpp"

#include <nlohmann/json.hpp>

namespace signorini {

using Json = nlohmann::ordered_json;

Json parse_json(std::string_view text) { return Json::parse(text); }

Json try_parse_json(std::string_view text) { return Json::parse(text, nullptr, false); }

std::string json_text(const Json& json) { return json.dump(); }

std::string json_text(const Json& json, int indent) { return json.dump(indent); }

std::string json_line(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace signorini
