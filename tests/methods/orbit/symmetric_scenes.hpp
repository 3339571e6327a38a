#pragma once
// Scenes whose symmetric motions strike two stops at one instant.

#include <Eigen/Core>

#include "problems/problem.hpp"

namespace signorini::test {

inline Problem scene_of(const Eigen::MatrixXd& M, const Eigen::MatrixXd& D, const Eigen::MatrixXd& K,
                        double frequency) {
  Problem problem;
  problem.name = "symmetric";
  problem.edit_structure([&](Structure& structure) {
    structure.mass = M.sparseView();
    structure.damping = D.sparseView();
    structure.stiffness = K.sparseView();
  });
  problem.frequency = frequency;
  return problem;
}

struct Twins {
  double spring = 0.0, damper = 0.0;  // of the link
  double e = 0.8, frequency = 2.2, gap = 0.2, ground_damper = 0.1;
  double heavier = 1.0;  // the second, by so much in mass, springs, dampers and load: their motion is one
};

inline Problem twins(const Twins& of) {
  const double r = of.heavier;
  Eigen::Matrix2d link;
  link << 1.0, -1.0, -1.0, 1.0;
  const Eigen::Matrix2d scale = Eigen::Vector2d(1.0, r).asDiagonal();
  Problem problem =
      scene_of(scale, of.ground_damper * scale + of.damper * link, scale + of.spring * link, of.frequency);
  problem.force = {{.dof = 0, .cos = 1.0}, {.dof = 1, .cos = r}};
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = of.gap}, {.normal = {{1, 1.0}}, .gap = of.gap}};
  problem.set_law(Restitution{of.e});
  return problem;
}

// Equal oscillators in a row, each linked to the next by a spring and a damper; the first of them without a
// link where that is asked for.
inline Problem row_of_oscillators(int count, double spring, double damper, bool first_alone = false) {
  Eigen::MatrixXd link = Eigen::MatrixXd::Zero(count, count);
  for (int i = first_alone ? 1 : 0; i + 1 < count; ++i) {
    link.block(i, i, 2, 2) += Eigen::Matrix2d::Identity();
    link(i, i + 1) -= 1.0;
    link(i + 1, i) -= 1.0;
  }
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(count, count);
  Problem problem = scene_of(one, 0.1 * one + damper * link, one + spring * link, 2.2);
  for (int i = 0; i < count; ++i) {
    problem.force.push_back({.dof = i, .cos = 1.0});
    problem.contacts.push_back({.normal = {{i, 1.0}}, .gap = 0.2, .law = Restitution{0.8}});
  }
  return problem;
}

// Heave and pitch of a rigid bar on springs, two stops at a distance from its middle.
inline Problem bar(double inertia, double arm, double pitch_damping, double e, double frequency = 2.2) {
  Problem problem =
      scene_of(Eigen::Vector2d(1.0, inertia).asDiagonal(), Eigen::Vector2d(0.1, pitch_damping).asDiagonal(),
               Eigen::Vector2d(1.0, 1.2 * inertia).asDiagonal(), frequency);
  problem.force = {{.dof = 0, .cos = 1.0}};
  problem.contacts = {{.normal = {{0, 1.0}, {1, arm}}, .gap = 0.2},
                      {.normal = {{0, 1.0}, {1, -arm}}, .gap = 0.2}};
  problem.set_law(Restitution{e});
  return problem;
}

// Four masses in a row, the same from either end, the outer ones before stops.
inline Problem mirrored_chain(double e, double frequency, double link_damping) {
  Eigen::Matrix4d K;
  K << 3.0, -1.0, 0.0, 0.0, -1.0, 2.5, -1.0, 0.0, 0.0, -1.0, 2.5, -1.0, 0.0, 0.0, -1.0, 3.0;
  Eigen::Matrix4d D = 0.06 * K;
  D(0, 3) = D(3, 0) = -link_damping;
  D(0, 0) += link_damping;
  D(3, 3) += link_damping;
  Problem problem = scene_of(Eigen::Vector4d(1.0, 0.7, 0.7, 1.0).asDiagonal(), D, K, frequency);
  problem.force = {{.dof = 0, .cos = 1.0}, {.dof = 3, .cos = 1.0}};
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = 0.25}, {.normal = {{3, 1.0}}, .gap = 0.25}};
  problem.set_law(Restitution{e});
  return problem;
}

}  // namespace signorini::test
