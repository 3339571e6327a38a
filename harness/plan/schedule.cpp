#include "harness/plan/schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "harness/files.hpp"

namespace signorini {

std::vector<std::size_t> round_order(std::size_t count, std::uint64_t seed, std::string_view scene,
                                     int round) {
  // The hash spreads equal seeds over scenes and rounds; 16 hexadecimal digits are 64 bits.
  const std::string hash = sha256(fmt::format("{} {} {}", seed, scene, round));
  std::mt19937_64 random(std::stoull(hash.substr(0, 16), nullptr, 16));
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

}  // namespace signorini
