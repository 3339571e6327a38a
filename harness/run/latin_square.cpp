#include "harness/run/latin_square.hpp"

#include <numeric>
#include <random>
#include <utility>

namespace signorini {

namespace {

// By hand: the order of std::shuffle is the library's own affair.
std::vector<std::size_t> permutation(std::size_t size, std::mt19937_64& random) {
  std::vector<std::size_t> items(size);
  std::iota(items.begin(), items.end(), std::size_t{0});
  for (std::size_t i = size; i > 1; --i) std::swap(items[i - 1], items[random() % i]);
  return items;
}

}  // namespace

LatinSquare::LatinSquare(std::size_t size, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  rows_ = permutation(size, random);
  columns_ = permutation(size, random);
  symbols_ = permutation(size, random);
}

std::vector<std::size_t> LatinSquare::row(std::size_t r) const {
  const std::size_t size = symbols_.size();
  std::vector<std::size_t> order;
  order.reserve(size);
  for (const std::size_t column : columns_) order.push_back(symbols_[(rows_[r % size] + column) % size]);
  return order;
}

}  // namespace signorini
