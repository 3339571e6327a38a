#include "harness/plan/scene_choice.hpp"

#include <fmt/format.h>
#include <glob.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/glob.hpp"
#include "harness/text/words.hpp"
#include "problems/files/close_names.hpp"
#include "problems/scene/scene_layout.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

bool is_folder(const std::string& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

NothingMatched no_file(const std::string& path, const char* why) {
  return NothingMatched("scenes = {} ({})", path, why);
}

std::vector<fs::path> toml_files_in(const std::string& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  if (files.empty()) throw no_file(folder, "must hold TOML files: there is none");
  std::ranges::sort(files);
  return files;
}

/// By glob(3), which sorts.
std::vector<fs::path> files_matching(const std::string& pattern) {
  glob_t found{};
  const int failed = glob(pattern.c_str(), 0, nullptr, &found);
  const std::vector<fs::path> files(found.gl_pathv, found.gl_pathv + (failed == 0 ? found.gl_pathc : 0));
  globfree(&found);
  if (files.empty()) throw no_file(pattern, "matches no file");
  return files;
}

/// The scene of a file, or those of its levels where it is a family.
void add_scenes_of(const fs::path& file, std::vector<SceneSource>& sources) {
  std::vector<std::string> levels = load_levels(file);
  if (levels.empty()) sources.emplace_back(file);
  for (std::string& level : levels) sources.emplace_back(file, std::move(level));
}

/// What makes a scene that scene: its text, its level, the contents of its files.
template <class Variant>  // what has a family and an instance
std::string scene_digest(std::string identity, const Variant& scene, const std::vector<fs::path>& files) {
  if (scene.family) identity += "@" + level_label(scene.family->level);  // however the level was spelt
  if (scene.instance) identity += "@" + instance_label(scene.instance->seed, scene.instance->number);
  for (const fs::path& file : files) identity += "\n" + sha256_of_file(file);
  return sha256(identity);
}

/// Whether a scene that ships is one of the suite.
bool belongs(const Suite& suite, const SceneHeader& scene) {
  const auto named = [&](const std::string& glob) { return scene_glob_match(glob, scene.name); };
  const auto carried = [&](const std::string& tag) { return scene.carries(tag); };
  if (std::ranges::any_of(suite.without_tags, carried)) return false;
  return std::ranges::any_of(suite.scenes, named) || std::ranges::any_of(suite.tags, carried);
}

struct Candidate {
  SceneSource source;
  std::string name;
  bool of_suite = true;
};

/// A source, or the instances that are asked for where it has ranges.
std::vector<SceneSource> drawn(const SceneSource& source, const Instances& instances) {
  if (instances.count == 0 || !source.level.empty() || !offers_instances(source.file)) return {source};
  std::vector<SceneSource> sources;
  for (int number = 1; number <= instances.count; ++number)
    sources.emplace_back(source.file, instance_label(instances.seed, number));
  return sources;
}

/// The scenes of a suite, files of its own, then those that ship, of which the suite's own stand first.
std::vector<Candidate> candidates_of(const Suite& suite, std::span<const SceneSource> sources,
                                     const Instances& instances) {
  std::vector<Candidate> candidates, others;
  for (const std::string& file : suite.files) {
    for (const SceneSource& written : scene_files(file)) {
      for (const SceneSource& source : drawn(written, instances))
        candidates.push_back({source, load_header(source).name});
    }
  }
  for (const SceneSource& source : sources) {
    const SceneHeader header = load_header(source);  // first: a large scene takes time to assemble
    const bool of_suite = belongs(suite, header);
    if (of_suite || suite.responses.empty())  // else a name is that of a response
      (of_suite ? candidates : others).push_back({source, header.name, of_suite});
  }
  std::ranges::move(others, std::back_inserter(candidates));
  return candidates;
}

/// Leaves, of the candidates that are not of the suite, those that a glob asks for which takes none of the
/// suite's. \throws NothingMatched for the first glob that takes none at all
void keep_asked(const SceneFilter& filter, std::vector<Candidate>& candidates, const Suite& suite) {
  const auto suite_ends = std::ranges::find(candidates, false, &Candidate::of_suite);
  const auto taken_by = [](const std::string& glob) {
    return [&glob](const Candidate& candidate) { return scene_glob_match(glob, candidate.name); };
  };
  std::vector<std::string> elsewhere;
  for (const std::string& glob : filter.globs()) {
    if (std::any_of(candidates.begin(), suite_ends, taken_by(glob))) continue;
    elsewhere.push_back(glob);
    if (std::any_of(suite_ends, candidates.end(), taken_by(glob))) continue;
    std::vector<std::string> names;
    for (const Candidate& candidate : candidates) names.push_back(candidate.name);
    throw NothingMatched(
        "scenes = {} (matches no scene of suite {} and none that ships{}; see `signorini list "
        "scenes`)",
        glob, suite.name, suggestion(glob, names));
  }
  candidates.erase(std::remove_if(suite_ends, candidates.end(),
                                  [&](const Candidate& candidate) {
                                    return std::ranges::none_of(elsewhere, [&](const std::string& glob) {
                                      return scene_glob_match(glob, candidate.name);
                                    });
                                  }),
                   candidates.end());
}

void require_distinct(const std::vector<Scene>& scenes) {
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (scenes[i].problem.name != scenes[k].problem.name) continue;
      throw UsageError("scenes = {} (must have another name than {}: both are named {})", scenes[i].word,
                       scenes[k].word, scenes[i].problem.name);
    }
  }
}

}  // namespace

