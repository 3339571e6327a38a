#include "harness/records/record.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "harness/records/json_fields.hpp"
#include "harness/records/trajectory_json.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kRecordSchema = 1;

constexpr std::array<std::string_view, 9> kStatusNames{"converged",      "inaccurate", "not-converged",
                                                       "not-applicable", "timeout",    "out-of-memory",
                                                       "crashed",        "exception",  "invalid-output"};
constexpr std::array<std::string_view, 3> kCertificateNames{"none", "uncertified", "certified"};

template <std::size_t N>
std::size_t name_index(const std::array<std::string_view, N>& names, const std::string& name) {
  for (std::size_t i = 0; i < N; ++i) {
    if (names[i] == name) return i;
  }
  throw BadRecord(fmt::format("status = {} (must be one of {})", name, fmt::join(names, ", ")));
}

const Json& object(const Json& json, const char* key) {
  static const Json none = Json::object();
  const auto found = json.find(key);
  return found == json.end() ? none : *found;
}

struct LawWriter {
  Json operator()(std::monostate) const { return {{"none", true}}; }
  Json operator()(const Restitution& law) const { return {{"restitution", law.e}}; }
  Json operator()(const Penalty& law) const { return {{"penalty", law.stiffness}}; }
  Json operator()(Massless) const { return {{"massless", true}}; }
  Json operator()(Undetermined) const { return {{"undetermined", true}}; }
};

OptionValue read_option(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number_integer()) return json.get<long>();
  if (json.is_number()) return json.get<double>();
  const auto text = json.get<std::string>();
  return text == "auto" ? OptionValue{} : OptionValue{text};
}

Json write_work(const WorkDone& work) {
  Json json = Json::object();
  put(json, "unknowns", work.counts.unknowns);
  put(json, "iterations", work.counts.iterations);
  put(json, "pivots", work.counts.pivots);
  put(json, "rhs_evaluations", work.counts.rhs_evaluations);
  put(json, "factorisations", work.counts.factorisations);
  put(json, "peak_memory_bytes", work.peak_memory_bytes);
  return json;
}

Json write_seconds(const Seconds& seconds) {
  Json json{{"median", seconds.median},           {"min", seconds.min},     {"mad", seconds.mad},
            {"repetitions", seconds.repetitions}, {"setup", seconds.setup}, {"solve", seconds.solve}};
  put(json, "unstable", seconds.unstable);
  for (const TimedRound& round : seconds.rounds) json["rounds"].push_back({round.setup, round.solve});
  put(json, "jobs", seconds.jobs);
  return json;
}

Seconds read_seconds(const Json& json) {
  Seconds seconds{.median = json.at("median"),
                  .min = json.at("min"),
                  .mad = json.at("mad"),
                  .repetitions = json.at("repetitions"),
                  .setup = json.at("setup"),
                  .solve = json.at("solve")};
  get(json, "unstable", seconds.unstable);
  for (const Json& round : object(json, "rounds")) seconds.rounds.push_back({round.at(0), round.at(1)});
  get(json, "jobs", seconds.jobs);
  return seconds;
}

Json write_family(const FamilyLevel& family) {
  return {{"name", family.family},
          {"parameter", family.parameter},
          {"level", family.level},
          {"severity", family.severity},
          {"levels", family.levels}};
}

FamilyLevel read_family(const Json& json) {
  return {.family = json.at("name"),
          .parameter = json.at("parameter"),
          .level = json.at("level"),
          .severity = json.at("severity"),
          .levels = json.at("levels")};
}

Json write_certificate(const Certificate& certificate) {
  Json json;
  json["status"] = certificate_name(certificate.status);
  put(json, "reason", certificate.reason);
  put(json, "source", certificate.source);
  put(json, "orbit", certificate.orbit);
  put(json, "order", certificate.order);
  put(json, "error_bar", certificate.error_bar);
  put(json, "residual", certificate.residual);
  put(json, "distance", certificate.distance);
  put(json, "reference", certificate.reference);
  put(json, "reference_reason", certificate.reference_reason);
  put(json, "same_orbit", certificate.same_orbit);
  if (certificate.status == CertificateStatus::certified) json["events"] = Json::array();
  for (const OrbitEvent& event : certificate.events) {
    Json item{{"time", event.time}, {"contact", event.contact}, {"kind", event.kind}};
    put(item, "value", event.value);
    json["events"].push_back(std::move(item));
  }
  put(json, "return_distance", certificate.return_distance);
  put(json, "floquet", certificate.floquet);
  put(json, "stable", certificate.stable);
  return json;
}

