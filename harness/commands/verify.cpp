#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include "harness/commands/command_line.hpp"
#include "harness/compare/rerun.hpp"
#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/glob.hpp"
#include "harness/interrupt.hpp"
#include "harness/orbits/orbit_comparison.hpp"
#include "harness/plan/baseline.hpp"
#include "harness/progress.hpp"
#include "harness/records/run_folder.hpp"
#include "harness/statistics.hpp"
#include "harness/table.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

struct VerifyArguments {
  std::optional<std::string> folder;
  std::optional<std::string> scenes;
  std::string cases = "*";
  OrbitSearchOptions options;
  std::optional<int> subharmonics;
  bool update = false;
};

/// results/references below the current folder or one of those above it.
fs::path default_folder() {
  const fs::path references = fs::path("results") / "references";
  for (fs::path folder = fs::current_path();; folder = folder.parent_path()) {
    if (fs::is_directory(folder / references)) return folder / references;
    if (folder == folder.parent_path()) return references;
  }
}

[[noreturn]] void refuse_folder(const fs::path& folder) {
  throw UsageError(
      fmt::format("dir = {} (must be a folder of references, as verify --update makes it, or of records, as "
                  "run makes it)",
                  folder.string()));
}

void print_lines(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) fmt::print("{}\n", line);
}

std::string name_of(const SceneSource& source) {
  const std::string stem = source.file.stem().string();
  return source.level.empty() ? stem : stem + "@" + source.level;
}

/// True of scenes whose orbits take too long to search unless they are asked for.
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
std::vector<std::string> kept_scenes(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  return names;
}

/// Scenes that ship and those that have a file in the folder, if the filter takes them.
std::vector<std::string> scenes_to_verify(const VerifyArguments& arguments, const fs::path& folder) {
  std::vector<std::string> names, left_out;
  for (const SceneSource& source : shipped_scenes())
    (is_asked_for(source, arguments.scenes) ? names : left_out).push_back(name_of(source));
  if (!arguments.update) {
    const std::vector<std::string> kept = kept_scenes(folder);
    if (kept.empty() && !arguments.scenes) refuse_folder(folder);
    names.insert(names.end(), kept.begin(), kept.end());
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  const std::string filter = arguments.scenes.value_or("*");
  std::erase_if(names, [&](const std::string& name) {
    return !scene_filter_matches(filter, name) ||
           std::find(left_out.begin(), left_out.end(), name) != left_out.end();
  });
  if (names.empty()) {
    throw NothingMatched(fmt::format("scenes = {} (matches no scene; see `signorini list scenes`)", filter));
  }
  return names;
}

/// A search; an incomplete one would prove nothing.
std::optional<OrbitFile> search(const Scene& scene, const OrbitSearchOptions& options,
                                std::vector<std::string>& differences) {
  const SceneOrbits orbits = find_all_orbits(scene.problem, options);
  if (orbits.interrupted) return std::nullopt;
  if (orbits.expired) {
    differences.push_back(fmt::format("{}: the search did not end within {:g} s (--timeout)",
                                      scene.problem.name, options.timeout));
    return std::nullopt;
  }
  return make_orbit_file(scene, options, orbits);
}

void update_scene(const VerifyArguments& arguments, const fs::path& file, const Scene& scene,
                  std::vector<std::string>& differences) {
  OrbitSearchOptions options = arguments.options;
  options.subharmonics = arguments.subharmonics.value_or(default_subharmonics(scene.problem));
  const auto found = search(scene, options, differences);
  if (!found) return;
  const std::string text = print_orbit_file(*found);
  const bool same = fs::exists(file) && read_file(file) == text;
  if (!same) write_whole(file, text);
  fmt::print("{}: {} orbits {}\n", scene.problem.name, found->orbits.size(), same ? "unchanged" : "written");
}

/// A search may miss by bad luck, such as a time limit, what exists: kept orbits of impacts that are not
/// there again are certified from their own events.
void add_missed(const Scene& scene, const OrbitFile& kept, OrbitFile& now) {
  for (const FoundOrbit& orbit : kept.orbits) {
    const auto same = [&](const FoundOrbit& found) {
      return found.order == orbit.order && found.fingerprint == orbit.fingerprint;
    };
    if (std::any_of(now.orbits.begin(), now.orbits.end(), same)) continue;
    auto again = certify_again(scene.problem, orbit);
    if (!again || !same(*again)) continue;
    fmt::print("{}: orbit {} of order {}: not met by the search, certified again from its events\n",
               scene.problem.name, orbit.fingerprint, orbit.order);
    now.orbits.push_back(std::move(*again));
  }
}

void verify_scene(const VerifyArguments& arguments, const fs::path& file, const std::string& name,
                  std::vector<std::string>& differences) {
  if (!fs::exists(file)) {
    differences.push_back(name + ": no orbits are kept for this scene (verify --update keeps them)");
    return;
  }
  const OrbitFile kept = parse_orbit_file(read_file(file), file.string());
  const Scene scene = read_scene(find_scene(name));
  OrbitDifferences result;
  std::vector<std::string> failures;
  if (kept.scene_sha256 != scene.sha256) {  // before the search: it would be in vain
    result = compare_orbits(kept, make_orbit_file(scene, kept.options, {}));
  } else {
    OrbitSearchOptions options = kept.options;
    options.timeout = arguments.options.timeout;
    auto now = search(scene, options, failures);
    if (interrupted()) return;
    if (now) {
      add_missed(scene, kept, *now);
      result = compare_orbits(kept, *now);
    }
  }
  result.differences.insert(result.differences.end(), failures.begin(), failures.end());
  print_lines(result.differences);
  print_lines(result.fresh);
  if (result.differences.empty())
    fmt::print("{}: {} orbits as kept, {} new\n", name, kept.orbits.size(), result.fresh.size());
  differences.insert(differences.end(), result.differences.begin(), result.differences.end());
}

int verify_references(const VerifyArguments& arguments, const fs::path& folder) {
  const std::vector<std::string> names = scenes_to_verify(arguments, folder);
  if (arguments.update) fs::create_directories(folder);
  std::vector<std::string> differences;
  Progress progress(names.size());
  for (const std::string& name : names) {
    if (interrupted()) break;
    progress.begin(name);
    const std::size_t before = differences.size();
    const fs::path file = folder / (name + ".json");
    if (arguments.update) {
      update_scene(arguments, file, read_scene(find_scene(name)), differences);
    } else {
      verify_scene(arguments, file, name, differences);
    }
    if (arguments.update || !fs::exists(file))
      print_lines({differences.begin() + static_cast<std::ptrdiff_t>(before), differences.end()});
    progress.advance();
  }
  if (interrupted()) {
    fmt::print(stderr, "interrupted\n");
    return kInterrupted;
  }
  if (!arguments.update) fmt::print("{} scenes, {} differences\n", names.size(), differences.size());
  return differences.empty() ? kDone : kUnexpectedFailure;
}

/// Ratios of times say something on another machine too, where seconds do not.
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
  fmt::print("\n{}\nTimes are medians over the scenes, reported and not judged.\n", to_markdown(table));
}

