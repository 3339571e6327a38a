#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "harness/commands/command_line.hpp"
#include "harness/compare/rerun.hpp"
#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/glob.hpp"
#include "harness/interrupt.hpp"
#include "harness/judge/measures/waveform.hpp"
#include "harness/orbits/orbit_file.hpp"
#include "harness/pack/run_pack.hpp"
#include "harness/plan/case_name.hpp"
#include "harness/progress.hpp"
#include "harness/report/document/lines.hpp"
#include "harness/run_folder/run_folder.hpp"
#include "harness/statistics.hpp"
#include "harness/table.hpp"
#include "harness/text/columns.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

/// The command line of `signorini verify`.
struct VerifyArguments {
  std::optional<std::string> folder;  ///< of references or of a run, or a pack
  std::optional<std::string> scenes;  ///< filter of scenes
  std::string cases = "*";            ///< filter of the cases of a run
  OrbitSearchOptions options;         ///< of the search that --update makes
  std::optional<int> subharmonics;    ///< that the search covers; empty: as the scene suggests
  bool update = false;                ///< keep what is found instead of comparing
};

[[noreturn]] void refuse_folder(const fs::path& folder) {
  throw UsageError(
      fmt::format("dir = {} (must be a folder of references, as verify --update makes it, or of records, as "
                  "run makes it)",
                  folder.string()));
}

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
    if (std::ranges::any_of(now.orbits, same)) continue;
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
  for (const auto* lines : {&result.differences, &result.fresh})
    for (const std::string& line : *lines) fmt::print("{}\n", line);
  if (result.differences.empty())
    fmt::print("{}: {} orbits as kept, {} new\n", name, kept.orbits.size(), result.fresh.size());
  return result.differences.size();
}

/// Searches the orbits of the scenes again and prints what differs from the files of the folder, or with
/// `update` writes these. \return the exit code
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

/// Prints times as ratios to the baseline, which mean something on another machine too.
void print_relative_times(const std::vector<RelativeTime>& times) {
  if (times.empty()) {
    fmt::print("times relative to {}: none, it was not timed in both runs\n", kTimeBaseline);
    return;
  }
  std::map<std::string, std::pair<std::vector<double>, std::vector<double>>> methods;
  for (const RelativeTime& time : times) {
    methods[time.method].first.push_back(time.kept);
    methods[time.method].second.push_back(time.now);
  }
  Table table{{"method", "scenes", fmt::format("time / {}, kept", kTimeBaseline), "now", "now / kept"}, {}};
  for (const auto& [method, ratios] : methods) {
    const double kept = median(ratios.first), now = median(ratios.second);
    table.rows.push_back({method, std::to_string(ratios.first.size()), fmt::format("{:.3g}", kept),
                          fmt::format("{:.3g}", now), fmt::format("{:.2f}", now / kept)});
  }
  fmt::print("\n{}\nTimes are medians over the scenes, reported and not judged.\n",
             to_columns(table, kTerminalWidth));
}

/// Prints what of the records cannot be judged, and what was judged by another plugin.
void print_unjudged(const std::vector<Record>& kept, const Rerun& result) {
  for (const auto& [reason, cases] : result.left_out)
    fmt::print("left out: {}: {}\n", plural(static_cast<std::ptrdiff_t>(cases), "case"), reason);
  for (const std::string& method : result.other_plugins)
    fmt::print("note: the plugin of {} is not the one of the run\n", method);
  const auto drawn = std::ranges::count_if(kept, [](const Record& r) { return r.waveforms.has_value(); });
  if (drawn > 0)
    fmt::print(
        "note: the motions that {} keep{} are not judged: they are drawings, to {:g} % of their range\n",
        plural(drawn, "record"), drawn == 1 ? "s" : "", 100.0 * kKeptTolerance);
}

