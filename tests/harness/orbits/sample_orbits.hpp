#pragma once
// An orbit as a search may have found it, and a file that holds it.

#include "harness/orbits/orbit_file.hpp"

namespace signorini::test {

inline FoundOrbit sample_orbit() {
  FoundOrbit orbit{.fingerprint = "0badcafe",
                   .order = 2,
                   .period = 4.0,
                   .amplitude = 0.5,
                   .starts = 3,
                   .cold = {"hat-lcp[samples=64]"}};
  orbit.certified.source = "exact orbit";
  orbit.certified.error_bar = 1e-14;
  orbit.certified.residual = 1e-15;
  orbit.certified.return_distance = 1e-12;
  orbit.certified.floquet = FloquetMultipliers{{0.5, 0.25}, {0.5, -0.25}};
  orbit.certified.stable = true;
  orbit.certified.events = {{0.5, 0, ContactEvent::Kind::impact, -1.0},
                            {1.5, 1, ContactEvent::Kind::close, {}},
                            {1.75, 1, ContactEvent::Kind::open, {}}};
  return orbit;
}

inline OrbitFile sample_file() {
  return {.scene = "some-scene", .scene_sha256 = "hash", .law = Restitution{0.8}, .orbits = {sample_orbit()}};
}

}  // namespace signorini::test
