#include "methods/complementarity/impact_closure.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

#include "methods/complementarity/contact_nodes.hpp"
#include "methods/complementarity/projected_residual.hpp"
#include "methods/discretisation/fourier_series.hpp"
#include "methods/solvers/bracketed_zero.hpp"
#include "methods/solvers/condition_estimate.hpp"
#include "methods/solvers/constants.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "problems/linear_algebra/products.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

constexpr double kStopMoved = 3.0;  // over H: how far from its impact a stop that approaches is moved

/// One impact's contact in the series.
struct ClosedContact {
  int contact = 0;
  double time = 0.0;      // t_k, share of the period
  double force = 0.0;     // J_k / T [N]
  double begin = 0.0;     // of contact, relative to t_k
  double end = 0.0;       // likewise
  double distance = 0.0;  // a_k [m]
  double speed = 0.0;     // b_k [m] per period

  [[nodiscard]] double width() const { return end - begin; }
};

/// The nodes on one contact.
struct ClosedNodes {
  Eigen::VectorXd since;    // t - t_k
  Eigen::VectorXd weight;   // of the integral over the contact, shares of the period
  Eigen::MatrixXcd phases;  // e^{2 pi i n t}, nodes x (H+1)
};

ClosedNodes nodes_of(const ClosedContact& contact, int harmonics) {
  ContactNodes nodes = nodes_on(contact.begin, contact.end, harmonics);
  const Eigen::VectorXd time = (contact.time + nodes.time.array()).matrix();
  return {std::move(nodes.time), std::move(nodes.weight), phases_at(time, harmonics)};
}

/// How y of contact `row` answers to -lambda of contact `column`: c C_n - alpha delta, n = 0..H, those of n >
/// 0 twice for their conjugates.
Eigen::VectorXcd doubled_symbol(const ProjectedEquations& equations, int row, int column) {
  const auto& [receptance, gap, law] = equations;
  Eigen::VectorXcd symbol(receptance.harmonics() + 1);
  const double alpha = row == column ? law.multiplier_weight[row] : 0.0;
  for (Eigen::Index n = 0; n < symbol.size(); ++n) {
    const Complex b =
        law.constant[row] * receptance.receptance[static_cast<std::size_t>(n)](row, column) - alpha;
    symbol[n] = n == 0 ? Complex(b.real()) : 2.0 * b;
  }
  return symbol;
}

/// The bordered linear system of one step, in z at the nodes of all contacts, then c a_k and c b_k w_k / 2 of
/// each, w_k the width of its contact: all forces.
class BorderedSystem {
 public:
  BorderedSystem(const ProjectedEquations& equations, const std::vector<ClosedContact>& contacts)
      : equations_(equations), contacts_(contacts) {
    Eigen::Index count = 0;
    for (const ClosedContact& contact : contacts) {
      first_.push_back(count);
      nodes_.push_back(nodes_of(contact, equations.receptance.harmonics()));
      count += nodes_.back().weight.size();
    }
    border_ = count;
    const Eigen::Index size = count + 2 * static_cast<Eigen::Index>(contacts.size());
    matrix_ = Eigen::MatrixXd::Zero(size, size);
    load_ = Eigen::VectorXd::Zero(size);
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      for (std::size_t l = 0; l < contacts.size(); ++l) add_answer(k, l);
      add_border(k);
    }
    matrix_.diagonal().head(count).array() += 1.0;
  }

  /// Solves for z and writes the stops to `contacts`; false where the matrix is singular.
  bool solve(std::vector<ClosedContact>& contacts, std::optional<double>& condition) {
    const LuFactors lu(matrix_);
    solution_ = lu.solve(load_);
    if (!solution_.allFinite()) return false;
    condition = condition_from(lu.reciprocal_condition());
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const double c = equations_.law.constant[contacts[k].contact];
      const Eigen::Index place = border_ + 2 * static_cast<Eigen::Index>(k);
      contacts[k].distance = solution_[place] / c;
      contacts[k].speed = solution_[place + 1] / (0.5 * c * contacts[k].width());
    }
    return true;
  }

  /// The force of the last solution, lambda = -P z, (H+1) x Nc [N].
  [[nodiscard]] Eigen::MatrixXcd force() const {
    const ContactReceptance& receptance = equations_.receptance;
    Eigen::MatrixXcd lambda = Eigen::MatrixXcd::Zero(receptance.harmonics() + 1, receptance.contacts());
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const Eigen::VectorXd weighted =
          nodes_[k].weight.cwiseProduct(solution_.segment(first_[k], nodes_[k].weight.size()));
      lambda.col(contacts_[k].contact) -= nodes_[k].phases.adjoint() * weighted;
    }
    return lambda;
  }

 private:
  /// z_k + integral Q z_l - c s_k = c (x_f - g): the part of contact l, and the right-hand side.
  void add_answer(std::size_t k, std::size_t l) {
    const ClosedNodes& here = nodes_[k];
    const ClosedNodes& there = nodes_[l];
    const Eigen::VectorXcd symbol = doubled_symbol(equations_, contacts_[k].contact, contacts_[l].contact);
    const Eigen::MatrixXcd answer = here.phases * symbol.asDiagonal();
    // The real part of answer times the conjugate of the other phases.
    const Eigen::MatrixXd product = product_by_transposed(answer.real(), there.phases.real()) +
                                    product_by_transposed(answer.imag(), there.phases.imag());
    matrix_.block(first_[k], first_[l], here.weight.size(), there.weight.size()) +=
        product * there.weight.asDiagonal();
  }

  void add_border(std::size_t k) {
    const auto& [receptance, gap, law] = equations_;
    const ClosedContact& contact = contacts_[k];
    const ClosedNodes& here = nodes_[k];
    const Eigen::Index count = here.weight.size();
    Eigen::VectorXcd free = 2.0 * receptance.free_response.col(contact.contact);
    free[0] = receptance.free_response(0, contact.contact).real() - gap[contact.contact];
    load_.segment(first_[k], count) = law.constant[contact.contact] * (here.phases * free).real();
    const Eigen::VectorXd scaled = here.since / (0.5 * contact.width());
    const Eigen::Index place = border_ + 2 * static_cast<Eigen::Index>(k);
    matrix_.col(place).segment(first_[k], count).setConstant(-1.0);
    matrix_.col(place + 1).segment(first_[k], count) = -scaled;
    matrix_.row(place).segment(first_[k], count) = here.weight.transpose() / contact.width();
    matrix_.row(place + 1).segment(first_[k], count) =
        here.weight.cwiseProduct(scaled).transpose() / contact.width();
    load_[place] = contact.force / contact.width();
  }

  const ProjectedEquations& equations_;
  const std::vector<ClosedContact>& contacts_;
  std::vector<Eigen::Index> first_;
  std::vector<ClosedNodes> nodes_;
  Eigen::Index border_ = 0;
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd load_;
  Eigen::VectorXd solution_;
};

