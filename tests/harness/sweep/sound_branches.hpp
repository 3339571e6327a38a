#pragma once
// Whether branches consist of orbits of their scene.

#include <gtest/gtest.h>

#include <memory>

#include "methods/orbit/continuation/orbit_branch.hpp"
#include "methods/orbit/exact_orbit.hpp"
#include "methods/orbit/family/orbit_family.hpp"

namespace signorini::test {

/// Every end has its reason, no motion passes a stop by more than 1e-9, and every third point within a branch
/// is polished, which finds its own way, to an orbit of the scene; but that a polish refuses impacts that
/// nearly graze, and measures what passes a stop by the amplitude at that frequency, where a curve has one
/// unit for all (CurveUnits), of 1e-11 of which both allow. \return how many were polished
inline int expect_orbits_of(const ParametrisedScene& scene, const OrbitDiagram& diagram) {
  const double allowed = kAdmissible * OrbitFamily(scene).units().displacement;
  int compared = 0;
  EXPECT_FALSE(diagram.branches.empty());
  for (const OrbitBranch& branch : diagram.branches) {
    EXPECT_FALSE(branch.began.empty() || branch.ended.empty());
    EXPECT_NE(branch.ended, "the corrector fails") << branch.sequence;
    for (const SolutionPoint& point : branch.points) {
      const Problem at = scene.at(point.parameter);
      for (std::size_t j = 0; j < at.contacts.size(); ++j)
        EXPECT_LE(point.x_max[j] - at.contacts[j].gap, 1e-9)
            << branch.sequence << " at " << point.parameter << ", " << branch.ended;
    }
    for (std::size_t i = 1; i + 1 < branch.points.size(); i += 3, ++compared) {
      const SolutionPoint& point = branch.points[i];
      const auto model =
          std::make_shared<OrbitModel>(with_subharmonic(scene.at(point.parameter), point.order));
      const ExactOrbit orbit = polish_sequence(model, branch.orbits[i]);
      const double past = orbit.admissibility.violation * model->dynamics.scales().displacement;
      const bool within = orbit.outcome == OrbitOutcome::not_admissible && past <= allowed;
      EXPECT_TRUE(orbit.certified() || orbit.outcome == OrbitOutcome::grazing || within)
          << branch.sequence << " at " << point.parameter << ": " << orbit.reason;
    }
  }
  return compared;
}

}  // namespace signorini::test