Certificate read_certificate(const Json& json) {
  Certificate certificate;
  if (json.empty()) return certificate;
  certificate.status = static_cast<CertificateStatus>(name_index(kCertificateNames, json.at("status")));
  get(json, "reason", certificate.reason);
  get(json, "source", certificate.source);
  get(json, "orbit", certificate.orbit);
  get(json, "order", certificate.order);
  get(json, "error_bar", certificate.error_bar);
  get(json, "residual", certificate.residual);
  get(json, "distance", certificate.distance);
  get(json, "reference", certificate.reference);
  get(json, "reference_reason", certificate.reference_reason);
  get(json, "same_orbit", certificate.same_orbit);
  for (const Json& item : object(json, "events")) {
    OrbitEvent event{
        .time = item.at("time"), .contact = item.at("contact"), .kind = item.at("kind"), .value = {}};
    get(item, "value", event.value);
    certificate.events.push_back(std::move(event));
  }
  get(json, "return_distance", certificate.return_distance);
  get(json, "floquet", certificate.floquet);
  get(json, "stable", certificate.stable);
  return certificate;
}

constexpr std::array kErrors{&Errors::x_l2,        &Errors::x_max,   &Errors::u_l2,
                             &Errors::velocity_l2, &Errors::impulse, &Errors::x_l2_scene};
constexpr std::array kErrorKeys{"x_l2", "x_max", "u_l2", "velocity_l2", "impulse", "x_l2_scene"};
constexpr std::array kPhysics{&Physics::penetration, &Physics::complementarity, &Physics::energy_defect,
                              &Physics::contact_ratio};
constexpr std::array kPhysicsKeys{"penetration", "complementarity", "energy_defect", "contact_ratio"};

Json write_physics(const Physics& physics) {
  Json json = Json::object();
  for (std::size_t i = 0; i < kPhysics.size(); ++i) put(json, kPhysicsKeys[i], physics.*kPhysics[i]);
  if (!physics.energy_reason.empty()) json["energy_reason"] = physics.energy_reason;
  if (!physics.effective_restitution.empty()) json["effective_restitution"] = physics.effective_restitution;
  return json;
}

Json write_waveform(const Waveform& waveform) {
  return {{"t", waveform.t},
          {"x", waveform.x},
          {"velocity", waveform.velocity},
          {"force", waveform.force},
          {"impulse", waveform.impulse}};
}

Waveform read_waveform(const Json& json) {
  using Lists = std::vector<std::vector<double>>;
  return {.t = json.at("t").get<std::vector<double>>(),
          .x = json.at("x").get<Lists>(),
          .velocity = json.at("velocity").get<Lists>(),
          .force = json.at("force").get<Lists>(),
          .impulse = json.at("impulse").get<Lists>()};
}

Json write_waveforms(const Waveforms& waveforms) {
  Json json{{"contacts", waveforms.contacts}, {"answer", write_waveform(waveforms.answer)}};
  if (waveforms.orbit) json["orbit"] = write_waveform(*waveforms.orbit);
  return json;
}

Waveforms read_waveforms(const Json& json) {
  Waveforms waveforms{.contacts = json.at("contacts").get<std::vector<int>>(),
                      .answer = read_waveform(json.at("answer"))};
  if (json.contains("orbit")) waveforms.orbit = read_waveform(json["orbit"]);
  return waveforms;
}

void read_body(const Json& json, Record& record) {
  if (json.at("schema").get<int>() != kRecordSchema) throw BadRecord("schema = unknown (must be 1)");
  get(json, "case", record.case_id);
  get(json, "key", record.key);
  record.scene = json.at("scene");
  record.scene_sha256 = json.at("scene_sha256");
  record.method = json.at("method");
  get(json, "plugin", record.plugin);
  for (const auto& [name, value] : json.at("options").items())
    record.options.emplace_back(name, read_option(value));
  record.status = static_cast<Status>(name_index(kStatusNames, json.at("status")));
  if (json.contains("family")) record.family = read_family(json["family"]);
  get(json, "message", record.message);
  get(json, "signal", record.signal);
  if (json.contains("law")) record.law = law_from_json(json["law"]);
  if (json.contains("scene_law")) record.scene_law = law_from_json(json["scene_law"]);
  get(json, "law_matches_scene", record.law_matches_scene);
  get(json, "period", record.period);
  get(json, "residual", record.residual);
  get(json, "condition", record.condition);
  record.work = work_from_json(object(json, "work"));
  if (json.contains("seconds")) record.seconds = read_seconds(json["seconds"]);
  get(json, "not_timed", record.not_timed);
  get(json, "answer", record.answer);
  if (json.contains("repeats")) {
    const Json& repeats = json["repeats"];
    record.repeats = Repeats{.solves = repeats.at("solves"), .identical = repeats.at("identical")};
  }
  get(json, "elapsed", record.elapsed);
  record.certificate = read_certificate(object(json, "certificate"));
  for (std::size_t i = 0; i < kErrors.size(); ++i)
    get(object(json, "errors"), kErrorKeys[i], record.errors.*kErrors[i]);
  const Json& physics = object(json, "physics");
  for (std::size_t i = 0; i < kPhysics.size(); ++i)
    get(physics, kPhysicsKeys[i], record.physics.*kPhysics[i]);
  get(physics, "energy_reason", record.physics.energy_reason);
  get(physics, "effective_restitution", record.physics.effective_restitution);
  if (json.contains("trajectory")) record.trajectory = trajectory_samples_from_json(json["trajectory"]);
  if (json.contains("waveforms")) record.waveforms = read_waveforms(json["waveforms"]);
}

}  // namespace

