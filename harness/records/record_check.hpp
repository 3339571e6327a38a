#pragma once
// What a record read from a file may hold. Records are sent around, shown, reported and resumed: nothing in
// one may reach a terminal, a script or a path as more than the text that it is.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "harness/records/record.hpp"

namespace signorini {

/// Longest text of a record, a message for instance [bytes].
inline constexpr std::size_t kLongestText = 4000;

/// The text of a method, an exception or a process as a record keeps it: one line, control characters and
/// what is no UTF-8 escaped, at most some 1000 bytes.
std::string as_message(const std::string& text);

/// \throws BadRecord unless every text of a value, names of fields included, is at most kLongestText long and
/// without control characters, and it nests at most 32 levels deep
void require_plain_texts(const nlohmann::ordered_json& json);

/// A record of a file that anybody may have written, as record_from_json reads it.
/// \throws BadRecord also unless every text in it, names of options included, is at most kLongestText long
/// and without control characters; scene and method are names as the program gives them, "sdof-stop",
/// "grazing@1e-4", "hat-lcp"; counts, times and errors are 0 or more, a family's severity is one of its
/// levels, and it nests at most 32 levels deep
Record checked_record(const nlohmann::ordered_json& json);

}  // namespace signorini
