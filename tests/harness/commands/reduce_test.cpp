// `signorini reduce`.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "harness/files.hpp"
#include "harness/plan/scene_choice.hpp"
#include "methods/structure/receptance.hpp"
#include "problems/assembly/damping.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/harness/program.hpp"

namespace signorini::reduce_test {
namespace {

using test::Outcome;

Outcome run(const std::string& arguments) { return test::run_program(arguments); }

std::string place(const std::string& name) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "reduce_test";
  std::filesystem::create_directories(folder);
  return (folder / name).string();
}

ContactReceptance factorised(const Problem& problem, int harmonics) {
  return factorised_receptance(
      problem, harmonics, [&](int n) { return exact_weights(n * problem.base_frequency()); }, false);
}

// The file is a scene like any other, and its matrices answer at the contacts as those of the whole do.
TEST(CommandReduce, WritesASceneThatAnswersLikeTheWhole) {
  const std::string out = place("pad.toml");
  const Outcome outcome = run("reduce block-nine-contacts --vectors 40 --out " + out);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("harmonic 100"), std::string::npos) << outcome.out;
  const Problem reduced = read_scene(find_scene(out)).problem;
  const Problem whole = read_scene(find_scene("block-nine-contacts")).problem;
  EXPECT_EQ(reduced.name, "pad");
  EXPECT_LE(reduced.size(), 60);
  EXPECT_EQ(reduced.contacts.front().gap, whole.contacts.front().gap);
  const ContactReceptance few = factorised(reduced, 5), all = factorised(whole, 5);
  for (std::size_t n = 0; n <= 5; ++n) {
    EXPECT_LT((few.receptance[n] - all.receptance[n]).norm(), 1e-6 * all.receptance[n].norm()) << n;
  }
  EXPECT_LT((few.free_response - all.free_response).norm(), 1e-6 * all.free_response.norm());
  const Outcome solved = run("solve " + out + " --method exact-orbit --certificate 20");
  EXPECT_EQ(solved.code, 0) << solved.out << solved.err;
  EXPECT_NE(solved.out.find("certified"), std::string::npos) << solved.out;
}

/// A bar, everything 1, above a stop that its tip meets without mass.
std::string bar_text(int elements, const std::string& damping) {
  return fmt::format(R"(schema = 1
name = "ratios"
[system]
kind = "bar"
elements = {}
length = 1.0
area = 1.0
young = 1.0
density = 1.0
damping = {{ {} }}
contact_mass = "massless"
[forcing]
frequency = 1.5
[[forcing.term]]
dof = {}
harmonic = 1
cos = 0.1
[[contact]]
dof = {}
gap = 0.1
)",
                     elements, damping, 4 * elements / 9, elements - 1);
}

Problem reduced(const std::string& text) {
  const std::string scene = place("ratios.toml"), out = place("ratios-small.toml");
  std::ofstream(scene) << text;
  const Outcome outcome = run("reduce " + scene + " --out " + out);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return read_scene(find_scene(out)).problem;
}

void expect_answers_of(const Problem& found, const Problem& exact, double tolerance) {
  const ContactReceptance few = factorised(found, 10), all = factorised(exact, 10);
  for (std::size_t n = 0; n <= 10; ++n)
    EXPECT_LT((few.receptance[n] - all.receptance[n]).norm(), tolerance * all.receptance[n].norm()) << n;
  EXPECT_LT((few.free_response - all.free_response).norm(), tolerance * all.free_response.norm());
}

// The list counts the modes of the whole structure, the reduced one being given by three matrices.
TEST(CommandReduce, KeepsDampingRatiosOfModes) {
  const std::string text = bar_text(450, "modal = [0.01, 0.05, 0.02]");
  const Problem small = reduced(text);
  EXPECT_LE(small.size(), 100);
  expect_answers_of(small, parse_scene(text, "ratios.toml"), 1e-6);
}

// The oracle: ratios of the modes of what has been reduced without damping.
TEST(CommandReduce, TakesDampingRatiosOfAStructureOfAnySize) {
  const Problem small = reduced(bar_text(3000, "modal = 0.02"));
  Problem by_hand = reduced(bar_text(3000, "alpha = 0"));
  EXPECT_EQ(by_hand.damping().norm(), 0.0);
  by_hand.edit_structure(
      [](Structure& s) { s.damping = damping_matrix(ModalDamping{{0.02}}, s.mass, s.stiffness); });
  expect_answers_of(small, by_hand, 1e-9);
}

TEST(CommandReduce, RefusesAListOfRatiosWhoseModesItDoesNotCount) {
  const std::string scene = place("list.toml");
  std::ofstream(scene) << bar_text(2001, "modal = [0.01, 0.05]");
  const Outcome outcome = run("reduce " + scene + " --out " + place("list-small.toml"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("must have one damping ratio for all modes"), std::string::npos) << outcome.err;
}

TEST(CommandReduce, WritesNoNumbersThatAreNone) {
  const std::string scene = place("damped.toml"), out = place("damped-small.toml");
  for (const char* ratio : {"1e100", "1e308", "1e-300"}) {
    std::ofstream(scene) << bar_text(12, fmt::format("modal = {}", ratio));
    const Outcome outcome = run("reduce " + scene + " --out " + out);
    EXPECT_EQ(outcome.code, 2) << ratio;
    EXPECT_NE(outcome.err.find("system.damping = "), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(out));
  }
}

// The mass is on one spring while its massless neighbour moves along.
TEST(CommandReduce, SaysWhereAnUndampedStructureResonates) {
  const std::string scene = place("resonant.toml");
  std::ofstream(scene) << R"(schema = 1
name = "resonant"
[system]
kind = "chain"
masses = [1.0, 0.0]
springs = [1.0, 1.0]
dampers = [0.0, 0.0]
[forcing]
frequency = 0.1
[[forcing.term]]
dof = 0
cos = 1.0
[[contact]]
dof = 1
gap = 0.3
)";
  const Outcome outcome = run("reduce " + scene + " --out " + place("resonant-small.toml"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("harmonic 10   none: it resonates undamped"), std::string::npos) << outcome.out;
}

TEST(CommandReduce, RefusesWhatItCannotReduce) {
  const Outcome rigid = run("reduce chain10-stop --out " + place("chain.toml"));
  EXPECT_EQ(rigid.code, 2);
  EXPECT_NE(rigid.err.find("impact law"), std::string::npos) << rigid.err;
  const Outcome named = run("reduce block-nine-contacts --out " + place("Pad.toml"));
  EXPECT_EQ(named.code, 2);
  EXPECT_NE(named.err.find("must be NAME.toml"), std::string::npos) << named.err;
}

}  // namespace
}  // namespace signorini::reduce_test