/// Runs the cases of a run again and prints what differs from its records. \param name  of the run, for
/// messages \return the exit code
int verify_records(const VerifyArguments& arguments, const fs::path& folder, const std::string& name) {
  if (arguments.update)
    throw UsageError(fmt::format(
        "dir = {} (must be a folder of references to be updated; `signorini run` makes records anew)", name));
  std::vector<Record> kept = read_current_records(folder);
  const std::string filter = arguments.scenes.value_or("*");
  std::erase_if(kept, [&](const Record& record) { return !scene_filter_matches(filter, record.scene); });
  // Times are reported only, and a pack may ask for any number of rounds.
  constexpr int kMostRounds = 9;
  Limits limits = limits_of_run(folder);
  limits.repetitions = std::min(limits.repetitions, kMostRounds);
  Progress progress(kept.size());
  const Rerun result = rerun_records(kept, limits, arguments.cases, method_catalogue(),
                                     [&](const std::string& what) { progress.begin(what); });
  for (const std::string& difference : result.differences) fmt::print("{}\n", difference);
  for (const std::string& remark : result.remarks)
    fmt::print("{}: a time limit decided, no difference\n", remark);
  print_unjudged(kept, result);
  if (result.cases == result.remarks.size() && result.differences.empty() && !result.interrupted)
    throw NothingMatched(fmt::format("dir = {} (holds no case that can be judged here)", name));
  fmt::print("{} cases, {} differences{}\n", result.cases, result.differences.size(),
             result.remarks.empty()
                 ? ""
                 : fmt::format(", {} not decided within the time limit", result.remarks.size()));
  if (!result.time_ratios.empty()) {
    fmt::print("time, new over kept: {:.3g} in the median of {} cases\n", median(result.time_ratios),
               result.time_ratios.size());
    print_relative_times(result.relative_times);
  }
  if (result.interrupted) return kInterrupted;
  return result.differences.empty() ? kDone : kUnexpectedFailure;
}

int verify(const VerifyArguments& arguments) {
  const fs::path place = arguments.folder ? fs::path(*arguments.folder) : references_folder();
  const auto run = arguments.update ? std::nullopt : std::make_optional<OpenedRun>(place);
  const fs::path folder = run ? run->folder() : place;
  if (run && run->was_packed()) fmt::print("{}: SHA-256 {}\n", place.string(), sha256_of_file(place));
  if (!arguments.update && !fs::is_directory(folder)) refuse_folder(folder);
  refuse_old_responses(folder);
  watch_interrupts();
  return fs::exists(folder / "records.jsonl") ? verify_records(arguments, folder, place.string())
                                              : verify_references(arguments, folder);
}

}  // namespace

void add_verify_command(const Command& program) {
  const auto [command, arguments] = program.command(
      "verify", verify,
      fmt::format(
          "Repeats stored computations and reports what differs. Of a folder of references: searches every "
          "scene's orbits again; each kept orbit must be found, or certified again from its impacts, its "
          "events within {:g} times the sum of both error bars plus {:g} of a period, with the same "
          "multipliers and stability. Of a folder with records.jsonl: runs the cases again; each must end "
          "with the same status and an error of x within a factor of {:g} or below ten error bars, while "
          "times are only reported. Of a file that `pack` made: the same, after a check of its hashes; "
          "nothing in it is run. Cases of methods and scenes that are not here are left out and counted. "
          "Exit code 0 if all is the same, 1 if not, 3 if no case can be judged.",
          kErrorBars, kInstantFloor, kErrorFactor));
  command.option("dir", arguments->folder,
                 "folder of references or of a run, or a pack; results/references here or above if absent");
  command.option("--scenes", arguments->scenes,
                 "scenes by glob, A*:B*-C*; members of a family only if the glob names them, as grazing@*; "
                 "if absent the catalogue but for the scenes tagged large or long-search");
  command.option("--cases", arguments->cases, "cases of a run by glob on SCENE/METHOD[OPTIONS]");
  command.flag(
      "--update", arguments->update,
      "search, and keep what is found and what is still certified, instead of comparing; --starts, "
      "--subharmonics (if absent as far as before) and --seed are for this, a comparison searches as the "
      "files say");
  add_search_options(command, arguments->options, arguments->subharmonics);
}

}  // namespace signorini
