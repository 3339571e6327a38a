#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "methods/linear_flow/linear_flow.hpp"
#include "problems/linear_algebra/exponential.hpp"
#include "problems/linear_algebra/products.hpp"

namespace signorini {

ExponentialFlow::ExponentialFlow(ModeEquations equations) : LinearFlow(std::move(equations)) {
  const MassForm mass = equations_.mass_form();
  const EnergyForm energy(mass, equations_.structure().frequency);
  const Eigen::MatrixXd& Q = equations_.form.basis;
  const Eigen::MatrixXd q_of_z = extended::rounded(mass.q_of_z);
  const RelaxingForm& relaxing = equations_.form.relaxing;
  const Eigen::Index n = equations_.free(), harmonics = equations_.harmonics();
  const Eigen::Index alone = relaxing.of_z.cols(), y = 2 * n + alone;
  generator_ = Eigen::MatrixXd::Zero(y + 2 * harmonics, y + 2 * harmonics);
  generator_.topLeftCorner(2 * n, 2 * n) = extended::rounded(energy.B);
  position_of_y_ = Eigen::MatrixXd::Zero(positions(), y);
  position_of_y_.topLeftCorner(size(), n) =
      product(Q, extended::rounded(extended::product(mass.q_of_z, energy.z_of_e)));
  velocity_of_y_ = Eigen::MatrixXd::Zero(size(), y);
  velocity_of_y_.middleCols(n, n) = product(Q, q_of_z);
  y_of_state_ = Eigen::MatrixXd::Zero(y, states());
  y_of_state_.topLeftCorner(n, size()) =
      product_by_transposed(extended::rounded(extended::transposed(extended::product(mass.L, energy.E))), Q);
  y_of_state_.block(n, positions(), n, size()) =
      product_by_transposed(extended::rounded(extended::transposed(mass.L)), Q);
  offset_ = Eigen::VectorXd::Zero(positions());
  offset_.head(size()) = equations_.form.offset;
  if (positions() > size()) relax();
  output_ = Eigen::MatrixXd::Zero(equations_.outputs(), generator_.cols());
  Eigen::MatrixXd of_y = product(equations_.output_of_state.leftCols(positions()), position_of_y_);
  add_product(equations_.output_of_state.rightCols(size()), velocity_of_y_, of_y);
  output_.leftCols(y) = of_y;
  for (Eigen::Index h = 0; h < harmonics; ++h) {
    // Re f e^{i angle} = Re f cos - Im f sin, with the cosine in column c and the sine in column c + 1.
    const Eigen::Index c = y + 2 * h;
    const double rate = equations_.rates()[static_cast<std::size_t>(h)];
    const Eigen::VectorXcd load = image_of_complex_by_transposed(q_of_z, equations_.reduced_load(h));
    generator_.block(n, c, n, 1) = load.real();
    generator_.block(n, c + 1, n, 1) = -load.imag();
    generator_(c, c + 1) = -rate;
    generator_(c + 1, c) = rate;
    output_.col(c) = equations_.output_of_load.col(h).real();
    output_.col(c + 1) = -equations_.output_of_load.col(h).imag();
  }
  output_.col(y) += image(equations_.output_of_state.leftCols(positions()), offset_);
  // An estimate by power iteration: the bound of a Gershgorin disc would be too large for M far from the
  // identity.
  const double structure = std::max(equations_.rates().back(), 1.1 * equations_.structure().fastest_rate);
  fastest_rate_ = equations_.dynamics->stops().fastest_rate(equations_.mode, structure);
}

// What relaxes alone: beta z' + z = shift.
void ExponentialFlow::relax() {
  const RelaxingForm& relaxing = equations_.form.relaxing;
  const Eigen::Index n = equations_.free(), alone = relaxing.of_z.cols(), contacts = positions() - size();
  position_of_y_.bottomLeftCorner(contacts, n) =
      product(relaxing.of_u, position_of_y_.topLeftCorner(size(), n));
  position_of_y_.bottomRightCorner(contacts, alone) = relaxing.of_z;
  y_of_state_.block(2 * n, size(), alone, contacts) = relaxing.of_xi;
  offset_.tail(contacts) = image(relaxing.of_u, equations_.form.offset) + relaxing.offset;
  generator_.block(2 * n, 2 * n, alone, alone).diagonal() = -relaxing.times.cwiseInverse();
  for (Eigen::Index h = 0; h < equations_.harmonics(); ++h) {
    const Eigen::Index c = 2 * n + alone + 2 * h;
    generator_.block(2 * n, c, alone, 1) = relaxing.shift.col(h).real().cwiseQuotient(relaxing.times);
    generator_.block(2 * n, c + 1, alone, 1) = -relaxing.shift.col(h).imag().cwiseQuotient(relaxing.times);
  }
}

Eigen::MatrixXd ExponentialFlow::transition(double duration) const {
  const Eigen::Index y = y_of_state_.rows();
  const Eigen::MatrixXd reduced =
      product(matrix_exponential(generator_.topLeftCorner(y, y) * duration), y_of_state_);
  Eigen::MatrixXd result(states(), states());
  result.topRows(positions()) = product(position_of_y_, reduced);
  result.bottomRows(size()) = product(velocity_of_y_, reduced);
  return result;
}

State ExponentialFlow::response(const std::vector<Impulse>& impulses) const {
  const FlowStructure& structure = equations_.structure();
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(states()), struck = sum;
  // An impulse p is the velocity M^-1 W p, and C p / beta of xi, from which the structure moves freely.
  for (const Impulse& impulse : impulses) {
    struck.tail(size()) = impulse.value * structure.velocity_per_impulse.col(impulse.contact);
    if (positions() > size())
      struck.segment(size(), positions() - size()) =
          impulse.value * structure.displacement_per_impulse(impulse.contact);
    sum += image(transition(impulse.time), struck);
  }
  return {.u = sum.head(positions()), .v = sum.tail(size())};
}

/// A motion as the augmented state at its beginning.
class ExponentialFlow::Arc final : public LinearArc {
 public:
  explicit Arc(const ExponentialFlow& flow) : LinearArc(flow.equations_), flow_(flow) {}

