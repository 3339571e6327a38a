// Programs that we did not write, behind the plugin interface: their adapters give what the programs find.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/plugin/installed_program.hpp"
#include "tests/support/other_programs.hpp"

namespace signorini::test::rivals_test {
namespace {

namespace fs = std::filesystem;

fs::path siconos() { return installed_tree() / "siconos" / "siconos_rivals.so"; }

std::string rival(const char* file) {
  return (installed_tree() / "prefix/share/signorini/examples/rivals" / file).string();
}

// Records of these methods on these scenes, by case; every run ends well.
std::map<std::string, Record> records_of(const std::string& scenes, const std::string& methods,
                                         const std::string& plugins, const std::string& before = "") {
  const TemporaryFolder folder;
  const Outcome run = run_installed(
      folder,
      fmt::format("run catalogue --scenes {} --methods '{}' --repetitions 1 --timeout 60 --out run{}", scenes,
                  methods, plugins),
      before);
  EXPECT_EQ(run.code, 0) << run.err;
  return records_in(folder.path() / "run");
}

class Siconos : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(siconos()))
      GTEST_SKIP() << "Siconos is not installed whole (libsiconos-kernel-dev, libsiconos-numerics-dev)";
  }
};

// The same scheme written twice, by strangers: the same grid motion, to the tolerance of its repetition.
TEST_F(Siconos, StepsAsTheExampleThatWeWroteDoes) {
  const std::string ours = " --plugin " + (installed_tree() / "moreau_jean" / "moreau_jean.so").string();
  const auto records = records_of(
      "sdof-stop-e05:sdof-stop-e08:chain2-stop-e05",
      "siconos-moreau-jean[steps=500,tolerance=1e-9]:moreau-jean[steps=500,depth=0,tolerance=1e-9]",
      " --plugin " + siconos().string() + ours);
  ASSERT_EQ(records.size(), 6U);
  for (const char* scene : {"sdof-stop-e05", "sdof-stop-e08", "chain2-stop-e05"}) {
    const Record& theirs = records.at(fmt::format("{}/siconos-moreau-jean[steps=500,tolerance=1e-9]", scene));
    const Record& example =
        records.at(fmt::format("{}/moreau-jean[steps=500,depth=0,tolerance=1e-9]", scene));
    ASSERT_TRUE(theirs.errors.x_l2 && example.errors.x_l2) << theirs.message << example.message;
    EXPECT_NEAR(*theirs.errors.x_l2, *example.errors.x_l2, 1e-3 * *example.errors.x_l2) << scene;
    ASSERT_TRUE(theirs.errors.impulse && example.errors.impulse);
    EXPECT_NEAR(*theirs.errors.impulse, *example.errors.impulse, 1e-3 * *example.errors.impulse) << scene;
  }
}

TEST_F(Siconos, FindsCertifiedOrbitsByEvents) {
  const auto records = records_of("sdof-stop-e05:sdof-stop-e0:sdof-two-sided-e08:chain2-stop-e05",
                                  "siconos-event-driven[tolerance=1e-8]", " --plugin " + siconos().string());
  ASSERT_EQ(records.size(), 4U);
  for (const auto& [name, record] : records) {
    EXPECT_EQ(claim_of(record), Claim::certified) << name << ": " << record.certificate.reason;
    ASSERT_TRUE(record.errors.x_l2) << name << record.message;
    EXPECT_LT(*record.errors.x_l2, 1e-6) << name;
  }
}

// One complementarity problem, two solvers.
TEST_F(Siconos, SolvesTheComplementarityProblemOfHatLcp) {
  const auto records =
      records_of("sdof-stop:chain2-stop-e05:sdof-penalty-soft",
                 "siconos-hat-lcp[samples=128]:hat-lcp[samples=128]", " --plugin " + siconos().string());
  ASSERT_EQ(records.size(), 6U);
  for (const char* scene : {"sdof-stop", "chain2-stop-e05", "sdof-penalty-soft"}) {
    const Record& theirs = records.at(fmt::format("{}/siconos-hat-lcp[samples=128]", scene));
    const Record& ours = records.at(fmt::format("{}/hat-lcp[samples=128]", scene));
    ASSERT_TRUE(theirs.errors.x_l2 && ours.errors.x_l2) << theirs.message << ours.message;
    EXPECT_NEAR(*theirs.errors.x_l2, *ours.errors.x_l2, 1e-6 * *ours.errors.x_l2) << scene;
  }
}

