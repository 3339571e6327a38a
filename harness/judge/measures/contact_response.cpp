#include "harness/judge/measures/contact_response.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "methods/solvers/constants.hpp"
#include "methods/structure/receptance.hpp"
#include "methods/structure/rigid_motions.hpp"
#include "problems/linear_algebra/orthogonal.hpp"
#include "problems/matrix_properties.hpp"
#include "problems/sparse_cholesky.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

// Error of what a ContactSpace says of x, relative to its size, and of the contact's work, relative to that
// of the load: far below any defect of energy that means something [-].
constexpr double kSpaceTolerance = 1e-8, kWorkTolerance = 1e-6;
// Work of a load relative to what it could do, below which it does none.
constexpr double kNoWork = 1e-12;

// 2 pi n.
Eigen::ArrayXd turns(Eigen::Index harmonics) {
  return Eigen::ArrayXd::LinSpaced(harmonics, 0.0, kTwoPi * static_cast<double>(harmonics - 1));
}

// Work per period of each force on the displacement it acts on, T * 2 Re(conj(f_n) i n w u_n) summed over n.
Eigen::VectorXd work(const Eigen::MatrixXcd& force, const Eigen::MatrixXcd& displacement) {
  const Eigen::MatrixXd power = force.conjugate().cwiseProduct(displacement).imag();
  return -2.0 * (power.transpose() * turns(force.rows()).matrix());
}

// M, and 1 kg on coordinates without mass that no contact touches: no impulse reaches them.
SparseMatrix inertia_of_impulses(const Problem& problem) {
  SparseMatrix inertia = problem.mass();
  Eigen::VectorXd missing = Eigen::VectorXd::Ones(problem.size());
  for (int column = 0; column < inertia.outerSize(); ++column)
    for (SparseMatrix::InnerIterator entry(inertia, column); entry; ++entry)
      if (entry.value() != 0.0) missing[column] = 0.0;
  for (const Contact& contact : problem.contacts)
    for (const auto& [dof, weight] : contact.normal) missing[dof] = 0.0;
  for (int i = 0; i < problem.size(); ++i)
    if (missing[i] > 0.0) inertia.coeffRef(i, i) = 1.0;
  inertia.makeCompressed();
  return inertia;
}

}  // namespace

ContactResponse::ContactResponse(const Problem& problem, ForceSeries series, const ContactSpace* space) {
  base_frequency_ = series.base_frequency;
  lambda_ = std::move(series.lambda);
  const LoadColumns load = load_columns(problem);
  load_ = load.coefficients(base_frequency_, static_cast<int>(lambda_.rows()) - 1);
  x_ = free_ = Eigen::MatrixXcd::Zero(lambda_.rows(), lambda_.cols());
  q_ = free_q_ = Eigen::MatrixXcd::Zero(load_.rows(), load_.cols());
  if (space != nullptr && space->obstacle().empty()) {
    if (take(*space) || take_grown(*space)) return;
    static_cast<void>(space->release());  // what follows factorises too
  }
  if (problem.size() <= kMostFactorised || !project(problem, load)) factorise(problem, load);
}

bool ContactResponse::take(const ContactSpace& space) {
  const Eigen::MatrixXcd none = Eigen::MatrixXcd::Zero(lambda_.rows(), lambda_.cols());
  ContactSpace::PortMotion moved = space.motion(base_frequency_, lambda_);
  ContactSpace::PortMotion free = space.motion(base_frequency_, none);
  const Eigen::VectorXd error = space.bound(base_frequency_, lambda_);
  const Eigen::VectorXd free_error = space.bound(base_frequency_, none);
  const double contacts = static_cast<double>(lambda_.cols());
  const auto known = [&](const Eigen::MatrixXcd& x, const Eigen::VectorXd& bound) {
    return std::sqrt(contacts) * bound.norm() <= kSpaceTolerance * x.norm();
  };
  if (!known(moved.contacts, error) || !known(free.contacts, free_error)) return false;
  x_ = std::move(moved.contacts);
  q_ = std::move(moved.loads);
  free_ = std::move(free.contacts);
  free_q_ = std::move(free.loads);
  dissipation_ = work_of_load() + contact_work().sum();
  return missed_work(space) <= most_missed();
}

