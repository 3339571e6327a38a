#include "harness/orbits/orbit_file.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "harness/failure.hpp"
#include "harness/records/record_fields.hpp"
#include "harness/records/record_json.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kOrbitSchema = 1;

FoundOrbit orbit_from_json(const Json& json) {
  FoundOrbit orbit{.fingerprint = json.at("orbit"),
                   .order = json.at("order"),
                   .period = json.at("period"),
                   .amplitude = json.at("amplitude"),
                   .starts = json.at("starts"),
                   .cold = json.at("found_by").get<std::vector<std::string>>(),
                   .from_rest = json.at("from_rest")};
  CertifiedOrbit& certified = orbit.certified;
  certified.source = json.at("source");
  certified.error_bar = json.at("error_bar");
  read_field(json, Field{"residual"}, certified.residual);
  read_field(json, Field{"return_distance"}, certified.return_distance);
  read_field(json, Field{"floquet"}, certified.floquet);
  read_field(json, Field{"stable"}, certified.stable);
  read_field(json, required("events"), certified.events);
  return orbit;
}

OrbitFile file_from_json(const Json& json) {
  if (json.at("schema") != kOrbitSchema)
    throw BadRecord(fmt::format("schema = {} (must be {})", json.at("schema").dump(), kOrbitSchema));
  const Json& search = json.at("search");
  OrbitFile file{.scene = json.at("scene"),
                 .scene_sha256 = json.at("scene_sha256"),
                 .law = law_from_json(json.at("law")),
                 .options = {.starts = search.at("starts"),
                             .subharmonics = search.at("subharmonics"),
                             .seed = search.at("seed")}};
  for (const Json& orbit : json.at("orbits")) file.orbits.push_back(orbit_from_json(orbit));
  return file;
}

/// Messages of the JSON library begin with a code of its own in brackets.
std::string without_code(const std::string& message) {
  const std::size_t end = message.find("] ");
  return end == std::string::npos ? message : message.substr(end + 2);
}

}  // namespace

OrbitFile make_orbit_file(const Scene& scene, const OrbitSearchOptions& options, const SceneOrbits& found) {
  return {.scene = scene.problem.name,
          .scene_sha256 = scene.sha256,
          .law = as_represented(scene.problem.law),
          .options = options,
          .orbits = found.orbits};
}

Json to_json(const FoundOrbit& orbit) {
  const CertifiedOrbit& certified = orbit.certified;
  Json json{{"orbit", orbit.fingerprint}, {"order", orbit.order},
            {"period", orbit.period},     {"amplitude", orbit.amplitude},
            {"impacts", orbit.impacts()}, {"contact_phases", orbit.contact_phases()},
            {"source", certified.source}, {"error_bar", certified.error_bar}};
  write_field(json, Field{"residual"}, certified.residual);
  write_field(json, Field{"return_distance"}, certified.return_distance);
  write_field(json, Field{"floquet"}, certified.floquet);
  write_field(json, Field{"stable"}, certified.stable);
  json["from_rest"] = orbit.from_rest;
  json["starts"] = orbit.starts;
  json["found_by"] = orbit.cold;
  write_field(json, Field{"events", "", Presence::always}, certified.events);
  return json;
}

std::string print_orbit_file(const OrbitFile& file) {
  const Json search{{"starts", file.options.starts},
                    {"subharmonics", file.options.subharmonics},
                    {"seed", file.options.seed}};
  std::string text = fmt::format(
      "{{\n\"schema\": {},\n\"scene\": {},\n\"scene_sha256\": {},\n\"law\": {},\n\"search\": "
      "{},\n\"orbits\": [",
      kOrbitSchema, Json(file.scene).dump(), Json(file.scene_sha256).dump(), law_to_json(file.law).dump(),
      search.dump());
  for (std::size_t i = 0; i < file.orbits.size(); ++i)
    text += (i == 0 ? "\n" : ",\n") + to_json(file.orbits[i]).dump();
  return text + "\n]\n}\n";
}

OrbitFile parse_orbit_file(const std::string& text, const std::string& name) {
  try {
    return file_from_json(Json::parse(text));
  } catch (const nlohmann::json::exception& error) {
    throw UsageError(
        fmt::format("{}: {} (must be a file that verify --update wrote)", name, without_code(error.what())));
  } catch (const BadRecord& error) {
    throw UsageError(fmt::format("{}: {}", name, error.what()));
  }
}

}  // namespace signorini
