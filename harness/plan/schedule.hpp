#pragma once
// The order in which a run takes the cases of a scene, and how many of them at the same time.

#include <cstdint>

namespace signorini {

/// Rounds of timing come in Latin squares, several cases side by side if asked for.
struct Schedule {
  std::uint64_t seed = 1;  ///< of the Latin squares, one for each scene
  int parallel = 1;        ///< cases at the same time
  int beside = 1;          ///< such runs on this machine at the same time, this one included

  /// Cases at the same time on this machine. Above 1 they disturb each other's times.
  [[nodiscard]] int together() const { return parallel * beside; }
};

}  // namespace signorini
