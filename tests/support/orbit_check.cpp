#include "tests/support/orbit_check.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "problems/linear_algebra/exponential.hpp"
#include "problems/linear_algebra/lu.hpp"

namespace signorini::test {

namespace {

// The orbit's own motion, state z = (u, v, cos and sin of each load term's harmonic, 1).
class Follower {
 public:
  Follower(const Problem& problem, const ExactTrajectory& orbit, double tolerance)
      : problem_(problem),
        orbit_(orbit),
        tolerance_(tolerance),
        W_(contact_directions(problem)),
        g_(contact_gaps(problem)),
        n_(problem.size()) {
    M_ = LuFactors(problem.mass()).inverse();
    if (const Law law_of_all = problem.law(); const auto* law = std::get_if<Restitution>(&law_of_all))
      e_ = law->e;
    if (const Law law_of_all = problem.law(); const auto* law = std::get_if<Penalty>(&law_of_all))
      springs_ = law->stiffness;
  }

  OrbitCheck run() {
    const OrbitGuess& claim = orbit_.orbit();
    measure_scales();
    time_ = claim.start.time;
    z_ = Eigen::VectorXd(2 * n_ + loads() + 1);
    z_.head(n_) = claim.start.state.u;
    z_.segment(n_, n_) = claim.start.state.v;
    std::vector<bool> closed = claim.start.closed;
    for (const SequenceEvent& event : claim.events) {
      fly(closed, event.time);
      pass(event);
      closed = event.closed;
    }
    fly(closed, claim.start.time + orbit_.period());
    result_.return_distance =
        std::max((z_.head(n_) - claim.start.state.u).lpNorm<Eigen::Infinity>() / x_scale_,
                 (z_.segment(n_, n_) - claim.start.state.v).lpNorm<Eigen::Infinity>() / v_scale_);
    return result_;
  }

 private:
  [[nodiscard]] Eigen::Index loads() const { return 2 * static_cast<Eigen::Index>(problem_.force.size()); }
  [[nodiscard]] bool springs() const { return !springs_.empty(); }

  void fail(const std::string& what) {
    if (result_.ok) result_.reason = what + " at t = " + std::to_string(time_);
    result_.ok = false;
  }

  void measure_scales() {
    for (int i = 0; i < 200; ++i) {
      const State state = orbit_.at(orbit_.period() * i / 200);
      x_scale_ =
          std::max({x_scale_, state.u.lpNorm<Eigen::Infinity>(), g_.size() ? g_.cwiseAbs().maxCoeff() : 0.0});
      v_scale_ = std::max(v_scale_, state.v.lpNorm<Eigen::Infinity>());
    }
    v_scale_ = std::max(v_scale_, problem_.frequency * x_scale_);
  }

  // lambda_A = L z, and the generator of z in a mode.
  void form(const std::vector<bool>& closed) {
    const Eigen::Index N = z_.size();
    Eigen::MatrixXd rate = Eigen::MatrixXd::Zero(n_, N);
    rate.leftCols(n_) = -Eigen::MatrixXd(problem_.stiffness());
    rate.middleCols(n_, n_) = -Eigen::MatrixXd(problem_.damping());
    generator_ = Eigen::MatrixXd::Zero(N, N);
    for (std::size_t k = 0; k < problem_.force.size(); ++k) {
      const ForceTerm& term = problem_.force[k];
      const auto c = 2 * n_ + 2 * static_cast<Eigen::Index>(k);
      const double size = std::pow(problem_.frequency, term.omega_power);
      rate(term.dof, c) += size * term.cos;
      rate(term.dof, c + 1) += size * term.sin;
      generator_(c, c + 1) = -term.harmonic * problem_.frequency;
      generator_(c + 1, c) = term.harmonic * problem_.frequency;
    }
    active_.clear();
    for (std::size_t j = 0; j < closed.size(); ++j) {
      if (closed[j]) active_.push_back(static_cast<int>(j));
    }
    const Eigen::MatrixXd W = Eigen::MatrixXd(W_)(Eigen::all, active_);
    multiplier_ = Eigen::MatrixXd::Zero(W.cols(), N);
    if (!active_.empty() && springs()) {
      multiplier_.leftCols(n_) = -W.transpose();
      multiplier_.col(N - 1) = g_(active_);
      for (std::size_t i = 0; i < active_.size(); ++i)
        multiplier_.row(static_cast<Eigen::Index>(i)) *= springs_[static_cast<std::size_t>(active_[i])];
    } else if (!active_.empty()) {
      multiplier_ = -lu_solve(W.transpose() * M_ * W, Eigen::MatrixXd(W.transpose() * M_ * rate));
    }
    rate += W * multiplier_;
    generator_.block(0, n_, n_, n_).setIdentity();
    generator_.middleRows(n_, n_) = M_ * rate;
    force_scale_ = problem_.stiffness().coeff(0, 0) * x_scale_;
    for (const double spring : springs_) force_scale_ = std::max(force_scale_, spring * x_scale_);
  }

