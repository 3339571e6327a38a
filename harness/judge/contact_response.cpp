#include "harness/judge/contact_response.hpp"

#include <algorithm>
#include <complex>
#include <stdexcept>

#include "methods/solvers/constants.hpp"
#include "methods/structure/receptance.hpp"
#include "problems/matrix_properties.hpp"
#include "problems/sparse_cholesky.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

// 2 pi n.
Eigen::ArrayXd turns(Eigen::Index harmonics) {
  return Eigen::ArrayXd::LinSpaced(harmonics, 0.0, kTwoPi * static_cast<double>(harmonics - 1));
}

// Work per period of each force on the displacement it acts on, T * 2 Re(conj(f_n) i n w u_n) summed over n.
Eigen::VectorXd work(const Eigen::MatrixXcd& force, const Eigen::MatrixXcd& displacement) {
  const Eigen::MatrixXd power = force.conjugate().cwiseProduct(displacement).imag();
  return -2.0 * (power.transpose() * turns(force.rows()).matrix());
}

}  // namespace

/// Where forces act. Each column of F has unit length: the projection gives loads and contacts equal weight.
struct ContactResponse::Ports {
  Ports(const Problem& problem, const ForceSeries& series)
      : contacts(problem.contact_count()), load(series.lambda.rows(), 0) {
    columns = problem.contacts;
    for (int h = 0; h <= highest_load_harmonic(problem); ++h) {
      const Eigen::VectorXcd shape = load_harmonic(problem, h);  // cos - i sin
      const Complex half = h == 0 ? 1.0 : 0.5;
      add(shape.real(), h * series.order, half);
      add(shape.imag(), h * series.order, Complex(0.0, 1.0) * half);
    }
  }

  void add(const Eigen::VectorXd& shape, int harmonic, Complex unit) {
    const double length = shape.norm();
    if (length == 0.0) return;
    Contact& column = columns.emplace_back();
    for (int dof = 0; dof < shape.size(); ++dof) {
      if (shape[dof] != 0.0) column.normal.emplace_back(dof, shape[dof] / length);
    }
    load.conservativeResize(Eigen::NoChange, load.cols() + 1);
    load.rightCols(1).setZero();
    load(harmonic, load.cols() - 1) = unit * length;
  }

  int contacts;
  std::vector<Contact> columns;  // of W, then of F
  Eigen::MatrixXcd load;         // phi
};

ContactResponse::ContactResponse(const Problem& problem, ForceSeries series) {
  base_frequency_ = series.base_frequency;
  const Ports ports(problem, series);
  lambda_ = std::move(series.lambda);
  load_ = ports.load;
  x_ = free_ = Eigen::MatrixXcd::Zero(lambda_.rows(), lambda_.cols());
  q_ = free_q_ = Eigen::MatrixXcd::Zero(load_.rows(), load_.cols());
  if (problem.size() <= kMostFactorised || !project(problem, ports)) factorise(problem, ports);
}

void ContactResponse::factorise(const Problem& problem, const Ports& ports) {
  const SparseMatrix directions = contact_directions(ports.columns, problem.size());
  const SparseMatrix W = directions.leftCols(ports.contacts);
  const SparseMatrix F = directions.rightCols(load_.cols());
  DynamicStiffness stiffness(problem);
  for (Eigen::Index n = 0; n < x_.rows(); ++n) {
    const double w = static_cast<double>(n) * base_frequency_;
    Eigen::MatrixXcd columns(problem.size(), 2);
    columns << W * lambda_.row(n).transpose(), F * load_.row(n).transpose();
    stiffness.factorise(exact_weights(w));
    columns = stiffness.solve(columns);
    free_.row(n) = (W.transpose() * columns.col(1)).transpose();
    free_q_.row(n) = (F.transpose() * columns.col(1)).transpose();
    const Eigen::VectorXcd u = columns.rowwise().sum();
    x_.row(n) = (W.transpose() * u).transpose();
    q_.row(n) = (F.transpose() * u).transpose();
    const Eigen::VectorXcd drag = problem.damping() * u;
    dissipation_ += 2.0 * kTwoPi * static_cast<double>(n) * w * u.dot(drag).real();
  }
}

bool ContactResponse::project(const Problem& problem, const Ports& ports) {
  Problem unloaded;  // what the projection looks at
  unloaded.structure = problem.structure;
  unloaded.frequency = problem.frequency;
  unloaded.subharmonic = problem.subharmonic;
  unloaded.contacts = ports.columns;
  const auto weights = [this](int n) { return exact_weights(n * base_frequency_); };
  const auto seen = reduced_receptance(unloaded, harmonics(), weights, kReducedTolerance);
  if (!seen) return false;
  const Eigen::Index contacts = lambda_.cols();
  for (Eigen::Index n = 0; n < x_.rows(); ++n) {
    const Eigen::MatrixXcd& C = seen->receptance[static_cast<std::size_t>(n)];
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

double ContactResponse::largest_work_of_load() const {
  const Eigen::VectorXd force = 2.0 * (load_.cwiseAbs().transpose() * turns(load_.rows()).matrix());
  const auto reach = [](const Eigen::MatrixXcd& q) {
    return q.cwiseAbs().colwise().sum().transpose().eval();
  };
  return force.dot(2.0 * reach(q_).cwiseMax(reach(free_q_)));
}

Eigen::VectorXd ContactResponse::contact_work() const { return work(lambda_, x_); }

double ContactResponse::dissipation() const { return dissipation_; }

Eigen::MatrixXd velocity_jumps(const Problem& problem) {
  if (!is_definite(problem.mass())) throw std::invalid_argument("an impulse meets coordinates without mass");
  return SparseCholesky(problem.mass()).solve(Eigen::MatrixXd(contact_directions(problem)));
}

std::optional<Eigen::MatrixXd> contact_free_motion(const Problem& problem, int count) {
  const Eigen::Index harmonics = load_bandwidth(problem) + 1;
  try {
    const ContactResponse response(problem,
                                   {.order = problem.subharmonic,
                                    .base_frequency = problem.base_frequency(),
                                    .lambda = Eigen::MatrixXcd::Zero(harmonics, problem.contact_count())});
    return response.free_displacement(count);
  } catch (const SingularStiffness&) {
    return std::nullopt;
  }
}

}  // namespace signorini
