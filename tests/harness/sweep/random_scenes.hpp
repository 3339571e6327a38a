#pragma once
// Random scenes whose responses are followed.

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::test {

/// Mostly one mass, with one or two rigid stops; every fourth a chain of two to four masses with one to
/// three.
inline Problem random_scene(std::mt19937& random, int number) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const double restitution = 0.3 + 0.7 * share(random);
  if (number % 4 == 3) {
    const int masses = 2 + static_cast<int>(3.0 * share(random));
    const int stops = std::min(masses, 1 + static_cast<int>(3.0 * share(random)));
    Problem chain = stopped_chain(masses, restitution, stops);
    for (Contact& contact : chain.contacts) contact.gap = 0.1 + share(random);
    return chain;
  }
  Problem oscillator = to_problem({.damping = 0.02 * std::pow(20.0, share(random)),
                                   .gap = -0.3 + 1.3 * share(random),
                                   .restitution = restitution});
  if (number % 2 == 1)
    oscillator.contacts.push_back(
        {.normal = {{0, -1.0}}, .gap = 0.3 + share(random), .law = oscillator.contacts.front().law});
  return oscillator;
}

}  // namespace signorini::test