  void fly(const std::vector<bool>& closed, double end) {
    constexpr int kSteps = 300;
    form(closed);
    for (std::size_t k = 0; k < problem_.force.size(); ++k) {
      const double angle = problem_.force[k].harmonic * problem_.frequency * time_;
      z_[2 * n_ + 2 * static_cast<Eigen::Index>(k)] = std::cos(angle);
      z_[2 * n_ + 2 * static_cast<Eigen::Index>(k) + 1] = std::sin(angle);
    }
    z_[z_.size() - 1] = 1.0;
    const Eigen::MatrixXd step = matrix_exponential(generator_ * ((end - time_) / kSteps));
    const double begin = time_;
    for (int i = 1; i <= kSteps; ++i) {
      z_ = step * z_;
      time_ = begin + (end - begin) * i / kSteps;
      look(closed);
    }
  }

  void look(const std::vector<bool>& closed) {
    const Eigen::VectorXd depth = W_.transpose() * z_.head(n_) - g_;
    const Eigen::VectorXd lambda = multiplier_ * z_;
    for (std::size_t j = 0; j < closed.size(); ++j) {
      const double d = depth[static_cast<Eigen::Index>(j)] / x_scale_;
      if (!closed[j]) result_.penetration = std::max(result_.penetration, d);
      if (!closed[j] && d > tolerance_) fail("penetration");
      if (closed[j] && !springs() && std::abs(d) > tolerance_) fail("a closed contact leaves its stop");
    }
    if (lambda.size() > 0 && lambda.maxCoeff() > tolerance_ * force_scale_) fail("a closed contact pulls");
  }

  void pass(const SequenceEvent& event) {
    const Eigen::VectorXd before = W_.transpose() * z_.segment(n_, n_);
    Eigen::VectorXd p = Eigen::VectorXd::Zero(g_.size());
    for (const Impulse& impulse : orbit_.impulses()) {
      const double apart = std::remainder(impulse.time - event.time, orbit_.period());
      if (std::abs(apart) < 1e-12 * orbit_.period()) p[impulse.contact] += impulse.value;
    }
    if (p.size() > 0 && p.maxCoeff() > 0.0) fail("an impulse pulls");
    z_.segment(n_, n_) += M_ * (W_ * p);
    const Eigen::VectorXd after = W_.transpose() * z_.segment(n_, n_);
    const Eigen::VectorXd depth = W_.transpose() * z_.head(n_) - g_;
    constexpr double kSlow = 1e-4;
    for (Eigen::Index j = 0; j < p.size(); ++j) {
      if (p[j] == 0.0) continue;
      if (std::abs(depth[j]) > tolerance_ * x_scale_) fail("an impact away from the stop");
      const double newton = std::abs(after[j] + e_ * before[j]), stop = std::abs(after[j]);
      const bool stays =
          event.closed[static_cast<std::size_t>(j)] && (e_ == 0.0 || before[j] < kSlow * v_scale_);
      if (newton > tolerance_ * v_scale_ && !(stays && stop <= tolerance_ * v_scale_)) fail("the impact law");
    }
  }

  const Problem& problem_;
  const ExactTrajectory& orbit_;
  double tolerance_;
  SparseMatrix W_;
  Eigen::VectorXd g_;
  Eigen::Index n_;
  Eigen::MatrixXd M_, generator_, multiplier_;  // M^-1
  std::vector<int> active_;
  std::vector<double> springs_;
  Eigen::VectorXd z_;
  double e_ = 1.0, time_ = 0.0, x_scale_ = 0.0, v_scale_ = 0.0, force_scale_ = 1.0;
  OrbitCheck result_;
};

}  // namespace

OrbitCheck check_orbit(const Problem& problem, const ExactTrajectory& orbit, double tolerance) {
  return Follower(problem, orbit, tolerance).run();
}

}  // namespace signorini::test
