#include <stdexcept>
#include <string>
#include <utility>

#include "methods/linear_flow/linear_flow.hpp"
#include "methods/linear_flow/shared_modes.hpp"
#include "problems/linear_algebra/products.hpp"

namespace signorini {

Eigen::MatrixXd LinearArc::outputs_at(double time, int highest) const {
  Eigen::MatrixXd all(equations_.outputs(), highest + 1);
  for (Eigen::Index row = 0; row < all.rows(); ++row)
    for (int order = 0; order <= highest; ++order) all(row, order) = output(row, time, order);
  return all;
}

std::vector<Eigen::MatrixXd> LinearArc::outputs(std::span<const double> times, int highest) const {
  const Eigen::Index rows = equations_.outputs();
  std::vector<Eigen::MatrixXd> derivatives(static_cast<std::size_t>(highest) + 1,
                                           Eigen::MatrixXd(rows, std::ssize(times)));
  for (std::size_t i = 0; i < times.size(); ++i) {
    const Eigen::MatrixXd all = outputs_at(times[i], highest);
    for (int order = 0; order <= highest; ++order)
      derivatives[static_cast<std::size_t>(order)].col(static_cast<Eigen::Index>(i)) = all.col(order);
  }
  return derivatives;
}

std::vector<Eigen::MatrixXd> LinearArc::open_displacements(std::span<const double> times, int highest,
                                                           int first, int count) const {
  const FlowStructure& s = equations_.structure();
  const std::vector<int>& closed = mode().active;
  const Eigen::MatrixXcd waves = s.open_waves.middleRows(first, count);
  std::vector<Eigen::MatrixXd> derivatives = outputs(times, highest);
  Eigen::MatrixXd u(s.size(), std::ssize(times));
  for (std::size_t order = 0; order < derivatives.size(); ++order) {
    for (Eigen::Index i = 0; i < u.cols(); ++i)
      u.col(i) = derivative_of_u(times[static_cast<std::size_t>(i)], static_cast<int>(order));
    Eigen::MatrixXd x = product(s.open_rows.middleRows(first, count), u);
    for (Eigen::Index i = 0; i < u.cols(); ++i)
      x.col(i) +=
          wave_derivative(waves, s.rates, times[static_cast<std::size_t>(i)], static_cast<int>(order));
    const Eigen::MatrixXd& output = derivatives[order];
    if (s.relaxing() > 0)
      x += product(s.open_by_contacts.middleRows(first, count), output.topRows(s.contact_count()));
    else if (!closed.empty())
      x += product(columns_of(s.open.compliance.middleRows(first, count), closed),
                   output.bottomRows(std::ssize(closed)));
    derivatives[order] = std::move(x);
  }
  return derivatives;
}

// order 0..2
Eigen::VectorXd LinearArc::derivative_of_u(double time, int order) const {
  const Eigen::Index size = equations_.size();
  if (order == 0) {
    State at;
    state(time, at);
    return at.u.head(size);
  }
  Eigen::VectorXd rates;
  rate(time, rates);
  return order == 1 ? rates.head(size) : rates.tail(size);
}

std::unique_ptr<const LinearFlow> linear_flow(const ContactDynamics& dynamics, ContactMode mode,
                                              FlowForm form, const std::shared_ptr<SharedModes>& shared) {
  const int most = shared ? shared->most() : kMostInDenseFlow;
  if (dynamics.size() > most) {
    throw std::runtime_error("the closed-form flow is dense: " + std::to_string(dynamics.size()) +
                             " coordinates are more than " + std::to_string(most));
  }
  ModeEquations equations(dynamics, std::move(mode));
  if (form == FlowForm::automatic) {
    auto basis = shared ? shared->of(equations) : modal_basis(equations);
    if (basis && !resonates(equations, basis->reduced))
      return std::make_unique<ModalFlow>(std::move(equations), std::move(basis));
  }
  return std::make_unique<ExponentialFlow>(std::move(equations));
}

const LinearFlow& LinearFlows::of(const std::vector<bool>& closed) {
  auto& flow = flows_[closed];
  if (!flow) flow = linear_flow(dynamics_, dynamics_.mode(closed), form_, shared_);
  return *flow;
}

void LinearFlows::bound_memory(double most) {
  constexpr double kOfEachPair = 200.0;  // bytes of a flow for each pair of coordinates, as measured
  const auto size = static_cast<double>(dynamics_.size());
  if (kOfEachPair * size * size * static_cast<double>(flows_.size()) < most) return;
  flows_.clear();
  if (shared_) shared_->clear();
}

}  // namespace signorini
