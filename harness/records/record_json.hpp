#pragma once
// Records as JSON lines. What is written of each field follows from record_fields.hpp; here is what is
// special: laws, options, rounds.

#include <nlohmann/json_fwd.hpp>

#include "harness/records/json_fields.hpp"
#include "harness/records/record.hpp"

namespace signorini {

/// Exactly the keys of docs/records.md, absent where a notion is; numbers that are not finite are absent.
nlohmann::ordered_json to_json(const Record& record);

/// Settings that a record of an earlier version does not hold are those in the name of its case.
/// \throws BadRecord
Record record_from_json(const nlohmann::ordered_json& json);

/// One key, the law's name, with its constant: {"restitution": 0.8}.
nlohmann::ordered_json law_to_json(const RepresentedLaw& law);
RepresentedLaw law_from_json(const nlohmann::ordered_json& json);  ///< \throws BadRecord

/// law_to_json and law_from_json.
template <>
struct JsonForm<RepresentedLaw> {
  static nlohmann::ordered_json write(const RepresentedLaw& law);  ///< as law_to_json
  static RepresentedLaw read(const nlohmann::ordered_json& json);  ///< as law_from_json
};

/// An object, option by option.
template <>
struct JsonForm<RecordedOptions> {
  static nlohmann::ordered_json write(const RecordedOptions& options);  ///< "auto" where the method chooses
  static RecordedOptions read(const nlohmann::ordered_json& json);      ///< numbers keep their kind
};

/// An object of texts, setting by setting.
template <>
struct JsonForm<Settings> {
  static nlohmann::ordered_json write(const Settings& settings);  ///< values as asked for
  static Settings read(const nlohmann::ordered_json& json);       ///< values as asked for
};

/// A pair, set-up and solve.
template <>
struct JsonForm<TimedRound> {
  static nlohmann::ordered_json write(const TimedRound& round);  ///< [set-up, solve]
  static TimedRound read(const nlohmann::ordered_json& json);    ///< of two numbers
};

}  // namespace signorini
