#pragma once
// The order in which a run takes the cases of a scene, and how many of them at the same time.

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace signorini {

/// The cases of a scene take turns, in a random order for each round of timing; several side by side if asked
/// for.
struct Schedule {
  std::uint64_t seed = 1;  ///< of the random orders
  int parallel = 1;        ///< cases at the same time
  int beside = 1;          ///< such runs on this machine at the same time, this one included

  /// Cases at the same time on this machine. Above 1 they disturb each other's times.
  [[nodiscard]] int together() const { return parallel * beside; }
};

/// The order of `count` cases of a scene in one round: a random permutation of 0..count-1, so that a drift of
/// the machine does not favour the same cases in every round. It depends on seed, scene and round alone, so
/// that a run that is resumed, or run in shards, takes the same order; with another standard library it may
/// be another.
std::vector<std::size_t> round_order(std::size_t count, std::uint64_t seed, std::string_view scene,
                                     int round);

}  // namespace signorini
