#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "harness/extend/plugins/curve_exchange.hpp"
#include "harness/files.hpp"
#include "harness/records/json_fields.hpp"
#include "problems/files/toml_tree.hpp"

namespace signorini {

namespace {

using Represents = std::function<std::optional<RepresentedLaw>(const Law&)>;

class RecordedCurves final : public Method, public CurveMethod {
 public:
  RecordedCurves(std::shared_ptr<const std::vector<ExchangedBranch>> branches, Represents represents)
      : branches_(std::move(branches)), represents_(std::move(represents)) {}

  [[nodiscard]] std::vector<OptionEcho> options() const override { return {}; }
  [[nodiscard]] Support supports(const Problem& /*problem*/) const override {
    return {false, "a file of branches has no solves"};
  }
  [[nodiscard]] RepresentedLaw law(const Problem& problem) const override {
    return represents_(problem.law()).value_or(Undetermined{});
  }
  [[nodiscard]] std::unique_ptr<PreparedMethod> prepare(const Problem& problem) const override {
    throw std::runtime_error(supports(problem).reason);
  }
  [[nodiscard]] const CurveMethod* curve() const override { return this; }

  [[nodiscard]] Support follows(const ParametrisedScene& scene) const override {
    const Problem problem = scene.at(scene.from);
    if (scene.parameter != kFrequency) return {false, "its curves are over the frequency of the load"};
    if (!represents_(problem.law())) return {false, "its description names no law for this scene's"};
    if (std::ranges::find(*branches_, problem.name, &ExchangedBranch::scene) == branches_->end())
      return {false, fmt::format("its file has no branch of {}", problem.name)};
    return {};
  }

  [[nodiscard]] BranchDiagram follow(const ParametrisedScene& scene,
                                     const CurveLimits& limits) const override {
    const Problem problem = scene.at(scene.from);
    ExchangedCurve curve;
    std::ranges::copy_if(*branches_, std::back_inserter(curve.branches),
                         [&](const ExchangedBranch& branch) { return branch.scene == problem.name; });
    try {
      return diagram_of(curve, scene, problem.contact_count(), limits);
    } catch (const BadRecord& error) {
      return {
          .branches = {}, .unfinished = fmt::format("its file of branches: {}", error.what()), .notes = {}};
    }
  }

 private:
  std::shared_ptr<const std::vector<ExchangedBranch>> branches_;
  Represents represents_;
};

}  // namespace

std::vector<ExchangedBranch> read_branches(const std::filesystem::path& file) {
  std::istringstream lines(read_file(file));
  std::vector<ExchangedBranch> branches;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const auto refuse = [&](std::string what) {
      throw SceneError(fmt::format("{}:{}: {}", file.string(), number, one_line(std::move(what), 200)));
    };
    try {
      branches.push_back(branch_from_line(line));
    } catch (const nlohmann::json::exception& error) {
      const std::string what = error.what();  // "[json.exception...] key 'points' not found"
      refuse(what.substr(what.find("] ") + 2));
    } catch (const BadRecord& error) {
      refuse(error.what());
    }
  }
  return branches;
}

std::unique_ptr<Method> method_of_branches(std::shared_ptr<const std::vector<ExchangedBranch>> branches,
                                           Represents represents) {
  return std::make_unique<RecordedCurves>(std::move(branches), std::move(represents));
}

}  // namespace signorini