TEST_F(Siconos, DoesNotApplyToWhatItsIntegratorsCannotStep) {
  const TemporaryFolder folder;
  for (const char* scene : {"sdof-penalty-soft", "chain3-massless"}) {
    const Outcome solve = run_installed(
        folder, fmt::format("solve {} --method siconos-moreau-jean --plugin {}", scene, siconos().string()));
    EXPECT_NE(solve.out.find("not-applicable"), std::string::npos) << solve.out;
  }
}

bool has_solve_ivp(const std::string& path) {
  return succeeds(path + " python3 -c 'import signorini; from scipy.integrate import solve_ivp'");
}

TEST(Scipy, FindsCertifiedOrbitsWhereContactsAreImpacts) {
  const std::string path = fmt::format("PATH=/usr/bin:$PATH PYTHONPATH={}", python_package().string());
  if (!has_solve_ivp(path)) GTEST_SKIP() << "python3 with scipy is not installed";
  const auto records =
      records_of("sdof-stop-e05:sdof-two-sided-e08:chain2-stop-e05", "scipy-events[tolerance=1e-8]",
                 " --plugin " + rival("scipy/scipy-events.toml"), path);
  ASSERT_EQ(records.size(), 3U);
  for (const auto& [name, record] : records) {
    EXPECT_EQ(claim_of(record), Claim::certified) << name << ": " << record.certificate.reason;
    ASSERT_TRUE(record.errors.x_l2) << name << record.message;
    EXPECT_LT(*record.errors.x_l2, 1e-6) << name;
  }
}

TEST(Scipy, GivesUpWhereContactLasts) {
  const std::string path = fmt::format("PATH=/usr/bin:$PATH PYTHONPATH={}", python_package().string());
  if (!has_solve_ivp(path)) GTEST_SKIP() << "python3 with scipy is not installed";
  const TemporaryFolder folder;
  const Outcome solve = run_installed(
      folder, "solve sdof-stick --method scipy-events --plugin " + rival("scipy/scipy-events.toml"), path);
  EXPECT_EQ(solve.code, 1);
  EXPECT_NE(solve.out.find("not-converged"), std::string::npos) << solve.out;
}

class Nlvib : public testing::Test {
 protected:
  void SetUp() override {
    if (!succeeds("test -f \"$NLVIB/solve_and_continue.m\" && octave-cli --version"))
      GTEST_SKIP() << "NLVIB names no folder with NLvib's solve_and_continue.m, or Octave is not installed";
  }
};

// Harmonic balance with sampled springs is one set of equations, whoever solves it.
TEST_F(Nlvib, SolvesTheEquationsOfPenaltyHarmonicBalance) {
  const auto records =
      records_of("chain2-penalty",
                 "nlvib-hbm[harmonics=10]:aft-hbm[harmonics=10,quadrature=sampled,samples=1024,"
                 "law=penalty]",
                 " --plugin " + rival("nlvib/nlvib-hbm.toml"));
  ASSERT_EQ(records.size(), 2U);
  const Record& theirs = records.at("chain2-penalty/nlvib-hbm[harmonics=10]");
  const Record& ours =
      records.at("chain2-penalty/aft-hbm[harmonics=10,quadrature=sampled,samples=1024,law=penalty]");
  ASSERT_TRUE(theirs.errors.x_l2 && ours.errors.x_l2) << theirs.message << ours.message;
  EXPECT_NEAR(*theirs.errors.x_l2, *ours.errors.x_l2, 1e-4 * *ours.errors.x_l2);
}

// Newmark's integration is of order two; here instants of contact fall between its steps.
TEST_F(Nlvib, ShootsForTheOrbitOfASpring) {
  const auto records = records_of("chain2-penalty", "nlvib-shooting[steps=128|512]",
                                  " --plugin " + rival("nlvib/nlvib-shooting.toml"));
  ASSERT_EQ(records.size(), 2U);
  const Record& few = records.at("chain2-penalty/nlvib-shooting[steps=128]");
  const Record& many = records.at("chain2-penalty/nlvib-shooting[steps=512]");
  EXPECT_EQ(claim_of(many), Claim::certified) << many.certificate.reason;
  ASSERT_TRUE(few.errors.x_l2 && many.errors.x_l2) << few.message << many.message;
  EXPECT_LT(*many.errors.x_l2, 0.15 * *few.errors.x_l2);
  EXPECT_LT(*many.errors.x_l2, 2e-3);
}

}  // namespace
}  // namespace signorini::test::rivals_test
