#pragma once
// A flow of its own for the tests of multipliers: power series between impacts, bisection for their instants,
// Newton's law at one contact at a time. It shares no code with the library's flows and orbits.

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "problems/problem.hpp"

namespace signorini::test {

/// M u'' + D u' + K u = f cos(w t) with rigid stops w_j^T u <= g_j of restitution e, all of its own.
class NewtonFlow {
 public:
  explicit NewtonFlow(const Problem& problem)
      : n_(problem.size()), omega_(problem.frequency), e_(std::get<Restitution>(problem.law()).e) {
    const Eigen::MatrixXd inverse = Eigen::MatrixXd(problem.mass()).inverse();
    Eigen::VectorXd load = Eigen::VectorXd::Zero(n_), constant = load;
    for (const ForceTerm& term : problem.force) (term.harmonic == 0 ? constant : load)[term.dof] += term.cos;
    // (u, v, cos w t, sin w t, 1)' = A (u, v, cos w t, sin w t, 1)
    A_ = Eigen::MatrixXd::Zero(2 * n_ + 3, 2 * n_ + 3);
    A_.block(0, n_, n_, n_).setIdentity();
    A_.block(n_, 0, n_, n_) = -inverse * Eigen::MatrixXd(problem.stiffness());
    A_.block(n_, n_, n_, n_) = -inverse * Eigen::MatrixXd(problem.damping());
    A_.block(n_, 2 * n_, n_, 1) = inverse * load;
    A_.block(n_, 2 * n_ + 2, n_, 1) = inverse * constant;
    A_(2 * n_, 2 * n_ + 1) = -omega_;
    A_(2 * n_ + 1, 2 * n_) = omega_;
    W_ = Eigen::MatrixXd::Zero(n_, problem.contact_count());
    gaps_.resize(problem.contact_count());
    for (int j = 0; j < problem.contact_count(); ++j) {
      const Contact& contact = problem.contacts[static_cast<std::size_t>(j)];
      for (const auto& [dof, coefficient] : contact.normal) W_(dof, j) = coefficient;
      gaps_[j] = contact.gap;
    }
    push_ = inverse * W_;
  }

  /// (u, v) a period later; `order` takes the contacts in the order of their impacts.
  Eigen::VectorXd period(double time, const Eigen::VectorXd& from, std::vector<int>* order = nullptr) const {
    constexpr int kSteps = 400;
    const double step = 2.0 * std::numbers::pi / omega_ / kSteps;
    Eigen::VectorXd y(2 * n_ + 3);
    y << from, std::cos(omega_ * time), std::sin(omega_ * time), 1.0;
    for (int i = 0; i < kSteps; ++i) {
      double left = step;
      for (;;) {
        int first = -1;
        double at = left;
        const Eigen::VectorXd end = after(y, left);
        for (int j = 0; j < gaps_.size(); ++j) {
          if (!(depth(end, j) > 0.0)) continue;
          double before = 0.0, behind = left;
          for (int k = 0; k < 60; ++k) {
            const double middle = 0.5 * (before + behind);
            // What has just struck is at its stop and leaves it.
            const Eigen::VectorXd there = after(y, middle);
            const bool beyond = depth(there, j) > 0.0 && speed(there, j) > 0.0;
            (beyond ? behind : before) = middle;
          }
          if (first < 0 || behind < at) {
            first = j;
            at = behind;
          }
        }
        y = first < 0 ? end : after(y, at);
        if (first < 0) break;
        y.segment(n_, n_) -=
            (1.0 + e_) * speed(y, first) / W_.col(first).dot(push_.col(first)) * push_.col(first);
        if (order != nullptr) order->push_back(first);
        left -= at;
      }
    }
    return y.head(2 * n_);
  }

 private:
  double depth(const Eigen::VectorXd& y, int j) const { return W_.col(j).dot(y.head(n_)) - gaps_[j]; }
  double speed(const Eigen::VectorXd& y, int j) const { return W_.col(j).dot(y.segment(n_, n_)); }
  Eigen::VectorXd after(const Eigen::VectorXd& y, double time) const {
    Eigen::VectorXd sum = y, term = y;
    for (int k = 1; k < 30; ++k) {
      term = A_ * term * (time / k);
      sum += term;
    }
    return sum;
  }

  Eigen::Index n_;
  double omega_, e_;
  Eigen::MatrixXd A_, W_, push_;
  Eigen::VectorXd gaps_;
};

}  // namespace signorini::test
