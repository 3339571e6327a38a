#pragma once
// Small problems made of chains.

#include <memory>

#include "problems/assembly/chain.hpp"
#include "problems/problem.hpp"

namespace signorini::test {

inline Problem chain_problem(const Chain& chain) {
  Problem problem;
  problem.structure = std::make_shared<const Structure>(assemble(chain));
  problem.frequency = 2.0;
  problem.force = {{.dof = 0, .harmonic = 1, .cos = 1.0, .sin = 0.5}};
  return problem;
}

inline Problem three_masses() {
  Problem problem =
      chain_problem({.masses = {1.0, 2.0, 4.0}, .dampers = {0.1, 0.1, 0.1}, .springs = {10.0, 20.0, 40.0}});
  problem.contacts = {{.normal = {{2, 1.0}}, .gap = 0.5}};
  problem.set_law(Restitution{0.8});
  return problem;
}

inline Problem massless_tip() {
  Problem problem =
      chain_problem({.masses = {1.0, 2.0, 0.0}, .dampers = {0.1, 0.1, 0.0}, .springs = {10.0, 20.0, 40.0}});
  problem.contacts = {{.normal = {{2, 1.0}}, .gap = 0.5}};
  problem.set_law(Massless{});
  return problem;
}

}  // namespace signorini::test
