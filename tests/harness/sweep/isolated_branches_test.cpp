#include "harness/sweep/isolated_branches.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "harness/failure.hpp"
#include "harness/sweep/branch_json.hpp"
#include "methods/curve.hpp"
#include "problems/files/toml_tree.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini::isolated_branches_test {
namespace {

enum class Flaw { crash, no_order, raw_note, never_applies };

/// A method that hands over one branch, then ends its process or hands over one that is none; or does not
/// apply.
class LateFailure final : public Method, public CurveMethod {
 public:
  explicit LateFailure(Flaw flaw) : flaw_(flaw) {}
  [[nodiscard]] std::vector<OptionEcho> options() const override { return {}; }
  [[nodiscard]] Support supports(const Problem& /*problem*/) const override {
    const bool applies = flaw_ != Flaw::never_applies;
    return {.ok = applies, .reason = applies ? "" : "it never does"};
  }
  [[nodiscard]] RepresentedLaw law(const Problem& /*problem*/) const override { return Restitution{1.0}; }
  [[nodiscard]] std::unique_ptr<PreparedMethod> prepare(const Problem& /*problem*/) const override {
    throw std::runtime_error("no single solves");
  }
  [[nodiscard]] const CurveMethod* curve() const override { return this; }
  [[nodiscard]] Support follows(const ParametrisedScene& scene) const override {
    return supports(scene.at(scene.from));
  }
  [[nodiscard]] BranchDiagram follow(const ParametrisedScene& scene,
                                     const CurveLimits& limits) const override {
    Branch branch{.began = "here", .ended = "there"};
    for (const double frequency : {scene.from, scene.to})
      branch.points.push_back({.parameter = frequency, .frequency = frequency, .amplitude = {1.0}});
    limits.take(branch);
    if (flaw_ == Flaw::crash) std::raise(SIGSEGV);
    if (flaw_ == Flaw::raw_note)
      return {.branches = {branch}, .unfinished = "\x1b[2J", .notes = {"\x1b[31mred\n"}};
    branch.points.front().order = 0;
    limits.take(branch);
    return {};
  }

 private:
  Flaw flaw_;
};

MethodEntry late_failure(Flaw flaw) {
  MethodEntry entry;
  entry.name = "late-failure";
  entry.make = [flaw](std::span<const OptionSetting>) { return std::make_unique<LateFailure>(flaw); };
  return entry;
}

ParametrisedScene scene_of(double e = 1.0) { return over_frequency(test::one_mass(0.2, e), 2.3, 2.6); }

TEST(IsolatedBranches, AreThoseOfTheMethod) {
  const MethodChoice choice{&find_method("fourier-lipschitz"), {{"harmonics", "5"}}};
  std::size_t taken = 0;
  CurveLimits limits{.max_order = 1};
  limits.take = [&](const Branch&) { ++taken; };
  const IsolatedBranches found = isolated_branches(scene_of(), choice, limits).value();
  const BranchDiagram own = branches_of(scene_of(), choice, {.max_order = 1}).value();
  EXPECT_EQ(found.failure, "");
  ASSERT_EQ(found.diagram.branches.size(), own.branches.size());
  EXPECT_EQ(taken, own.branches.size());
  for (std::size_t i = 0; i < own.branches.size(); ++i)
    EXPECT_EQ(to_json(found.diagram.branches[i], "m").dump(), to_json(own.branches[i], "m").dump());
  EXPECT_EQ(found.diagram.notes, own.notes);
}

TEST(IsolatedBranches, OfAMethodThatCrashesAreThoseThatHadArrived) {
  const MethodEntry entry = late_failure(Flaw::crash);
  const IsolatedBranches found = isolated_branches(scene_of(), {&entry}, {}).value();
  EXPECT_EQ(found.diagram.branches.size(), 1U);
  EXPECT_TRUE(found.failure.starts_with("late-failure: signal 11")) << found.failure;
  EXPECT_EQ(found.diagram.unfinished, found.failure);
}

TEST(IsolatedBranches, LeaveOutOneThatIsNone) {
  const MethodEntry entry = late_failure(Flaw::no_order);
  const IsolatedBranches found = isolated_branches(scene_of(), {&entry}, {}).value();
  EXPECT_EQ(found.diagram.branches.size(), 1U);
  EXPECT_TRUE(found.failure.starts_with("late-failure: invalid branch: order = 0")) << found.failure;
}

TEST(IsolatedBranches, HaveNotesThatDoNothingToATerminal) {
  const MethodEntry entry = late_failure(Flaw::raw_note);
  const IsolatedBranches found = isolated_branches(scene_of(), {&entry}, {}).value();
  ASSERT_EQ(found.diagram.notes.size(), 1U);
  for (const std::string& text : {found.diagram.notes.front(), found.diagram.unfinished})
    EXPECT_FALSE(has_control_characters(text)) << text.size();
}

TEST(IsolatedBranches, AreNoneWithoutACurveAndRefusedWhereTheMethodDoesNotApply) {
  EXPECT_FALSE(isolated_branches(scene_of(), {&find_method("event-driven")}, {}).has_value());
  const MethodEntry entry = late_failure(Flaw::never_applies);
  EXPECT_THROW(static_cast<void>(isolated_branches(scene_of(), {&entry}, {})), UsageError);
}

TEST(LawRemarkOf, NamesALawThatIsNotTheScenes) {
  const MethodChoice series{&find_method("fourier-lipschitz")};
  EXPECT_EQ(law_remark_of(test::one_mass_scene(0.2, 0.8), series), "e = 1");
  EXPECT_EQ(law_remark_of(test::one_mass_scene(0.2, 1.0), series), "");
}

}  // namespace
}  // namespace signorini::isolated_branches_test