Scene read_scene(const SceneSource& source) {
  const std::string name = source.file.string();
  const std::string text = read_file(source.file, kLargestScene);
  // Read once, so that the hash is of what was parsed.
  SceneWithSources scene = parse_scene_with_sources(text, name, source.level);
  std::string digest = scene_digest(text, scene, scene.files);
  std::string word = name + (source.level.empty() ? "" : "@" + source.level);
  return {.problem = std::move(scene.problem),
          .sha256 = std::move(digest),
          .family = std::move(scene.family),
          .instance = std::move(scene.instance),
          .sampled_loads = std::move(scene.sampled_loads),
          .word = std::move(word)};
}

std::string digest_of(const SceneSource& source) {
  return scene_digest(read_file(source.file, kLargestScene), load_header(source), load_outline(source).files);
}

bool names_path(const std::string& word) {
  if (looks_like_path(word)) return true;
  return is_folder(word) && !fs::exists(problems_folder() / "catalogue" / (word + ".toml"));
}

std::vector<SceneSource> scene_files(const std::string& path) {
  std::vector<SceneSource> sources;
  std::error_code ignored;
  if (is_folder(path)) {
    for (const fs::path& file : toml_files_in(path)) add_scenes_of(file, sources);
  } else if (!fs::exists(path, ignored) && path.find_first_of("*?[") != std::string::npos) {
    for (const fs::path& file : files_matching(path)) add_scenes_of(file, sources);
  } else if (const SceneSource source = find_scene(path); !source.level.empty()) {
    sources.push_back(source);
  } else {
    add_scenes_of(source.file, sources);
  }
  return sources;
}

SceneFilter::SceneFilter(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    bool leaving_out = false;
    for (std::size_t begin = 0; begin <= word.size();) {
      const std::size_t end = std::min(word.find(':', begin), word.size());
      const std::string piece = word.substr(begin, end - begin);
      begin = end + 1;
      if (piece.empty()) continue;
      if (!leaving_out && names_path(piece)) {
        for (const SceneSource& file : scene_files(piece)) {
          if (std::ranges::find(files_, file) == files_.end()) files_.push_back(file);
        }
        continue;
      }
      if (leaving_out) {
        left_out_.push_back(piece);
        continue;
      }
      GlobPieces globs = split_globs(piece);
      leaving_out = !globs.negative.empty();
      // "-B*" alone takes all else; after a path it takes nothing.
      if (piece.starts_with('-') && !files_.empty()) globs.positive.clear();
      std::ranges::move(globs.positive, std::back_inserter(globs_));
      std::ranges::move(globs.negative, std::back_inserter(left_out_));
    }
  }
}

bool SceneFilter::leaves_out(std::string_view name) const {
  return std::ranges::any_of(left_out_,
                             [&](const std::string& glob) { return scene_glob_match(glob, name); });
}

bool SceneFilter::takes(std::string_view name) const {
  if (leaves_out(name)) return false;
  if (globs_.empty()) return files_.empty();
  return std::ranges::any_of(globs_, [&](const std::string& glob) { return scene_glob_match(glob, name); });
}

std::size_t count_scenes(const Suite& suite, std::span<const SceneSource> sources) {
  const std::vector<Candidate> candidates = candidates_of(suite, sources, {.count = suite.instances});
  return static_cast<std::size_t>(std::ranges::count(candidates, true, &Candidate::of_suite));
}

std::vector<Scene> choose_scenes(const Suite& suite, const std::vector<std::string>& words,
                                 std::span<const SceneSource> sources, const Instances& instances) {
  const SceneFilter filter(words);
  std::vector<Scene> scenes;
  for (const SceneSource& file : filter.files()) {
    if (filter.leaves_out(load_header(file).name)) continue;
    for (const SceneSource& source : drawn(file, instances)) scenes.push_back(read_scene(source));
  }
  if (words.empty() || !filter.globs().empty() || filter.files().empty()) {
    std::vector<Candidate> candidates = candidates_of(suite, sources, instances);
    keep_asked(filter, candidates, suite);
    const bool has_files = !suite.files.empty();
    for (const Candidate& candidate : candidates) {
      if (!filter.takes(candidate.name)) continue;
      scenes.push_back(read_scene(candidate.source));
      const bool ships = !has_files || std::ranges::find(sources, candidate.source) != sources.end();
      if (ships) scenes.back().word = candidate.name;
    }
  }
  if (scenes.empty()) {
    throw NothingMatched(
        words.empty()
            ? fmt::format("suite = {} (must have scenes: what it asks for matches none)", suite.name)
            : fmt::format("scenes = {} (leaves no scene of suite {})", joined(words, " "), suite.name));
  }
  require_distinct(scenes);
  return scenes;
}

}  // namespace signorini