/// The zero of y_k on one side of the impact, relative to t_k: y, positive at the centre, is followed
/// outwards to its change of sign, and that polished. Where it stays positive for as long as `reach`, this
/// end.
double edge_of_contact(const Eigen::VectorXcd& y, double constant, const ClosedContact& contact,
                       double reach) {
  constexpr int kStretches = 16;
  const auto at = [&](double since) {
    Jet jet = trigonometric_jet(y, contact.time + since);
    jet.value += constant * (contact.distance + contact.speed * since);
    jet.slope += constant * contact.speed;
    return jet;
  };
  double inside = 0.0;
  double outside = reach / kStretches;
  for (int k = 1; k < kStretches && at(outside).value > 0.0; ++k) {
    inside = outside;
    outside = (k + 1.0) * reach / kStretches;
  }
  constexpr double kSettled = 4.0 * kEpsilon;  // of the period
  return newton_zero_between(at, {.negative = outside, .positive = inside}, kSettled).value_or(reach);
}

/// y = c (x - g) - alpha lambda of one contact, its stop in its place, n = 0..H [N].
Eigen::VectorXcd multiplier_of(const ProjectedEquations& equations, int contact, const Eigen::MatrixXcd& x,
                               const Eigen::MatrixXcd& lambda) {
  const ProjectedLaw& law = equations.law;
  Eigen::VectorXcd y =
      law.constant[contact] * x.col(contact) - law.multiplier_weight[contact] * lambda.col(contact);
  y[0] -= law.constant[contact] * equations.gap[contact];
  return y;
}

/// Moves the edges of every contact to where y of the new force vanishes, by at most twice the width; where y
/// is negative at the centre, the contact is halved. Returns the largest way of an edge relative to the
/// width.
double move_edges(const ProjectedEquations& equations, const Eigen::MatrixXcd& lambda,
                  std::vector<ClosedContact>& contacts) {
  const Eigen::MatrixXcd x = contact_motion(equations.receptance, lambda);
  double way = 0.0;
  for (ClosedContact& contact : contacts) {
    const Eigen::VectorXcd y = multiplier_of(equations, contact.contact, x, lambda);
    const double constant = equations.law.constant[contact.contact];
    const double width = contact.width();
    double begin = 0.5 * contact.begin;
    double end = 0.5 * contact.end;
    if (trigonometric_jet(y, contact.time).value + constant * contact.distance > 0.0) {
      begin = edge_of_contact(y, constant, contact, -2.0 * width);
      end = edge_of_contact(y, constant, contact, 2.0 * width);
    }
    way = std::max({way, std::abs(begin - contact.begin) / width, std::abs(end - contact.end) / width});
    contact.begin = begin;
    contact.end = end;
  }
  return way;
}

