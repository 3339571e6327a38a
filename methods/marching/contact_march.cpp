#include "methods/marching/contact_march.hpp"

#include <cmath>
#include <complex>
#include <limits>
#include <span>

namespace signorini {

namespace {

using Complex = std::complex<double>;

double sigma_of(const MarchGrid& grid) { return 1.5 * grid.samples / grid.period; }

Eigen::VectorXd step_response(const ContactReduction& reduction, double sigma) {
  return (sigma * sigma + sigma * reduction.damping.array() + reduction.squares.array()).inverse().matrix();
}

/// G of a step.
Eigen::MatrixXd step_compliance(const ContactReduction& reduction, const MarchGrid& grid) {
  const double sigma = sigma_of(grid);
  const Eigen::MatrixXd weighted = step_response(reduction, sigma).asDiagonal() * reduction.rows;
  Eigen::MatrixXd G =
      reduction.rows.transpose() * weighted + reduction.compliance / (1.0 + reduction.relaxation * sigma);
  G.diagonal() += grid.compliance;
  return 0.5 * (G + G.transpose());
}

Eigen::VectorXd energy_scale(const ContactReduction& reduction, Eigen::Index relaxing) {
  const Eigen::Index m = reduction.vectors();
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(2 * m + relaxing);
  scale.head(m) = reduction.squares.cwiseSqrt();
  const double trace = reduction.compliance.trace();
  if (relaxing > 0 && trace > 0.0)
    scale.tail(relaxing).setConstant(std::sqrt(static_cast<double>(relaxing) / trace));
  return scale;
}

}  // namespace

MarchGrid march_grid(const Problem& problem, int samples) {
  return {.gap = contact_gaps(problem),
          .compliance = stop_compliance(problem),
          .period = problem.period(),
          .samples = samples};
}

std::string march_obstacle(const Problem& problem) {
  return has_impacts(problem) ? "a contact with mass and an impact law is another one in a reduced structure"
                              : "";
}

bool marches_several(const Problem& problem) {
  return problem.contact_count() >= 4 && march_obstacle(problem).empty();
}

ContactMarch::ContactMarch(const ContactReduction& reduction, MarchGrid grid)
    : reduction_(reduction),
      grid_(std::move(grid)),
      modes_(reduction.vectors()),
      relaxing_(reduction.relaxation > 0.0 ? reduction.contacts() : 0),
      part_(2 * modes_ + relaxing_),
      sigma_(sigma_of(grid_)),
      relax_(1.0 / (1.0 + reduction.relaxation * sigma_)),
      response_(step_response(reduction, sigma_)),
      scale_(energy_scale(reduction, relaxing_)),
      contacts_(step_compliance(reduction, grid_)),
      next_(Eigen::VectorXd::Zero(part_)),
      xi_(Eigen::VectorXd::Zero(reduction.contacts())),
      no_load_(Eigen::VectorXd::Zero(modes_)),
      no_shift_(xi_),
      motion_(Eigen::MatrixXd::Zero(grid_.samples, reduction.contacts())),
      force_(motion_),
      sets_(static_cast<std::size_t>(grid_.samples)) {}

MarchWork ContactMarch::work() const {
  return {.steps = steps_,
          .tangent_steps = tangent_steps_,
          .sets = contacts_.changes(),
          .factorisations = contacts_.factorisations(),
          .fallbacks = contacts_.fallbacks()};
}

ContactMarch::History ContactMarch::unscaled(const Eigen::VectorXd& state) const {
  return {state.head(part_).cwiseQuotient(scale_), state.tail(part_).cwiseQuotient(scale_)};
}

Eigen::VectorXd ContactMarch::scaled(const History& history) const {
  Eigen::VectorXd state(size());
  state << history.now.cwiseProduct(scale_), history.before.cwiseProduct(scale_);
  return state;
}

void ContactMarch::shift_history(History& history) {
  history.before.swap(history.now);
  history.now.swap(next_);
}

// With h = (4 y_{k-1} - y_{k-2}) / (2 dt), y' = sigma y - h:
//
//     p = sigma q - h_q,   (sigma + d) p + omega^2 q = h_p + load,   (beta sigma + 1) xi = beta h_xi + shift.
void ContactMarch::advance_freely(const History& history, const Eigen::VectorXd& load,
                                  const Eigen::VectorXd& shift) {
  history_part_ = (sigma_ / 3.0) * (4.0 * history.now - history.before);
  const auto h_q = history_part_.head(modes_), h_p = history_part_.segment(modes_, modes_);
  next_.resize(part_);
  next_.head(modes_) =
      (response_.array() * (h_p.array() + load.array() + (sigma_ + reduction_.damping.array()) * h_q.array()))
          .matrix();
  xi_ = relax_ * shift;
  if (relaxing_ > 0) xi_ += (relax_ * reduction_.relaxation) * history_part_.tail(relaxing_);
}

void ContactMarch::press(const std::vector<int>& set) {
  for (std::size_t k = 0; k < set.size(); ++k) {
    const double lambda = push_[static_cast<Eigen::Index>(k)];
    if (lambda == 0.0) continue;
    next_.head(modes_).array() += lambda * response_.array() * reduction_.rows.col(set[k]).array();
    xi_ += (relax_ * lambda) * reduction_.compliance.col(set[k]);
  }
}

Eigen::VectorXd ContactMarch::period(const Eigen::VectorXd& state) {
  History history = unscaled(state);
  const auto harmonics = static_cast<Eigen::Index>(reduction_.rates.size());
  const double step = grid_.period / grid_.samples;
  Eigen::VectorXd load(modes_), shift(reduction_.contacts()), room(reduction_.contacts());
  for (int k = 1; k <= grid_.samples; ++k) {
    ++steps_;
    load.setZero();
    shift.setZero();
    for (Eigen::Index h = 0; h < harmonics; ++h) {
      const double angle = reduction_.rates[static_cast<std::size_t>(h)] * step * k;
      const double c = std::cos(angle), s = std::sin(angle);
      load += c * reduction_.load.col(h).real() - s * reduction_.load.col(h).imag();
      shift += c * reduction_.shift.col(h).real() - s * reduction_.shift.col(h).imag();
    }
    advance_freely(history, load, shift);
    const int node = k % grid_.samples;
    room.noalias() = grid_.gap - xi_ - reduction_.rows.transpose() * next_.head(modes_);
    if (moved_.size() > 0) room -= moved_.row(node).transpose();
    if (!contacts_.solve(room)) {
      contacts_.restart();
      return Eigen::VectorXd::Constant(size(), std::numeric_limits<double>::quiet_NaN());
    }
    const std::vector<int>& set = contacts_.set();
    push_ = -contacts_.z()(std::span<const int>(set));  // a view by the vector itself copies it
    press(set);
    complete_next();
    sets_[static_cast<std::size_t>(k - 1)] = set;
    // x = g - w - k_p^-1 lambda, w what the conditions leave of the gap.
    motion_.row(node) =
        (grid_.gap - contacts_.w() + grid_.compliance.cwiseProduct(contacts_.z())).transpose();
    force_.row(node) = -contacts_.z().transpose();
    shift_history(history);
  }
  return scaled(history);
}

void ContactMarch::complete_next() {
  next_.segment(modes_, modes_) = sigma_ * next_.head(modes_) - history_part_.head(modes_);
  if (relaxing_ > 0) next_.tail(relaxing_) = xi_;
}

void ContactMarch::advance_on(const std::vector<int>& set, const History& history,
                              const Eigen::VectorXd& moved) {
  advance_freely(history, no_load_, no_shift_);
  if (!set.empty()) {
    push_.resize(static_cast<Eigen::Index>(set.size()));
    for (std::size_t j = 0; j < set.size(); ++j) {
      push_[static_cast<Eigen::Index>(j)] =
          moved[set[j]] + xi_[set[j]] + reduction_.rows.col(set[j]).dot(next_.head(modes_));
    }
    // 0 = dx + G dlambda on the set.
    push_ = contacts_.on_set(set, push_);
    press(set);
  }
  complete_next();
}

Eigen::VectorXd ContactMarch::tangent(const Eigen::VectorXd& change) {
  History history = unscaled(change);
  for (const std::vector<int>& set : sets_) {
    ++tangent_steps_;
    advance_on(set, history, no_shift_);
    shift_history(history);
  }
  return scaled(history);
}

ContactMarch::Change ContactMarch::change(const Eigen::VectorXd& state, const Eigen::MatrixXd& moved) {
  History history = unscaled(state);
  Change result{.state = {}, .motion = moved, .force = Eigen::MatrixXd::Zero(moved.rows(), moved.cols())};
  for (int k = 1; k <= grid_.samples; ++k) {
    ++tangent_steps_;
    const std::vector<int>& set = sets_[static_cast<std::size_t>(k - 1)];
    const int node = k % grid_.samples;
    advance_on(set, history, moved.row(node).transpose());
    result.motion.row(node) += (xi_ + reduction_.rows.transpose() * next_.head(modes_)).transpose();
    for (std::size_t j = 0; j < set.size(); ++j)
      result.force(node, set[j]) = push_[static_cast<Eigen::Index>(j)];
    shift_history(history);
  }
  result.state = scaled(history);
  return result;
}

Eigen::VectorXd ContactMarch::free_state() const {
  const double step = grid_.period / grid_.samples;
  const double beta = reduction_.relaxation;
  History history{Eigen::VectorXd::Zero(part_), Eigen::VectorXd::Zero(part_)};
  for (std::size_t h = 0; h < reduction_.rates.size(); ++h) {
    const auto column = static_cast<Eigen::Index>(h);
    const Complex turn = std::polar(1.0, -reduction_.rates[h] * step);
    const Complex s = (3.0 - 4.0 * turn + turn * turn) / (2.0 * step);
    const Eigen::VectorXcd z =
        (s * s + s * reduction_.damping.array().cast<Complex>() + reduction_.squares.array().cast<Complex>())
            .matrix();
    Eigen::VectorXcd y(part_);
    y.head(modes_) = reduction_.load.col(column).cwiseQuotient(z);
    y.segment(modes_, modes_) = s * y.head(modes_);
    if (relaxing_ > 0) y.tail(relaxing_) = reduction_.shift.col(column) / (1.0 + beta * s);
    history.now += y.real();
    history.before += (turn * y).real();
  }
  return scaled(history);
}

}  // namespace signorini
