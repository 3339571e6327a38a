#include "harness/orbits/orbit_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/records/record_check.hpp"
#include "harness/records/record_json.hpp"
#include "harness/text/json.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kOrbitSchema = 1;

/// Messages of the JSON library begin with a code of its own in brackets.
std::string without_code(const std::string& message) {
  const std::size_t end = message.find("] ");
  return end == std::string::npos ? message : message.substr(end + 2);
}

fs::path file_of(const Scene& scene, const fs::path& folder) {
  return folder / (scene.problem.name + ".json");
}

}  // namespace

void visit_fields(Either<OrbitSearchOptions> auto& options, auto&& field) {
  field(required("starts"), options.starts);
  field(required("subharmonics"), options.subharmonics);
  field(required("seed"), options.seed);
}

void visit_fields(Either<FoundOrbit> auto& orbit, auto&& field) {
  // For readers of the file; the events say the same.
  int impacts = orbit.impacts(), contact_phases = orbit.contact_phases();
  field(required("orbit"), orbit.fingerprint);
  field(required("order"), orbit.order);
  field(required("period", "s"), orbit.period);
  field(required("amplitude", "m"), orbit.amplitude);
  field(Field{"impacts", "", Presence::always}, impacts);
  field(Field{"contact_phases", "", Presence::always}, contact_phases);
  field(required("source"), orbit.certified.source);
  field(required("error_bar"), orbit.certified.error_bar);
  field(Field{"residual"}, orbit.certified.residual);
  field(Field{"return_distance"}, orbit.certified.return_distance);
  field(Field{"floquet"}, orbit.certified.floquet);
  field(Field{"stable"}, orbit.certified.stable);
  field(Field{"stability"}, orbit.certified.stability);
  field(Field{"stability_reason"}, orbit.certified.undefined);
  field(Field{"orders"}, orbit.certified.orders);
  field(required("from_rest"), orbit.from_rest);
  field(required("starts"), orbit.starts);
  field(required("found_by"), orbit.cold);
  field(required("events"), orbit.certified.events);
}

void visit_fields(Either<OrbitFile> auto& file, auto&& field) {
  field(required("scene"), file.scene);
  field(required("scene_sha256"), file.scene_sha256);
  field(required("law"), file.law);
  field(required("search"), file.options);
  field(required("orbits"), file.orbits);
}

OrbitFile make_orbit_file(const Scene& scene, const OrbitSearchOptions& options, const SceneOrbits& found) {
  return {.scene = scene.problem.name,
          .scene_sha256 = scene.sha256,
          .law = as_represented(scene.problem.law()),
          .options = options,
          .orbits = found.orbits};
}

Json to_json(const FoundOrbit& orbit) { return write_fields(orbit); }

std::string print_orbit_file(const OrbitFile& file) {
  Json json{{"schema", kOrbitSchema}};
  json.update(write_fields(file));
  std::string text;
  for (const auto& [key, value] : json.items()) {
    text += fmt::format("{}\"{}\": {}", text.empty() ? "{\n" : ",\n", key,
                        key == "orbits" ? "[" : json_text(value));
  }
  for (std::size_t i = 0; i < file.orbits.size(); ++i)
    text += (i == 0 ? "\n" : ",\n") + json_text(to_json(file.orbits[i]));
  return text + "\n]\n}\n";
}

OrbitFile parse_orbit_file(const std::string& text, const std::string& name) {
  try {
    const Json json = parse_json(text);
    require_plain_texts(json);
    if (json.at("schema") != kOrbitSchema)
      throw BadRecord(fmt::format("schema = {} (must be {})", json_text(json.at("schema")), kOrbitSchema));
    OrbitFile file;
    read_fields(json, file);
    return file;
  } catch (const nlohmann::json::exception& error) {
    throw UsageError(
        fmt::format("{}: {} (must be a file that verify --update wrote)", name, without_code(error.what())));
  } catch (const BadRecord& error) {
    throw UsageError(fmt::format("{}: {}", name, error.what()));
  }
}

fs::path references_folder() {
  const fs::path references = fs::path("results") / "references";
  for (fs::path folder = fs::current_path();; folder = folder.parent_path()) {
    if (fs::is_directory(folder / references)) return folder / references;
    if (folder == folder.parent_path()) return references;
  }
}

std::string kept_reference_digest(const Scene& scene, const fs::path& folder) {
  const fs::path path = file_of(scene, folder);
  return fs::is_regular_file(path) ? sha256_of_file(path) : std::string();
}

std::optional<Reference> kept_reference(const Scene& scene, const fs::path& folder,
                                        const OrbitPolisher& polish, Deadline deadline) {
  const fs::path path = file_of(scene, folder);
  if (!polish || !fs::is_regular_file(path)) return std::nullopt;
  std::optional<OrbitFile> file;
  try {
    file = parse_orbit_file(read_file(path), path.string());
  } catch (const std::exception&) {  // it is not ours to judge here: `signorini verify` does
    return std::nullopt;
  }
  if (file->scene_sha256 != scene.sha256) return std::nullopt;
  const auto kept = std::ranges::find(file->orbits, true, &FoundOrbit::from_rest);
  if (kept == file->orbits.end()) return std::nullopt;
  const CertifiedOrbit& known = kept->certified;
  const std::array confirmed{Certificate{
      .error_bar = known.error_bar, .events = known.events, .return_distance = known.return_distance}};
  std::optional<FoundOrbit> orbit = certify_again(scene.problem, *kept, deadline, polish, confirmed);
  const bool same = orbit && orbit->order == kept->order && orbit->fingerprint == kept->fingerprint;
  if (!same || orbit->certified.error_bar > kReferenceErrorBar) return std::nullopt;
  return as_reference(scene.problem, std::move(orbit->certified));
}

}  // namespace signorini
