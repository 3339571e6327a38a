#include "harness/run/latin_square.hpp"

#include <gtest/gtest.h>

#include <set>

namespace signorini {
namespace {

TEST(LatinSquare, HasEveryItemOnceInEveryRowAndColumn) {
  constexpr std::size_t kSize = 7;
  const LatinSquare square(kSize, 3);
  std::vector<std::set<std::size_t>> columns(kSize);
  for (std::size_t r = 0; r < kSize; ++r) {
    const std::vector<std::size_t> row = square.row(r);
    EXPECT_EQ(std::set(row.begin(), row.end()).size(), kSize);
    for (std::size_t c = 0; c < kSize; ++c) columns[c].insert(row[c]);
  }
  for (const auto& column : columns) EXPECT_EQ(column.size(), kSize);
}

TEST(LatinSquare, IsTheSameForTheSameSeedEverywhere) {
  EXPECT_EQ(LatinSquare(5, 1).row(2), LatinSquare(5, 1).row(2));
  EXPECT_NE(LatinSquare(20, 1).row(0), LatinSquare(20, 2).row(0));
  EXPECT_EQ(LatinSquare(5, 1).row(7), LatinSquare(5, 1).row(2));
}

TEST(LatinSquare, ChangesWhoFollowsWhomFromRoundToRound) {
  const LatinSquare square(11, 5);
  const auto after = [&](std::size_t r, std::size_t item) {
    const std::vector<std::size_t> row = square.row(r);
    for (std::size_t c = 0; c + 1 < row.size(); ++c) {
      if (row[c] == item) return row[c + 1];
    }
    return row.size();
  };
  std::set<std::size_t> followers;
  for (std::size_t r = 0; r < 11; ++r) followers.insert(after(r, 0));
  EXPECT_GE(followers.size(), 5U);
}

}  // namespace
}  // namespace signorini