double ContactResponse::missed_work(const ContactSpace& space) const {
  return 2.0 * turns(lambda_.rows()).matrix().dot(space.work_bound(base_frequency_, lambda_));
}

// Of a load that does no work nothing is asked: no defect of energy is measured by it.
double ContactResponse::most_missed() const {
  return load_works() ? kWorkTolerance * std::abs(work_of_load()) : std::numeric_limits<double>::infinity();
}

// With the vectors that these forces need: the bounds of x hold where the root of the mean square of the
// space's over time is below. The work is missed by what the responses to the force and to its conjugate lack
// together, hence the square root.
bool ContactResponse::take_grown(const ContactSpace& space) {
  constexpr double kMargin = 0.5, kLeast = 1e-12;
  constexpr int kGrowths = 3;
  const Eigen::MatrixXcd none = Eigen::MatrixXcd::Zero(lambda_.rows(), lambda_.cols());
  const double contacts = std::sqrt(static_cast<double>(lambda_.cols()));
  const double size = space.motion(base_frequency_, lambda_).contacts.norm() / contacts;
  const double free = space.motion(base_frequency_, none).contacts.norm() / contacts;
  double tolerance = kMargin * kSpaceTolerance * size;
  for (int growth = 0; growth < kGrowths && tolerance >= kLeast * size; ++growth) {
    std::vector<ContactSpace::Wanted> wanted = {
        {.force = lambda_, .tolerance = tolerance},
        {.force = none, .tolerance = kMargin * kSpaceTolerance * free}};
    if (growth > 0) wanted.push_back({.force = lambda_.conjugate(), .tolerance = tolerance});
    const ContactSpace grown = space.grown_for(base_frequency_, wanted);
    if (take(grown)) return true;
    tolerance *= std::min(kMargin, std::sqrt(kMargin * most_missed() / missed_work(grown)));
  }
  return false;
}

void ContactResponse::factorise(const Problem& problem, const LoadColumns& load) {
  const SparseMatrix W = contact_directions(problem);
  const SparseMatrix F = contact_directions(load.columns, problem.size());
  DynamicStiffness stiffness(problem);
  dissipation_ = 0.0;
  const bool circulates = !is_symmetric(problem.stiffness());
  for (Eigen::Index n = 0; n < x_.rows(); ++n) {
    const double w = static_cast<double>(n) * base_frequency_;
    Eigen::MatrixXcd columns(problem.size(), 2);
    columns << W * lambda_.row(n).transpose(), F * load_.row(n).transpose();
    if (columns.isZero(0.0)) continue;  // no response, whether or not Z_n is singular
    try {
      stiffness.factorise(exact_weights(w));
      columns = stiffness.solve(columns);
    } catch (const SingularStiffness&) {
      if (n > 0 || !hold_mean(problem, columns)) throw;
    }
    free_.row(n) = (W.transpose() * columns.col(1)).transpose();
    free_q_.row(n) = (F.transpose() * columns.col(1)).transpose();
    const Eigen::VectorXcd u = columns.rowwise().sum();
    x_.row(n) = (W.transpose() * u).transpose();
    q_.row(n) = (F.transpose() * u).transpose();
    const Eigen::VectorXcd drag = problem.damping() * u;
    dissipation_ += 2.0 * kTwoPi * static_cast<double>(n) * w * u.dot(drag).real();
    if (!circulates) continue;
    const Eigen::VectorXcd pull = problem.stiffness() * u;
    dissipation_ += 2.0 * kTwoPi * static_cast<double>(n) * u.dot(pull).imag();
  }
}

bool ContactResponse::hold_mean(const Problem& problem, Eigen::MatrixXcd& columns) {
  const Eigen::MatrixXd motions = rigid_motions(problem);
  if (motions.cols() == 0) return false;
  const HeldStructure held(problem, motions, base_frequency_);
  columns = held.solve(columns.real()).cast<Complex>();
  mean_is_free_ = true;
  return true;
}

