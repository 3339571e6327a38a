#include "methods/hat_functions/period_marching.hpp"

#include "methods/solvers/lcp/complementarity_solver.hpp"
#include "methods/solvers/lcp/lcp.hpp"
#include "methods/structure/bases/condensation.hpp"
#include "problems/linear_algebra/sparse/sparse_factors.hpp"
#include "problems/linear_algebra/sparse/sparse_products.hpp"

namespace signorini {

namespace {

class Recurrence {
 public:
  Recurrence(const Problem& problem, HatScheme scheme, int samples, const NodalStops& stops)
      : samples_(samples),
        contacts_(problem.contact_count()),
        directions_(contact_directions(problem)),
        gap_(stops.gap),
        restitution_(stops.gap.size()) {
    for (int c = 0; c < contacts_; ++c)
      restitution_[c] = stops.restitution[static_cast<std::size_t>(c)].value_or(0.0);
    const double step = problem.period() / samples_;
    const bool consistent = scheme == HatScheme::galerkin;
    const double outer = consistent ? 1.0 / 6.0 : 0.0;
    SparseMatrix inertia = problem.mass(), drag = problem.damping();
    inertia /= step * step;
    drag /= 2.0 * step;
    SparseMatrix ahead = sparse_sum(1.0, sparse_sum(1.0, inertia, 1.0, drag), outer, problem.stiffness());
    here_ = sparse_sum(1.0 - 2.0 * outer, problem.stiffness(), -2.0, inertia);
    behind_ = sparse_sum(1.0, sparse_sum(1.0, inertia, -1.0, drag), outer, problem.stiffness());
    ahead.makeCompressed();
    factors_ = SparseLu(ahead);
    if (!usable()) return;
    compliance_ = sparse_product_of_transposed(directions_, factors_.solve(Eigen::MatrixXd(directions_)));
    compliance_.diagonal() += stops.compliance;
    load_.resize(problem.size(), samples_);
    for (int k = 0; k < samples_; ++k) {
      // Hat functions weight each load by the mean over its two elements; nodal schemes take it as it is.
      const double t = k * step;
      load_.col(k) = consistent ? Eigen::VectorXd((load_at(problem, t - step) + 4.0 * load_at(problem, t) +
                                                   load_at(problem, t + step)) /
                                                  6.0)
                                : load_at(problem, t);
    }
    scale_ = compliance_.cwiseAbs().maxCoeff();
    instant_ = dense_lcp(compliance_ / scale_, {});
    before_ = Eigen::VectorXd::Zero(problem.size());
    now_ = before_;
  }

  [[nodiscard]] bool usable() const { return factors_.regular(); }

  /// One period; false if the motion has grown beyond all bounds or a step has no solution.
  bool advance(Eigen::VectorXd& pressure) {
    for (int k = 0; k < samples_; ++k) {
      // The step without contact, then the pressure p = -lambda that the condition asks for, then its effect:
      // a complementarity problem of size Nc in A_+^{-1} seen by the contacts, as Moreau's scheme solves one
      // per step.
      Eigen::VectorXd next = factors_.solve(
          Eigen::VectorXd(load_.col(k) - sparse_image(here_, now_) - sparse_image(behind_, before_)));
      const Eigen::VectorXd ahead = sparse_image_by_transposed(directions_, next),
                            behind = sparse_image_by_transposed(directions_, before_);
      const Eigen::VectorXd room = gap_ - ahead + restitution_.cwiseProduct(gap_ - behind);
      const Eigen::VectorXd push = contact_pressure(room);
      if (push.size() == 0) return false;
      if (push.maxCoeff() > 0.0) next -= factors_.solve(sparse_image(directions_, push));
      for (int c = 0; c < contacts_; ++c) pressure[c * samples_ + k] = push[c];
      before_.swap(now_);
      now_.swap(next);
    }
    return now_.allFinite() && before_.allFinite();
  }

 private:
  /// p >= 0 with room + compliance p >= 0, complementary; empty if there is none.
  Eigen::VectorXd contact_pressure(const Eigen::VectorXd& room) {
    if (room.minCoeff() >= 0.0) return Eigen::VectorXd::Zero(contacts_);
    if (contacts_ == 1) return -room / compliance_(0, 0);
    instant_.offset = room / scale_;
    const LcpResult result = solve_by_pivoting(instant_);
    return result.status == LcpStatus::solved ? result.z : Eigen::VectorXd{};
  }

  int samples_;
  int contacts_;
  double scale_ = 1.0;
  SparseMatrix directions_, here_, behind_;
  SparseLu factors_;  // of what is ahead
  Eigen::MatrixXd compliance_;
  Lcp instant_;  // the contacts at one instant, in units of scale_
  Eigen::MatrixXd load_;
  Eigen::VectorXd gap_, restitution_, before_, now_;
};

}  // namespace

Eigen::VectorXd march_to_period(const Problem& problem, HatScheme scheme, int samples,
                                const NodalStops& stops, int periods, const Start& start) {
  if (problem.size() > kMostInTime) return {};
  Recurrence recurrence(problem, scheme, samples, stops);
  if (!recurrence.usable()) return {};
  Eigen::VectorXd pressure = Eigen::VectorXd::Zero(samples * problem.contact_count());
  Eigen::VectorXd previous;
  for (int period = 0; period < periods; ++period) {
    previous = pressure;
    if (!recurrence.advance(pressure) || start.expired()) return {};
    // The pressures still change while the motion settles; the nodes that press are what Newton's method
    // needs.
    const bool same = ((previous.array() > 0.0) == (pressure.array() > 0.0)).all();
    if (period > 0 && same && pressure.maxCoeff() > 0.0) return pressure;
  }
  return {};
}

}  // namespace signorini
