#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace signorini {

/// Orders of n items in rounds such that in n rounds every item comes once at every place, so that a drift of
/// the machine spoils all of them alike: the cyclic square with its rows, columns and symbols permuted at
/// random (Fisher and Yates, Statistical Tables, 1938). The same seed gives the same square everywhere.
class LatinSquare {
 public:
  LatinSquare(std::size_t size, std::uint64_t seed);

  /// The order of round r; from round n on the rounds repeat.
  [[nodiscard]] std::vector<std::size_t> row(std::size_t r) const;

 private:
  std::vector<std::size_t> rows_, columns_, symbols_;
};

}  // namespace signorini
