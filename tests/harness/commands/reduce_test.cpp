// `signorini reduce`.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "harness/files.hpp"
#include "harness/plan/scene_choice.hpp"
#include "methods/structure/receptance.hpp"
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
