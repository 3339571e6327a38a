// What a large structure may take, read and reduced to its contacts: never a dense array over its
// coordinates.

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "methods/structure/receptance.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/support/child.hpp"
#include "tests/support/elastic_block.hpp"

namespace signorini::scale_test {
namespace {

constexpr double kMegabyte = 1024.0 * 1024.0;

double dense_megabytes(int size) { return 8.0 * size * size / kMegabyte; }

std::string scene_of_bricks(int along) {
  return R"(schema = 1
name = "long-block"
[system]
kind = "block"
elements = [)" +
         std::to_string(along) + R"(, 6, 6]
lengths = [)" +
         std::to_string(0.005 * along) +
         R"(, 0.03, 0.03]
young = 2e11
poisson = 0.3
density = 7800.0
damping = { alpha = 0.5, beta = 1e-3 }
contact_mass = "massless"
[forcing]
frequency = 10.0
[[contact]]
face = "z+"
patch = [[0.1, 0.2], [0.0, 0.03]]
gap = 0.005
)";
}

class SceneAtScale : public testing::TestWithParam<int> {};

// M, D and K have up to 81 entries a row, 12 bytes each, of which M has a third: 2.3 kB a coordinate. They
// are made one after the other, and checked in place.
TEST_P(SceneAtScale, IsReadInMemoryProportionalToItsCoordinates) {
  constexpr double kBytes = 4096.0;
  const int along = GetParam();
  const int size = 3 * along * 7 * 7;
  const double allowed = kBytes * size / kMegabyte;
  ASSERT_LT(allowed, dense_megabytes(size) / 10.0);
  const auto read = [&] {
    if (parse_scene(scene_of_bricks(along), "long-block.toml").size() != size) std::abort();
  };
  EXPECT_TRUE(test::run_in_child(read, allowed).finished) << "within " << allowed << " MB";
}

// Proportional damping takes the projection, damping of one coordinate more than the projection stands for
// the direct factorisations.
TEST(ReceptanceAtScale, NeedsNoDenseArrayOverTheCoordinates) {
  constexpr int kHarmonics = 10;
  Problem proportional = test::elastic_block_problem(
      {.nx = 80, .ny = 8, .nz = 8, .side = 3, .alpha = 1e-3, .beta = 1e-3, .frequency = 0.1});
  Problem general = proportional;
  general.edit_structure([&](Structure& s) { s.damping.coeffRef(0, 0) *= 2.0; });
  for (const Problem& problem : {proportional, general}) {
    const auto reduce = [&] {
      const ContactReceptance receptance = contact_receptance(
          problem, kHarmonics, [&](int n) { return exact_weights(n * problem.frequency); });
      if (receptance.harmonics() != kHarmonics) std::abort();
    };
    const test::ChildCost cost = test::run_in_child(reduce);
    EXPECT_TRUE(cost.finished);
    EXPECT_LT(cost.megabytes, 0.25 * dense_megabytes(problem.size())) << problem.size() << " coordinates";
  }
}

INSTANTIATE_TEST_SUITE_P(Lengths, SceneAtScale, testing::Values(170, 700));

}  // namespace
}  // namespace signorini::scale_test
