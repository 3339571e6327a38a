// What `signorini reduce` refuses before it begins; what it writes is tested with the command.
#include "harness/reduction/reduction_files.hpp"

#include <gtest/gtest.h>

#include "harness/failure.hpp"

namespace signorini::reduction_files_test {
namespace {

// Springs between neighbours on a grid of n x n: its factor has some 30 n^2 log n numbers.
SparseMatrix grid(int n) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int here = i * n + j;
      entries.emplace_back(here, here, 4.1);
      for (const int other : {j + 1 < n ? here + 1 : -1, i + 1 < n ? here + n : -1}) {
        if (other < 0) continue;
        entries.emplace_back(here, other, -1.0);
        entries.emplace_back(other, here, -1.0);
      }
    }
  }
  SparseMatrix K(n * n, n * n);
  K.setFromTriplets(entries.begin(), entries.end());
  return K;
}

TEST(RequireSceneFile, RefusesWhatNoSceneIsCalled) {
  EXPECT_NO_THROW(require_scene_file("pad-2.toml"));
  EXPECT_NO_THROW(require_scene_file("./pad.toml"));
  for (const char* out : {"no-such-folder/pad.toml", "pad", "Pad.toml", "pad.tml", ".toml", "pad_2.toml"})
    EXPECT_THROW(require_scene_file(out), UsageError) << out;
}

TEST(RequireRoomForFactors, LooksAtTheFactorAndNotAtTheMatrix) {
  const SparseMatrix K = grid(60);  // 3600 coordinates: its full triangle has 6.5 million numbers, 52 MB
  EXPECT_NO_THROW(require_room_for_factors("grid", K, 1e9));
  EXPECT_NO_THROW(require_room_for_factors("grid", K, 5e6));
  try {
    require_room_for_factors("grid", K, 1e5);
    FAIL() << "it has more than 10,000 numbers";
  } catch (const UsageError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("scene = grid (must have factors that fit into memory"))
        << error.what();
    EXPECT_NE(std::string(error.what()).find("--mpi N"), std::string::npos);
  }
}

}  // namespace
}  // namespace signorini::reduction_files_test
