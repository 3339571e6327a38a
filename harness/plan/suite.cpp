#include "harness/plan/suite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/glob.hpp"
#include "problems/files/kebab_case.hpp"
#include "problems/files/toml_tree.hpp"
#include "problems/scene/scene_field.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> texts(const SceneField& field, std::string_view requirement) {
  std::vector<std::string> values;
  if (!field.given()) return values;
  for (const SceneField& item : field.items(requirement)) values.push_back(item.text(requirement));
  return values;
}

Limits read_limits(const SceneField& field) {
  Limits limits;
  if (!field.given()) return limits;
  field.allow_only({"timeout", "memory", "repetitions", "certificate_timeout", "reference_timeout"},
                   "must be a table");
  const auto seconds = [&](std::string_view key, double& value) {
    if (!field[key].given()) return;
    value = field[key].number("must be a positive number of seconds", 0.0);
    if (value == 0.0) field[key].refuse("must be a positive number of seconds");
  };
  seconds("timeout", limits.timeout);
  seconds("certificate_timeout", limits.certificate_timeout);
  if (const SceneField reference = field["reference_timeout"]; reference.given())
    limits.reference_timeout = reference.number("must be a number of seconds >= 0", 0.0);
  limits.memory_mb = field["memory"].whole_or(limits.memory_mb, "must be a whole number of MiB >= 64", 64,
                                              std::numeric_limits<int>::max());
  limits.repetitions =
      field["repetitions"].whole_or(limits.repetitions, "must be a whole number in 1..1000", 1, 1000);
  return limits;
}

std::vector<ExpectedFailure> read_expected(const SceneField& field) {
  std::vector<ExpectedFailure> expected;
  if (!field.given()) return expected;
  for (const SceneField& item : field.items("must be tables with case and reason")) {
    item.allow_only({"case", "reason"}, "must be a table with case and reason");
    expected.push_back(
        {item["case"].text("must be a glob on case names"), item["reason"].text("must say why")});
  }
  return expected;
}

// A scene as a suite names it: a file by its path from the folder of the suite.
std::string scene_of_suite(std::string word, const fs::path& folder) {
  return looks_like_path(word) ? (folder / word).string() : word;
}

std::vector<SuiteResponse> responses_of_suite(const SceneField& field, const fs::path& folder) {
  std::vector<SuiteResponse> responses;
  if (!field.given()) return responses;
  for (const SceneField& item : field.items("must be tables with scene, from and to")) {
    item.allow_only({"scene", "from", "to", "hz", "orders"},
                    "must be a table with scene, from, to, hz and orders");
    const bool hertz = item["hz"].given() && item["hz"].truth("must be true or false");
    const double unit = hertz ? 2.0 * std::numbers::pi : 1.0;
    SuiteResponse response{.scene = scene_of_suite(item["scene"].text("must be a scene"), folder),
                           .from = unit * item["from"].number("must be a positive frequency", 0.0),
                           .to = unit * item["to"].number("must be a positive frequency", 0.0),
                           .orders = item["orders"].whole_or(2, "must be a whole number in 1..12", 1, 12)};
    if (response.from == 0.0) item["from"].refuse("must be a positive frequency");
    if (response.to == 0.0 || response.to == response.from)
      item["to"].refuse("must be a positive frequency other than from");
    if (std::ranges::any_of(responses, [&](const auto& other) { return other.scene == response.scene; }))
      item["scene"].refuse("must be listed once");
    responses.push_back(std::move(response));
  }
  return responses;
}

}  // namespace

Suite parse_suite(std::string_view text, const std::string& file) {
  const TomlNode document = parse_toml(text, file);
  const SceneField root(document, file);
  if (root["system"].given())
    root["system"].refuse("must not be there: a scene is no suite; give it to --scenes");
  static_cast<void>(root["schema"].whole("must be 1", 1, 1));  // first: another schema may have other keys
  root.allow_only({"schema", "name", "title", "scenes", "tags", "without_tags", "methods", "limits",
                   "expected_failure", "response", "by_steps", "instances"},
                  "must be a table");
  const fs::path folder = fs::path(file).parent_path();
  Suite suite;
  suite.name = root["name"].text("must be a name in lower-kebab-case");
  if (!is_lower_kebab_case(suite.name)) root["name"].refuse("must be a name in lower-kebab-case");
  suite.title = root["title"].text("must be one line of text");
  for (std::string& word : texts(root["scenes"], "must be a list of globs on scene names, and scene files")) {
    (looks_like_path(word) ? suite.files : suite.scenes).push_back(scene_of_suite(std::move(word), folder));
  }
  suite.tags = texts(root["tags"], "must be a list of tags");
  suite.without_tags = texts(root["without_tags"], "must be a list of tags");
  suite.responses = responses_of_suite(root["response"], folder);
  suite.by_steps = texts(root["by_steps"], "must be a list of name[key=value|value]");
  if (suite.responses.empty() && suite.scenes.empty() && suite.files.empty() && suite.tags.empty()) {
    root["scenes"].refuse("must be a list of globs on scene names, and scene files, unless tags are given");
  }
  suite.instances = root["instances"].whole_or(
      0, fmt::format("must be a whole number in 0..{}", kMostInstances), 0, kMostInstances);
  suite.methods = texts(root["methods"], "must be a list of name[key=value|value]");
  suite.limits = read_limits(root["limits"]);
  suite.expected_failures = read_expected(root["expected_failure"]);
  return suite;
}

Suite load_suite(const std::string& name_or_path) {
  const bool is_path = looks_like_path(name_or_path);
  const fs::path path =
      is_path ? fs::path(name_or_path) : problems_folder() / "suites" / (name_or_path + ".toml");
  std::error_code ignored;
  if (is_path && !fs::exists(path, ignored))
    throw UsageError("suite = {} (must exist: there is no such file)", name_or_path);
  if (!fs::is_regular_file(path, ignored)) {
    std::string names;
    for (const fs::path& suite : shipped_files("suites"))
      names += (names.empty() ? "" : ", ") + suite.stem().string();
    throw UsageError("suite = {} (must be a TOML file or one of {})", name_or_path, names);
  }
  return parse_suite(read_file(path, kLargestScene), path.string());
}

}  // namespace signorini