/// Contacts as a mass at rest before a spring c has them, 1 / (2 sqrt(c a)) of the period: half of a
/// vibration. In the series they last for a sixth longer.
std::vector<ClosedContact> first_contacts(const ProjectedEquations& equations,
                                          const PeriodicImpacts& impacts) {
  constexpr double kLonger = 7.0 / 6.0;
  const ContactReceptance& receptance = equations.receptance;
  const double highest = receptance.harmonics();
  std::vector<ClosedContact> contacts;
  for (int k = 0; k < impacts.count(); ++k) {
    const int c = impacts.contacts[static_cast<std::size_t>(k)];
    const double inertance = highest * highest * std::abs(receptance.receptance.back()(c, c));
    const double duration = kLonger * 0.5 / std::sqrt(equations.law.constant[c] * inertance);
    const double half = 0.5 * std::min(duration, 1.0 / highest);
    contacts.push_back({.contact = c,
                        .time = impacts.moments(0, k),
                        .force = impacts.moments(1, k),
                        .begin = -half,
                        .end = half});
  }
  return contacts;
}

StopShift moved_stop(const ClosedContact& contact, double moved) {
  // Stored at the middle of the contact, from which its reach is counted.
  const double middle = 0.5 * (contact.begin + contact.end);
  const double time = contact.time + middle;
  StopShift stop{.time = time - std::floor(time),
                 .width = contact.width(),
                 .distance = contact.distance + contact.speed * middle,
                 .speed = contact.speed,
                 .before = 0.5 * contact.width() + moved};
  if (stop.distance + stop.speed * stop.before > 0.0) stop.after = stop.before;
  return stop;
}

/// A residual so near to the tolerance is what rounding left of lambda: with c growing as H^2, y is the
/// difference of numbers that much larger. Newton's method on the equations themselves takes it away, the
/// stops being given.
bool polish_series(const ProjectedEquations& equations, const ExactProjectionSettings& settings,
                   ImpactClosure& closure) {
  constexpr double kNear = 100.0;  // tolerances
  if (!(closure.residual <= kNear * settings.tolerance)) return false;
  ExactProjection series = project_exactly(equations, closure.lambda, settings, closure.shifts);
  closure.steps += series.iterations;
  closure.residual = series.residual;
  closure.lambda = std::move(series.lambda);
  return series.converged;
}

/// Judges lambda with the moved stops on the whole period.
void judge_closure(const ProjectedEquations& equations, const std::vector<ClosedContact>& contacts,
                   const ExactProjectionSettings& settings, ImpactClosure& closure) {
  const int harmonics = equations.receptance.harmonics();
  closure.shifts.resize(static_cast<std::size_t>(equations.receptance.contacts()));
  for (const ClosedContact& contact : contacts) {
    closure.shifts[static_cast<std::size_t>(contact.contact)].push_back(
        moved_stop(contact, kStopMoved / harmonics));
    closure.largest = std::max(closure.largest, std::abs(contact.distance));
  }
  ProjectedResidual whole(equations, settings.samples, settings.tolerance, closure.shifts);
  const Eigen::VectorXd packed = whole.unknowns_of(closure.lambda);
  closure.residual = whole.error(packed, whole.residual(packed));
  std::size_t found = 0;
  for (const auto& intervals : whole.contacts()) found += intervals.size();
  if (found != contacts.size()) {
    closure.failure = "the series touches a stop between the impacts";
  } else if (closure.residual > settings.tolerance && !polish_series(equations, settings, closure)) {
    closure.failure = "the projected equations are not solved";
  } else {
    closure.converged = true;
  }
}

}  // namespace

ImpactClosure close_impacts(const ProjectedEquations& equations, const PeriodicImpacts& impacts,
                            const ExactProjectionSettings& settings, int most) {
  const double longest = kLongestContact / equations.receptance.harmonics();
  // The residual is of second order in the way that the edges still have to go.
  const double enough = 0.1 * std::sqrt(settings.tolerance);
  ImpactClosure closure{.failure = "the steps are used up"};
  std::vector<ClosedContact> contacts = first_contacts(equations, impacts);
  while (closure.steps < most && !settings.deadline.passed()) {
    BorderedSystem system(equations, contacts);
    ++closure.steps;
    if (!system.solve(contacts, closure.condition)) {
      closure.failure = "the bordered matrix is singular";
      return closure;
    }
    closure.lambda = system.force();
    const double way = move_edges(equations, closure.lambda, contacts);
    const auto lasts = [&](const ClosedContact& contact) { return contact.width() > longest; };
    if (std::ranges::any_of(contacts, lasts)) {
      closure.failure = "a contact of the series lasts";
      return closure;
    }
    if (way <= enough) {
      closure.failure = {};
      judge_closure(equations, contacts, settings, closure);
      return closure;
    }
  }
  return closure;
}

}  // namespace signorini