std::string_view certificate_name(CertificateStatus status) {
  return kCertificateNames[static_cast<std::size_t>(status)];
}

void count_repeat(const std::string& answer, Record& record) {
  Repeats repeats = record.repeats.value_or(Repeats{});
  ++repeats.solves;
  repeats.identical += answer == record.answer ? 1 : 0;
  record.repeats = repeats;
}

double measurable_error(const Record& record) {
  constexpr double kErrorBars = 10.0;
  return kErrorBars * record.certificate.error_bar.value_or(0.0);
}

std::string_view status_name(Status status) { return kStatusNames[static_cast<std::size_t>(status)]; }

Json law_to_json(const RepresentedLaw& law) { return std::visit(LawWriter{}, law); }

RepresentedLaw law_from_json(const Json& json) {
  if (json.contains("restitution")) return Restitution{json["restitution"].get<double>()};
  if (json.contains("penalty")) return Penalty{json["penalty"].get<std::vector<double>>()};
  if (json.contains("massless")) return Massless{};
  if (json.contains("undetermined")) return Undetermined{};
  if (json.contains("none")) return std::monostate{};
  throw BadRecord("law = " + json.dump() + " (must be restitution, penalty, massless, undetermined or none)");
}

RepresentedLaw as_represented(const Law& law) {
  return std::visit([](const auto& held) -> RepresentedLaw { return held; }, law);
}

Json option_to_json(const OptionValue& value) {
  if (std::holds_alternative<std::monostate>(value)) return "auto";
  return std::visit(
      [](const auto& held) -> Json {
        if constexpr (std::is_same_v<std::decay_t<decltype(held)>, std::monostate>) {
          return "auto";
        } else {
          return held;
        }
      },
      value);
}

WorkDone work_from_json(const Json& json) {
  WorkDone work;
  get(json, "unknowns", work.counts.unknowns);
  get(json, "iterations", work.counts.iterations);
  get(json, "pivots", work.counts.pivots);
  get(json, "rhs_evaluations", work.counts.rhs_evaluations);
  get(json, "factorisations", work.counts.factorisations);
  get(json, "peak_memory_bytes", work.peak_memory_bytes);
  return work;
}

Json to_json(const Record& record) {
  Json json;
  json["schema"] = kRecordSchema;
  put(json, "case", record.case_id);
  put(json, "key", record.key);
  json["scene"] = record.scene;
  json["scene_sha256"] = record.scene_sha256;
  if (record.family) json["family"] = write_family(*record.family);
  json["method"] = record.method;
  put(json, "plugin", record.plugin);
  json["options"] = Json::object();
  for (const auto& [name, value] : record.options) json["options"][name] = option_to_json(value);
  json["status"] = status_name(record.status);
  put(json, "message", record.message);
  put(json, "signal", record.signal);
  if (record.law) json["law"] = law_to_json(*record.law);
  if (record.scene_law) json["scene_law"] = law_to_json(*record.scene_law);
  put(json, "law_matches_scene", record.law_matches_scene);
  put(json, "period", record.period);
  put(json, "residual", record.residual);
  put(json, "condition", record.condition);
  put_object(json, "work", write_work(record.work));
  if (record.seconds) json["seconds"] = write_seconds(*record.seconds);
  put(json, "not_timed", record.not_timed);
  put(json, "answer", record.answer);
  if (record.repeats)
    json["repeats"] = {{"solves", record.repeats->solves}, {"identical", record.repeats->identical}};
  put(json, "elapsed", record.elapsed);
  json["certificate"] = write_certificate(record.certificate);
  Json errors = Json::object();
  for (std::size_t i = 0; i < kErrors.size(); ++i) put(errors, kErrorKeys[i], record.errors.*kErrors[i]);
  put_object(json, "errors", std::move(errors));
  put_object(json, "physics", write_physics(record.physics));
  if (record.trajectory) json["trajectory"] = to_json(*record.trajectory);
  if (record.waveforms) json["waveforms"] = write_waveforms(*record.waveforms);
  return json;
}

Record record_from_json(const Json& json) {
  try {
    Record record;
    read_body(json, record);
    return record;
  } catch (const nlohmann::json::exception& error) {
    const std::string what = error.what();  // "[json.exception...] key 'case' not found"
    throw BadRecord(fmt::format("record = unreadable (must be one as run writes it: {})",
                                what.substr(what.find("] ") + 2)));
  }
}

}  // namespace signorini
