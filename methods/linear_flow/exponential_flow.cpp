#include <algorithm>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/MatrixFunctions>
#include <utility>

#include "methods/linear_flow/linear_flow.hpp"

namespace signorini {

Eigen::MatrixXd matrix_exponential(const Eigen::MatrixXd& A) { return A.exp(); }

ExponentialFlow::ExponentialFlow(ModeEquations equations, const EnergyForm& energy)
    : LinearFlow(std::move(equations)) {
  const Eigen::MatrixXd& Q = equations_.form.basis;
  const std::vector<double>& rates = equations_.rates();
  const Eigen::Index n = equations_.free(), harmonics = equations_.harmonics();
  generator_ = Eigen::MatrixXd::Zero(2 * n + 2 * harmonics, 2 * n + 2 * harmonics);
  generator_.topLeftCorner(2 * n, 2 * n) = energy.B.cast<double>();
  v_of_z_ = Q * energy.q_of_z.cast<double>();
  u_of_e_ = Q * ExtendedMatrix(energy.q_of_z * energy.z_of_e).cast<double>();
  z_of_v_ = energy.L.transpose().cast<double>() * Q.transpose();
  e_of_u_ = ExtendedMatrix(energy.E.transpose() * energy.L.transpose()).cast<double>() * Q.transpose();
  output_ = Eigen::MatrixXd::Zero(equations_.outputs(), generator_.cols());
  output_.leftCols(n) = equations_.output_of_state.leftCols(size()) * u_of_e_;
  output_.middleCols(n, n) = equations_.output_of_state.rightCols(size()) * v_of_z_;
  for (Eigen::Index h = 0; h < harmonics; ++h) {
    // Re f e^{i angle} = Re f cos - Im f sin, with the cosine in column c and the sine in column c + 1.
    const Eigen::Index c = 2 * n + 2 * h;
    const Eigen::VectorXcd load = energy.q_of_z.transpose().cast<double>() * equations_.reduced_load(h);
    generator_.block(n, c, n, 1) = load.real();
    generator_.block(n, c + 1, n, 1) = -load.imag();
    generator_(c, c + 1) = -rates[static_cast<std::size_t>(h)];
    generator_(c + 1, c) = rates[static_cast<std::size_t>(h)];
    output_.col(c) = equations_.output_of_load.col(h).real();
    output_.col(c + 1) = -equations_.output_of_load.col(h).imag();
  }
  output_.col(2 * n) += equations_.output_of_state.leftCols(size()) * equations_.form.offset;
  // An estimate by power iteration: the bound of a Gershgorin disc would be too large for M far from the
  // identity.
  const double structure = std::max(rates.back(), 1.1 * equations_.structure().fastest_rate);
  fastest_rate_ = equations_.dynamics->stops().fastest_rate(equations_.mode, structure);
}

Eigen::MatrixXd ExponentialFlow::transition(double duration) const {
  const int n = size();
  const Eigen::Index r = equations_.free();
  Eigen::MatrixXd result(2 * n, 2 * n);
  const Eigen::MatrixXd reduced = matrix_exponential(generator_.topLeftCorner(2 * r, 2 * r) * duration);
  result.topLeftCorner(n, n) = u_of_e_ * reduced.topLeftCorner(r, r) * e_of_u_;
  result.topRightCorner(n, n) = u_of_e_ * reduced.topRightCorner(r, r) * z_of_v_;
  result.bottomLeftCorner(n, n) = v_of_z_ * reduced.bottomLeftCorner(r, r) * e_of_u_;
  result.bottomRightCorner(n, n) = v_of_z_ * reduced.bottomRightCorner(r, r) * z_of_v_;
  return result;
}

State ExponentialFlow::response(const std::vector<Impulse>& impulses) const {
  const int n = size();
  const Eigen::MatrixXd& velocity = equations_.structure().velocity_per_impulse;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(2 * n);
  // An impulse p is the velocity M^-1 W p, from which the structure moves freely.
  for (const Impulse& impulse : impulses)
    sum += transition(impulse.time).rightCols(n) * (impulse.value * velocity.col(impulse.contact));
  return {.u = sum.head(n), .v = sum.tail(n)};
}

/// A motion as the augmented state at its beginning.
class ExponentialFlow::Arc final : public LinearArc {
 public:
  explicit Arc(const ExponentialFlow& flow) : LinearArc(flow.equations_), flow_(flow) {}

  void start(double time, const State& state) override {
    const std::vector<double>& rates = equations_.rates();
    const Eigen::Index r = equations_.free();
    begin_ = time;
    placed_ = false;
    first_.resize(flow_.generator_.cols());
    first_.head(r) = flow_.e_of_u_ * (state.u - equations_.form.offset);
    first_.segment(r, r) = flow_.z_of_v_ * state.v;
    for (Eigen::Index h = 0; h < equations_.harmonics(); ++h) {
      const double angle = rates[static_cast<std::size_t>(h)] * time;
      first_[2 * r + 2 * h] = std::cos(angle);
      first_[2 * r + 2 * h + 1] = std::sin(angle);
    }
  }

  // Without modes nothing is known to fade.
  [[nodiscard]] std::vector<FadingRate> fading_rates(double, double, int) const override {
    return {{.rate = flow_.fastest_rate_, .until = std::numeric_limits<double>::infinity()}};
  }

  void state(double time, State& state) const override {
    move_to(time);
    const Eigen::Index r = equations_.free();
    state.u = equations_.form.offset + flow_.u_of_e_ * augmented_.head(r);
    state.v = flow_.v_of_z_ * augmented_.segment(r, r);
  }

  void acceleration(double time, Eigen::VectorXd& a) const override {
    move_to(time);
    const Eigen::Index r = equations_.free();
    const Eigen::VectorXd rate = flow_.generator_ * augmented_;
    a = flow_.v_of_z_ * rate.segment(r, r);
  }

 private:
  [[nodiscard]] double output(Eigen::Index row, double time, int order) const override {
    move_to(time);
    Eigen::VectorXd state = augmented_;
    for (int k = 0; k < order; ++k) state = (flow_.generator_ * state).eval();
    return flow_.output_.row(row).dot(state);
  }

  void move_to(double time) const {
    if (placed_ && now_ == time) return;
    placed_ = true;
    now_ = time;
    augmented_ = matrix_exponential(flow_.generator_ * (time - begin_)) * first_;
  }

  const ExponentialFlow& flow_;
  double begin_ = 0.0;
  Eigen::VectorXd first_;  // the augmented state at `begin`
  mutable double now_ = 0.0;
  mutable bool placed_ = false;
  mutable Eigen::VectorXd augmented_;
};

std::unique_ptr<LinearArc> ExponentialFlow::arc() const { return std::make_unique<Arc>(*this); }

}  // namespace signorini
