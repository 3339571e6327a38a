// The two examples, built and run from the installed tree, judged like any method.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>

#include "tests/plugin/installed_program.hpp"
#include "tests/support/other_programs.hpp"

namespace signorini::test::examples_test {
namespace {

std::string moreau_jean() {
  return " --plugin " + (installed_tree() / "moreau_jean" / "moreau_jean.so").string();
}

std::string command_aft() {
  return " --plugin " + (installed_tree() / "prefix" / "share" / "signorini" / "examples" / "command_aft" /
                         "command_aft.toml")
                            .string();
}

/// Debian's Python has its numpy, whatever other Python comes first.
constexpr const char* kPath = "PATH=/usr/bin:$PATH";

bool python_has_numpy() {
  return succeeds(fmt::format("{} python3 -c 'import numpy; numpy.zeros(1)'", kPath));
}

constexpr std::array kScenes{"chain2-stop", "chain2-stop-e05", "sdof-stop-e0", "sdof-stop-e05",
                             "sdof-stop-e08"};
constexpr std::array kSteps{128, 256, 512, 1024, 2048, 4096};

/// Order of convergence of the scenes' geometric mean of a measure, by least squares over kSteps.
double order_of(const std::map<std::string, Record>& records,
                const std::function<Measure(const Record&)>& measure) {
  double products = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < kSteps.size(); ++i) {
    double mean = 0.0;  // of logarithms
    for (const char* scene : kScenes)
      mean += std::log(*measure(records.at(fmt::format("{}/moreau-jean[steps={}]", scene, kSteps[i])))) /
              kScenes.size();
    const double level = static_cast<double>(i) - 0.5 * (kSteps.size() - 1);
    products += level * mean;
    squares += level * level * std::log(2.0);
  }
  return -products / squares;
}

// Where an impact falls within its step scatters the error of one scene; the energy that is missed does not.
TEST(MoreauJean, FindsCertifiedOrbitsAtFirstOrderInTheStep) {
  const TemporaryFolder folder;
  const Outcome run =
      run_installed(folder, fmt::format("run catalogue --scenes {} --methods 'moreau-jean[steps={}]' "
                                        "--repetitions 1 --out run{}",
                                        fmt::join(kScenes, ":"), fmt::join(kSteps, "|"), moreau_jean()));
  EXPECT_EQ(run.code, 0) << run.err;
  const std::map<std::string, Record> records = records_in(folder.path() / "run");
  ASSERT_EQ(records.size(), kScenes.size() * kSteps.size());
  for (const auto& [name, record] : records) {
    EXPECT_EQ(record.status, Status::converged) << name << ": " << record.message;
    // The finest is certified; a coarse one may be near its orbit only.
    const bool finest = name.find(fmt::format("steps={}]", kSteps.back())) != std::string::npos;
    EXPECT_TRUE(claim_of(record) == Claim::certified || !finest) << name << ": " << record.certificate.reason;
    EXPECT_TRUE(record.law_matches_scene.value_or(false)) << name;
    ASSERT_TRUE(record.errors.x_l2 && record.physics.energy_defect) << name;
  }
  const double order = order_of(records, [](const Record& record) { return record.errors.x_l2; });
  EXPECT_GT(order, 0.8);
  EXPECT_LT(order, 1.3);
  const double of_energy =
      order_of(records, [](const Record& record) { return record.physics.energy_defect; });
  EXPECT_GT(of_energy, 0.9);
  EXPECT_LT(of_energy, 1.2);
}

TEST(MoreauJean, DoesNotApplyToSpringsAndToContactsWithoutMass) {
  const TemporaryFolder folder;
  for (const char* scene : {"sdof-penalty-soft", "chain3-massless"}) {
    const Outcome solve =
        run_installed(folder, fmt::format("solve {} --method moreau-jean{}", scene, moreau_jean()));
    EXPECT_NE(solve.out.find("not-applicable"), std::string::npos) << solve.out;
  }
}

// As it was written by `new method begun-outside --out-of-tree`.
TEST(BegunOutside, PassesItsReviewAtOnce) {
  const TemporaryFolder folder;
  const std::string plugin = " --plugin " + (installed_tree() / "begun" / "begun-outside.so").string();
  const Outcome review = run_installed(folder, "check" + plugin);
  EXPECT_EQ(review.code, 0) << review.out << review.err;
  EXPECT_NE(review.out.find("begun-outside"), std::string::npos) << review.out;
  const Outcome solved = run_installed(folder, "solve sdof-far-stop --method begun-outside" + plugin);
  EXPECT_EQ(solved.code, 0) << solved.err;
}

TEST(CommandAft, IsJudgedAsTheMethodOfTheProgramThatSolvesTheSameEquations) {
  if (!python_has_numpy()) GTEST_SKIP() << "python3 with numpy is not installed";
  struct Pair {
    const char *scene, *settings;
  };
  for (const auto& [scene, settings] : {Pair{"sdof-penalty-soft", ",law=penalty"},
                                        {"sdof-stop", ",c=1932.020041"},  // 4 / |C_H|
                                        {"sdof-far-stop", ""}}) {
    const TemporaryFolder folder;
    const std::string twin = fmt::format("aft-hbm[harmonics=10,quadrature=sampled,samples=320{}]", settings);
    const Outcome run = run_installed(
        folder,
        fmt::format(
            "run catalogue --scenes {} --repetitions 1 --out run --methods 'command-aft[harmonics=10]:{}'{}",
            scene, twin, command_aft()),
        kPath);
    EXPECT_EQ(run.code, 0) << run.err;
    const std::map<std::string, Record> records = records_in(folder.path() / "run");
    const Record& ours = records.at(fmt::format("{}/command-aft[harmonics=10]", scene));
    const Record& theirs = records.at(fmt::format("{}/{}", scene, twin));
    EXPECT_EQ(ours.status, Status::converged) << ours.message;
    EXPECT_EQ(ours.certificate.status, theirs.certificate.status) << ours.certificate.reason;
    EXPECT_EQ(ours.certificate.orbit, theirs.certificate.orbit) << scene;
    ASSERT_TRUE(ours.errors.x_l2 && theirs.errors.x_l2) << scene;
    EXPECT_NEAR(*ours.errors.x_l2, *theirs.errors.x_l2, 1e-3 * *theirs.errors.x_l2 + 1e-10) << scene;
    EXPECT_EQ(ours.seconds.has_value(), theirs.seconds.has_value());
  }
}

}  // namespace
}  // namespace signorini::test::examples_test