  void start(double time, const State& state) override {
    const std::vector<double>& rates = equations_.rates();
    const Eigen::Index y = flow_.y_of_state_.rows();
    begin_ = time;
    placed_ = false;
    first_.resize(flow_.generator_.cols());
    Eigen::VectorXd start = image(flow_.y_of_state_.leftCols(flow_.positions()), state.u - flow_.offset_);
    add_image(flow_.y_of_state_.rightCols(flow_.size()), state.v, start);
    first_.head(y) = start;
    for (Eigen::Index h = 0; h < equations_.harmonics(); ++h) {
      const double angle = rates[static_cast<std::size_t>(h)] * time;
      first_[y + 2 * h] = std::cos(angle);
      first_[y + 2 * h + 1] = std::sin(angle);
    }
  }

  // Without modes nothing is known to fade.
  [[nodiscard]] std::vector<FadingRate> fading_rates(double, double, int) const override {
    return {{.rate = flow_.fastest_rate_, .until = std::numeric_limits<double>::infinity()}};
  }

  void state(double time, State& state) const override {
    move_to(time);
    const auto y = augmented_.head(flow_.y_of_state_.rows());
    state.u = flow_.offset_;
    add_image(flow_.position_of_y_, y, state.u);
    state.v = image(flow_.velocity_of_y_, y);
  }

  void rate(double time, Eigen::VectorXd& rate) const override {
    move_to(time);
    const Eigen::VectorXd y = image(flow_.generator_, augmented_).head(flow_.y_of_state_.rows());
    rate.resize(flow_.states());
    rate.head(flow_.positions()) = image(flow_.position_of_y_, y);
    rate.tail(flow_.size()) = image(flow_.velocity_of_y_, y);
  }

 private:
  [[nodiscard]] double output(Eigen::Index row, double time, int order) const override {
    move_to(time);
    Eigen::VectorXd state = augmented_;
    for (int k = 0; k < order; ++k) state = image(flow_.generator_, state);
    return flow_.output_.row(row).dot(state);
  }

  void move_to(double time) const {
    if (placed_ && now_ == time) return;
    placed_ = true;
    now_ = time;
    augmented_ = image(matrix_exponential(flow_.generator_ * (time - begin_)), first_);
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