int verify_records(const VerifyArguments& arguments, const fs::path& folder) {
  if (arguments.update)
    throw UsageError(fmt::format(
        "dir = {} (must be a folder of references to be updated; `signorini run` makes records anew)",
        folder.string()));
  std::vector<Record> kept = read_current_records(folder);
  const std::string filter = arguments.scenes.value_or("*");
  std::erase_if(kept, [&](const Record& record) { return !scene_filter_matches(filter, record.scene); });
  Progress progress(kept.size());
  const Rerun result = rerun_records(kept, limits_of_run(folder), arguments.cases, method_catalogue(),
                                     [&](const std::string& what) { progress.begin(what); });
  print_lines(result.differences);
  for (const std::string& remark : result.remarks)
    fmt::print("{}: a time limit decided, no difference\n", remark);
  fmt::print("{} cases, {} differences\n", result.cases, result.differences.size());
  if (!result.time_ratios.empty()) {
    fmt::print("time, new over kept: {:.3g} in the median of {} cases\n", median(result.time_ratios),
               result.time_ratios.size());
    print_relative_times(result.relative_times);
  }
  if (result.interrupted) return kInterrupted;
  return result.differences.empty() ? kDone : kUnexpectedFailure;
}

int verify(const VerifyArguments& arguments) {
  const fs::path folder = arguments.folder ? fs::path(*arguments.folder) : default_folder();
  if (!arguments.update && !fs::is_directory(folder)) refuse_folder(folder);
  watch_interrupts();
  return fs::exists(folder / "records.jsonl") ? verify_records(arguments, folder)
                                              : verify_references(arguments, folder);
}

}  // namespace

void add_verify_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand(
      "verify",
      fmt::format(
          "Are the committed results still true? Of a folder of references: searches every scene's "
          "orbits again; each kept orbit must be found, or certified "
          "again from its impacts, its events within {:g} times the sum of both "
          "error bars plus {:g} of a period, with the same multipliers and stability. Of a folder with "
          "records.jsonl: runs the cases again; each must end with the same status and an error of x "
          "within a factor of {:g} or below ten error bars, while times are only reported. Exit code 0 "
          "if all is the same, 1 if not.",
          kErrorBars, kInstantFloor, kErrorFactor));
  const auto arguments = std::make_shared<VerifyArguments>();
  command->add_option("dir", arguments->folder,
                      "folder of references or of a run; results/references here or above if absent");
  command->add_option("--scenes", arguments->scenes,
                      "scenes by glob, A*:B*-C*; levels of families only where it speaks of them, as "
                      "grazing@*; if absent the "
                      "catalogue but for the scenes tagged large or long-search");
  command->add_option("--cases", arguments->cases, "cases of a run by glob on SCENE/METHOD[OPTIONS]")
      ->capture_default_str();
  command->add_flag(
      "--update", arguments->update,
      "search, and keep what is found, instead of comparing; --starts, --subharmonics and --seed "
      "are for this, a comparison searches as the files say");
  add_search_options(*command, arguments->options, arguments->subharmonics);
  command->callback([arguments, &exit_code] { exit_code = verify(*arguments); });
}

}  // namespace signorini