bool ContactResponse::project(const Problem& problem, const LoadColumns& load) {
  Problem unloaded;  // what the projection looks at: contacts first, then the columns of the load
  unloaded.structure = problem.structure;
  unloaded.frequency = problem.frequency;
  unloaded.subharmonic = problem.subharmonic;
  unloaded.contacts = problem.contacts;
  unloaded.contacts.insert(unloaded.contacts.end(), load.columns.begin(), load.columns.end());
  const auto weights = [this](int n) { return exact_weights(n * base_frequency_); };
  const auto seen = reduced_receptance(unloaded, harmonics(), weights, kReducedTolerance);
  if (!seen) return false;
  const Eigen::Index contacts = lambda_.cols();
  for (Eigen::Index n = 0; n < x_.rows(); ++n) {
    const Eigen::MatrixXcd& C = seen->value.receptance[static_cast<std::size_t>(n)];
    const Eigen::VectorXcd loaded = C.rightCols(load_.cols()) * load_.row(n).transpose();
    const Eigen::VectorXcd all = C.leftCols(contacts) * lambda_.row(n).transpose() + loaded;
    free_.row(n) = loaded.head(contacts).transpose();
    free_q_.row(n) = loaded.tail(load_.cols()).transpose();
    x_.row(n) = all.head(contacts).transpose();
    q_.row(n) = all.tail(load_.cols()).transpose();
  }
  dissipation_ = work_of_load() + contact_work().sum();
  return true;
}

Eigen::MatrixXd ContactResponse::displacement(int count) const { return sample_series(x_, count); }

Eigen::MatrixXd ContactResponse::free_displacement(int count) const { return sample_series(free_, count); }

double ContactResponse::work_of_load() const { return work(load_, q_).sum(); }

bool ContactResponse::load_works() const {
  return std::abs(work_of_load()) > kNoWork * largest_work_of_load();
}

double ContactResponse::largest_work_of_load() const {
  const Eigen::VectorXd force = 2.0 * (load_.cwiseAbs().transpose() * turns(load_.rows()).matrix());
  const auto reach = [](const Eigen::MatrixXcd& q) {
    return q.cwiseAbs().colwise().sum().transpose().eval();
  };
  return force.dot(2.0 * reach(q_).cwiseMax(reach(free_q_)));
}

Eigen::VectorXd ContactResponse::contact_work() const { return work(lambda_, x_); }

double ContactResponse::dissipation() const { return dissipation_; }

Eigen::VectorXd rigid_offset(const Problem& problem, const Eigen::VectorXd& x) {
  const Eigen::MatrixXd motions = rigid_motions(problem);
  const Eigen::MatrixXd at_contacts = contact_directions(problem).transpose() * motions;
  if (motions.cols() == 0) return Eigen::VectorXd::Zero(problem.size());
  if (x.size() == 0 || PivotedQr(at_contacts).rank() < motions.cols())
    throw std::runtime_error("the mean of a part that neither springs nor contacts reach is open");
  return motions * full_rank_least_squares(at_contacts, x);
}

Eigen::MatrixXd velocity_jumps(const Problem& problem) {
  const SparseMatrix inertia = inertia_of_impulses(problem);
  if (!is_definite(inertia)) throw std::invalid_argument("an impulse meets coordinates without mass");
  return SparseCholesky(inertia).solve(Eigen::MatrixXd(contact_directions(problem)));
}

std::optional<Eigen::MatrixXd> contact_free_motion(const Problem& problem, int count,
                                                   const ContactSpace* space) {
  const Eigen::Index harmonics = load_bandwidth(problem) + 1;
  try {
    const ContactResponse response(problem,
                                   {.order = problem.subharmonic,
                                    .base_frequency = problem.base_frequency(),
                                    .lambda = Eigen::MatrixXcd::Zero(harmonics, problem.contact_count())},
                                   space);
    if (response.mean_is_free()) return std::nullopt;
    Eigen::MatrixXd free = response.free_displacement(count);
    return free.allFinite() ? std::optional(std::move(free)) : std::nullopt;
  } catch (const SingularStiffness&) {
    return std::nullopt;
  }
}

}  // namespace signorini
