#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "harness/extend/plugins/curve_exchange.hpp"
#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/pack/archive.hpp"
#include "harness/pack/run_pack.hpp"
#include "harness/plan/plan.hpp"
#include "harness/plan/suite.hpp"
#include "harness/records/json_fields.hpp"
#include "harness/run_folder/run_folder.hpp"
#include "methods/catalogue.hpp"
#include "methods/options.hpp"
#include "problems/files/toml_tree.hpp"
#include "tests/attack/untrusted_checks.hpp"

namespace signorini::test {

namespace {

/// Manifest, plan and records, one behind the other, as the files of a pack.
std::string pack_of(std::string_view text) {
  constexpr char kBetween = '\x1e';  // the separator of records, of ASCII
  std::vector<ArchivedFile> files{{.name = "SHA256SUMS"}};
  for (const char* name : {"manifest.json", "plan.txt", "records.jsonl"}) {
    const std::size_t end = std::min(text.find(kBetween), text.size());
    files.push_back({.name = name, .text = std::string(text.substr(0, end))});
    files.front().text += sha256(files.back().text) + "  " + name + "\n";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return gzipped(write_tar(files));
}

/// The pack of what is in a pack.
std::string packed_again(const std::string& pack) {
  const MemoryFile file(pack);
  const OpenedRun opened(file.path());
  return pack_run(read_run(opened.folder()));
}

void require_finite(const SolutionPoint& point) {
  const auto finite = [](double number) { return std::isfinite(number); };
  require(finite(point.frequency) && finite(point.parameter) && point.motion.allFinite() &&
              std::ranges::all_of(point.amplitude, finite) && std::ranges::all_of(point.x_max, finite),
          "points of a curve are finite");
}

}  // namespace

bool attack_archive(std::string_view text) {
  try {
    const std::vector<ArchivedFile> files = read_tar(text);
    const std::vector<ArchivedFile> again = read_tar(gunzipped(gzipped(write_tar(files)), 2 * text.size()));
    require(std::ranges::equal(files, again, {}, &ArchivedFile::text, &ArchivedFile::text) &&
                std::ranges::equal(files, again, {}, &ArchivedFile::name, &ArchivedFile::name),
            "an archive that is written reads the same");
    return true;
  } catch (const BadArchive& refusal) {
    require_one_line(refusal.what());
    return false;
  }
}

bool attack_pack(std::string_view text) {
  // It is unpacked into files, thousands of times: in memory, where the machine has such a place.
  static const bool in_memory = access("/dev/shm", W_OK) == 0 && setenv("TMPDIR", "/dev/shm", 1) == 0;
  static_cast<void>(in_memory);
  try {
    const std::string once = packed_again(pack_of(text));
    require(packed_again(once) == once, "a pack that is packed again is the same");
    return true;
  } catch (const UsageError& refusal) {
    require_one_line(refusal.what());
    return false;
  }
}

bool attack_options(std::string_view text) {
  try {
    for (const MethodChoice& choice : select_methods(text, method_catalogue())) {
      for (const OptionEcho& option : choice.options())
        if (const auto* number = std::get_if<double>(&option.value))
          require(!std::isnan(*number), "the value of an option is a number");
      if (choice.settings.empty()) continue;
      const std::vector<MethodChoice> again = select_methods(choice.label(), method_catalogue());
      require(again.size() == 1 && again.front().settings == choice.settings, "a label names its settings");
    }
    return true;
    // Each quotes what it was given, which the command line prints in one line.
  } catch (const InvalidOption&) {
  } catch (const NothingMatched&) {
  } catch (const UsageError&) {
  }
  return false;
}

bool attack_curves(std::string_view text) {
  constexpr double kFrom = 1.0, kTo = 4.0;  // [rad/s]
  const ParametrisedScene scene = over_frequency(answered_problem(), kFrom, kTo);
  const CurveLimits limits{.max_branches = 10, .max_points = 100, .phases = 8, .at = {2.0}};
  try {
    const ExchangedCurve curve{.branches = read_branches(MemoryFile(text).path())};
    const BranchDiagram diagram = diagram_of(curve, scene, answered_problem().contact_count(), limits);
    require(std::ssize(diagram.branches) <= limits.max_branches, "no more branches than asked for");
    for (const Branch& branch : diagram.branches) {
      for (const SolutionPoint& point : branch.points) require_finite(point);
      for (const SpecialPoint& special : branch.special) {
        require_finite(special.point);
        require(special.after <= branch.points.size(), "special points stand between points");
      }
    }
    return true;
  } catch (const BadRecord& refusal) {  // told in one line, as `unfinished`
    require(!std::string(refusal.what()).empty(), "a refusal has a text");
    return false;
  } catch (const SceneError& refusal) {
    require_one_line(refusal.what());
    return false;
  }
}

bool attack_suite(std::string_view text) {
  try {
    const Suite suite = parse_suite(text, "attack.toml");
    require(!suite.name.empty(), "a suite has a name");
    for (const double seconds : {suite.limits.timeout, suite.limits.certificate_timeout})
      require(std::isfinite(seconds) && seconds > 0.0, "limits of time are positive");
    require(suite.limits.memory_mb > 0 && suite.limits.repetitions > 0, "limits are positive");
    for (const SuiteResponse& response : suite.responses)
      require(std::isfinite(response.from) && std::isfinite(response.to), "intervals are finite");
    return true;
  } catch (const SceneError& refusal) {
    require_one_line(refusal.what());
    return false;
  }
}

}  // namespace signorini::test
