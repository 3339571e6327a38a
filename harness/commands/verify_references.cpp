// `signorini verify` of a folder of references.

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "harness/commands/command_line.hpp"
#include "harness/commands/verify.hpp"
#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/glob.hpp"
#include "harness/interrupt.hpp"
#include "harness/orbits/orbit_file.hpp"
#include "harness/orbits/orbit_search.hpp"
#include "harness/plan/deadline.hpp"
#include "harness/progress.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

std::string name_of(const SceneSource& source) {
  const std::string stem = source.file.stem().string();
  return source.level.empty() ? stem : stem + "@" + source.level;
}

/// Whether the orbits of a scene take so long to search that it has to be named.
bool searched_by_name_only(const SceneSource& source) {
  if (!source.level.empty()) return true;
  const SceneHeader header = load_header(source);
  return header.carries(kLarge) || header.carries(kLongSearch);
}

/// A family has many levels: only a filter that speaks of levels, as in grazing@*, asks for them.
bool is_asked_for(const SceneSource& source, const std::optional<std::string>& filter) {
  if (!filter) return !searched_by_name_only(source);
  return source.level.empty() || filter->find('@') != std::string::npos;
}

/// Names of the scenes that have a file in the folder.
std::set<std::string> kept_scenes(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") names.insert(entry.path().stem().string());
  }
  return names;
}

/// Scenes that ship and those that have a file in the folder, if the filter takes them.
std::set<std::string> scenes_to_verify(const VerifyArguments& arguments, const fs::path& folder) {
  std::set<std::string> names;
  if (!arguments.update) names = kept_scenes(folder);
  if (!arguments.update && names.empty() && !arguments.scenes) refuse_folder(folder);
  for (const SceneSource& source : shipped_scenes()) {
    names.erase(name_of(source));
    if (is_asked_for(source, arguments.scenes)) names.insert(name_of(source));
  }
  const std::string filter = arguments.scenes.value_or("*");
  std::erase_if(names, [&](const std::string& name) { return !scene_filter_matches(filter, name); });
  if (names.empty()) {
    throw NothingMatched(fmt::format("scenes = {} (matches no scene; see `signorini list scenes`)", filter));
  }
  return names;
}

void print_lines(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) fmt::print("{}\n", line);
}

/// Searches the orbits of a scene; empty if the search was not completed, for it would prove nothing.
std::optional<OrbitFile> search(const Scene& scene, const OrbitSearchOptions& options) {
  const SceneOrbits orbits = find_all_orbits(scene.problem, options);
  if (orbits.interrupted) return std::nullopt;
  if (orbits.expired) {
    fmt::print("{}: the search did not end within {:g} s (--timeout)\n", scene.problem.name, options.timeout);
    return std::nullopt;
  }
  return make_orbit_file(scene, options, orbits);
}

/// Certifies the kept orbits with impacts that the search missed, from their own events, and adds them to
/// `now`: a search may miss an orbit that exists, for example at a time limit.
void add_missed(const Scene& scene, const OrbitFile& kept, Deadline deadline, OrbitFile& now) {
  for (const FoundOrbit& orbit : kept.orbits) {
    const auto same = [&](const FoundOrbit& found) {
      return found.order == orbit.order && found.fingerprint == orbit.fingerprint;
    };
    if (std::any_of(now.orbits.begin(), now.orbits.end(), same)) continue;
    auto again = certify_again(scene.problem, orbit, deadline);
    if (!again || !same(*again)) continue;
    fmt::print("{}: orbit {} of order {}: not met by the search, certified again from its events\n",
               scene.problem.name, orbit.fingerprint, orbit.order);
    now.orbits.push_back(std::move(*again));
  }
  sort_orbits(now.orbits);
}

/// The orbits that are kept of this very scene, if any.
std::optional<OrbitFile> kept_orbits(const Scene& scene, const fs::path& file) {
  if (!fs::exists(file)) return std::nullopt;
  OrbitFile kept = parse_orbit_file(read_file(file), file.string());
  if (kept.scene_sha256 != scene.sha256) return std::nullopt;
  return kept;
}

/// Writes the orbits of a scene. Periods are searched as far as before where nobody says how far, and an
/// orbit that was kept stays if it can be certified again. \return the number of differences: 1 if the search
/// was not completed
std::size_t update_scene(const VerifyArguments& arguments, const fs::path& file, const Scene& scene) {
  const std::optional<OrbitFile> kept = kept_orbits(scene, file);
  OrbitSearchOptions options = arguments.options;
  const int before = kept ? kept->options.subharmonics : 1;
  options.subharmonics =
      arguments.subharmonics.value_or(std::max(before, default_subharmonics(scene.problem)));
  auto found = search(scene, options);
  if (!found) return 1;
  if (kept) add_missed(scene, *kept, Deadline::after(options.timeout), *found);
  const std::string text = print_orbit_file(*found);
  const bool same = fs::exists(file) && read_file(file) == text;
  if (!same) write_whole(file, text);
  fmt::print("{}: {} orbits {}\n", scene.problem.name, found->orbits.size(), same ? "unchanged" : "written");
  return 0;
}

/// Prints how the orbits of a scene differ from the kept ones. \return the number of differences
std::size_t verify_scene(const VerifyArguments& arguments, const fs::path& file, const std::string& name) {
  if (!fs::exists(file)) {
    fmt::print("{}: no orbits are kept for this scene (verify --update keeps them)\n", name);
    return 1;
  }
  const OrbitFile kept = parse_orbit_file(read_file(file), file.string());
  const Scene scene = read_scene(find_scene(name));
  OrbitDifferences result;
  if (kept.scene_sha256 != scene.sha256) {  // a search would be in vain
    result = compare_orbits(kept, make_orbit_file(scene, kept.options, {}));
  } else {
    OrbitSearchOptions options = kept.options;
    options.timeout = arguments.options.timeout;
    auto now = search(scene, options);
    if (!now || interrupted()) return 1;
    add_missed(scene, kept, Deadline::after(options.timeout), *now);
    result = compare_orbits(kept, *now);
  }
  print_lines(result.differences);
  print_lines(result.fresh);
  if (result.differences.empty())
    fmt::print("{}: {} orbits as kept, {} new\n", name, kept.orbits.size(), result.fresh.size());
  return result.differences.size();
}

}  // namespace

int verify_references(const VerifyArguments& arguments, const fs::path& folder) {
  const std::set<std::string> names = scenes_to_verify(arguments, folder);
  if (arguments.update) fs::create_directories(folder);
  std::size_t differences = 0;
  Progress progress(names.size());
  for (const std::string& name : names) {
    if (interrupted()) break;
    progress.begin(name);
    const fs::path file = folder / (name + ".json");
    differences += arguments.update ? update_scene(arguments, file, read_scene(find_scene(name)))
                                    : verify_scene(arguments, file, name);
    progress.advance();
  }
  if (interrupted()) {
    fmt::print(stderr, "interrupted\n");
    return kInterrupted;
  }
  if (!arguments.update) fmt::print("{} scenes, {} differences\n", names.size(), differences);
  return differences == 0 ? kDone : kUnexpectedFailure;
}

}  // namespace signorini
