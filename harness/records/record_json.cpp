#include "harness/records/record_json.hpp"

#include <nlohmann/json.hpp>

#include "harness/text/json.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

struct LawWriter {
  Json operator()(std::monostate) const { return {{"none", true}}; }
  Json operator()(const Restitution& law) const { return {{"restitution", law.e}}; }
  Json operator()(const Penalty& law) const { return {{"penalty", law.stiffness}}; }
  Json operator()(Massless) const { return {{"massless", true}}; }
  Json operator()(const MixedLaws& mixed) const {
    Json laws = Json::array();
    for (const ContactLaw& law : mixed.laws) laws.push_back(std::visit(*this, law));
    return {{"mixed", laws}};
  }
  Json operator()(const Spring& spring) const { return {{"penalty", spring.stiffness}}; }
  Json operator()(Undetermined) const { return {{"undetermined", true}}; }
};

ContactLaw contact_law_from_json(const Json& json) {
  if (json.contains("restitution")) return Restitution{json["restitution"].get<double>()};
  if (json.contains("penalty")) return Spring{json["penalty"].get<double>()};
  if (json.contains("massless")) return Massless{};
  throw BadRecord("law.mixed = " + json_text(json) + " (must be restitution, penalty or massless)");
}

}  // namespace

Json contact_law_json(const ContactLaw& law) { return std::visit(LawWriter{}, law); }

Json JsonForm<RepresentedLaw>::write(const RepresentedLaw& law) { return std::visit(LawWriter{}, law); }

RepresentedLaw JsonForm<RepresentedLaw>::read(const Json& json) {
  if (json.contains("restitution")) return Restitution{json["restitution"].get<double>()};
  if (json.contains("penalty")) return Penalty{json["penalty"].get<std::vector<double>>()};
  if (json.contains("massless")) return Massless{};
  if (json.contains("mixed")) {
    MixedLaws mixed;
    for (const Json& law : json["mixed"]) mixed.laws.push_back(contact_law_from_json(law));
    return mixed;
  }
  if (json.contains("undetermined")) return Undetermined{};
  if (json.contains("none")) return std::monostate{};
  throw BadRecord("law = " + json_text(json) +
                  " (must be restitution, penalty, massless, mixed, undetermined or none)");
}

Json JsonForm<OptionValue>::write(const OptionValue& value) {
  return std::visit(
      []<class T>(const T& own) -> Json {
        if constexpr (std::is_same_v<T, std::monostate>)
          return "auto";
        else
          return own;
      },
      value);
}

OptionValue JsonForm<OptionValue>::read(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number_integer()) return whole_number<long>("option", json);
  if (json.is_number()) return json.get<double>();
  const auto text = json.get<std::string>();
  return text == "auto" ? OptionValue{} : OptionValue{text};
}

Json JsonForm<TimedRound>::write(const TimedRound& round) {
  Json times{round.setup, round.solve};
  if (round.first) times.push_back(*round.first);
  return times;
}

TimedRound JsonForm<TimedRound>::read(const Json& json) {
  TimedRound round{.setup = json.at(0), .solve = json.at(1)};
  if (json.size() > 2) round.first = json.at(2).get<double>();
  return round;
}

Json to_json(const Record& record) {
  Json json{{"schema", 1}};
  json.update(write_fields(record));
  return json;
}

Record record_from_json(const Json& json) {
  try {
    if (whole_number<int>("schema", json.at("schema")) != 1) throw BadRecord("schema = unknown (must be 1)");
    Record record;
    read_fields(json, record);
    if (!json.contains("settings")) record.settings = parse_case_name(record.case_id).settings;
    return record;
  } catch (const nlohmann::json::exception& error) {
    const std::string what = error.what();  // "[json.exception...] key 'case' not found"
    throw BadRecord("record = unreadable (must be one as run writes it: {})",
                    what.substr(what.find("] ") + 2));
  }
}

}  // namespace signorini
