
#include <algorithm>
#include <array>

#include "harness/files.hpp"
#include "harness/orbits/orbit_file.hpp"

namespace signorini {

namespace fs = std::filesystem;

fs::path references_folder() {
  const fs::path references = fs::path("results") / "references";
  for (fs::path folder = fs::current_path();; folder = folder.parent_path()) {
    if (fs::is_directory(folder / references)) return folder / references;
    if (folder == folder.parent_path()) return references;
  }
}

namespace {

fs::path file_of(const Scene& scene, const fs::path& folder) {
  return folder / (scene.problem.name + ".json");
}

}  // namespace

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
  const auto kept = std::find_if(file->orbits.begin(), file->orbits.end(),
                                 [](const FoundOrbit& orbit) { return orbit.from_rest; });
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
