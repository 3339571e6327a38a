#pragma once
// Finite-element structures above rigid stops, their contacts massless: scenes of many coordinates for tests
// of reductions and of marching.

#include <array>
#include <utility>

#include "problems/matrix_properties.hpp"
#include "problems/problem.hpp"

namespace signorini::test {

/// A bar of 200 elements, length, stiffness and density 1, pulled at its middle by 0.15 cos(1.2 t); its tip
/// meets a stop at 0.1.
Problem massless_bar(const ProportionalDamping& damping, int elements = 200);

/// A cantilever of 150 elements, 300 coordinates, everything 1, pushed in the middle by 0.6 cos(2.7 t), above
/// stops at 0.05: at its tip, or at ten nodes of its outer part.
Problem massless_beam(const ProportionalDamping& damping, int contacts);

/// A block above a pad: bricks and lengths along x, y and z, the nodes of a rectangle of its upper face that
/// may touch, and a force spread over its end face along z.
struct PaddedBlock {
  std::array<int, 3> elements = {20, 5, 5};
  std::array<double, 3> lengths = {2.0, 0.5, 0.5};
  std::array<std::pair<double, double>, 2> patch = {{{1.6, 1.8}, {0.1, 0.3}}};
  ProportionalDamping damping = {.alpha = 0.02, .beta = 0.1};
  double frequency = 0.11;
  double force = 4e-5;
  double gap = 0.02;
};

/// E = 1, nu = 0.3, rho = 1. By default the catalogue's block-nine-contacts, 2160 coordinates.
Problem padded_block_problem(const PaddedBlock& block);

}  // namespace signorini::test
