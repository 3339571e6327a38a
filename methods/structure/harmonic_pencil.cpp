#include "methods/structure/harmonic_pencil.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "methods/solvers/constants.hpp"
#include "methods/solvers/dense_products.hpp"
#include "methods/structure/dynamic_stiffness.hpp"
#include "problems/linear_algebra/complex_lu.hpp"
#include "problems/linear_algebra/products.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

/// Columns of a sparse matrix, appended one by one.
struct ColumnList {
  std::vector<Eigen::Triplet<double>> entries;
  int count = 0;

  // The column of `part`, or -1 if that is zero.
  int add(const Eigen::VectorXd& part) {
    if (part.isZero(0.0)) return -1;
    for (int i = 0; i < part.size(); ++i) {
      if (part[i] != 0.0) entries.emplace_back(i, count, part[i]);
    }
    return count++;
  }
};

}  // namespace

PencilLoads pencil_loads(const Problem& problem, int harmonics, const WeightsOfHarmonic& weights) {
  const int contacts = problem.contact_count();
  ColumnList list;
  for (const Contact& contact : problem.contacts) {
    for (const auto& [dof, coefficient] : contact.normal)
      list.entries.emplace_back(dof, list.count, coefficient);
    ++list.count;
  }
  std::vector<std::pair<int, int>> places;  // columns of real and imaginary part
  const int loaded = std::min(harmonics, load_bandwidth(problem));
  for (int n = 0; n <= loaded; ++n) {
    const Eigen::VectorXcd load = weights(n).load * load_coefficient(problem, n);
    const int real = list.add(load.real());
    places.emplace_back(real, list.add(load.imag()));
  }
  PencilLoads loads;
  loads.columns = SparseMatrix(problem.size(), list.count);
  loads.columns.setFromTriplets(list.entries.begin(), list.entries.end());
  loads.weight.resize(static_cast<std::size_t>(harmonics) + 1);
  for (std::size_t n = 0; n < places.size(); ++n) {
    const auto [real, imaginary] = places[n];
    if (real < 0 && imaginary < 0) continue;
    loads.weight[n] = Eigen::VectorXcd::Zero(list.count - contacts);
    if (real >= 0) loads.weight[n][real - contacts] = 1.0;
    if (imaginary >= 0) loads.weight[n][imaginary - contacts] = Complex(0.0, 1.0);
  }
  return loads;
}

std::vector<HarmonicPencil> harmonic_pencils(const ProportionalDamping& damping, double shift, int harmonics,
                                             const WeightsOfHarmonic& weights, const PencilLoads& loads) {
  std::vector<HarmonicPencil> pencils;
  for (int n = 0; n <= harmonics; ++n) {
    const HarmonicWeights w = weights(n);
    HarmonicPencil pencil{.kappa = w.stiffness + w.damping * damping.beta,
                          .mu = 0.0,
                          .load = loads.weight[static_cast<std::size_t>(n)]};
    const Complex inertia = w.mass + w.damping * damping.alpha;
    if (shift > 0.0 && inertia == 0.0) throw SingularStiffness();
    pencil.mu = inertia - shift * pencil.kappa;
    pencils.push_back(std::move(pencil));
  }
  return pencils;
}

double distance_from_singular(const HarmonicPencil& pencil, const Eigen::VectorXd& theta) {
  const double top = theta.maxCoeff();
  // The nearest point to the origin of the straight line of kappa + mu theta, 0 <= theta <= top.
  const double size = std::norm(pencil.mu);
  const double nearest =
      size > 0.0 ? std::clamp(-(std::conj(pencil.mu) * pencil.kappa).real() / size, 0.0, top) : 0.0;
  const double least = std::abs(pencil.kappa + pencil.mu * nearest);
  const double scale = std::abs(pencil.kappa) + std::abs(pencil.mu) * top;
  if (least > kMatrixRounding * scale) return least;  // else it is undamped
  return (pencil.kappa + pencil.mu * theta.array().cast<Complex>()).abs().minCoeff();
}

Eigen::MatrixXcd start_columns(const HarmonicPencil& pencil, const Eigen::MatrixXd& rows, int contacts) {
  const bool loaded = pencil.load.size() > 0;
  Eigen::MatrixXcd columns(rows.rows(), contacts + (loaded ? 1 : 0));
  columns.leftCols(contacts) = rows.leftCols(contacts).cast<Complex>();
  if (loaded) columns.col(contacts) = image_in_complex(rows.rightCols(pencil.load.size()), pencil.load);
  return columns;
}

PencilElimination::PencilElimination(const BlockLanczos& space, const std::vector<HarmonicPencil>& pencils,
                                     int contacts)
    : space_(space), pencils_(pencils), contacts_(contacts), fronts_(pencils.size()) {
  for (std::size_t n = 0; n < pencils_.size(); ++n) {
    Front& front = fronts_[n];
    front.rest = start_columns(pencils_[n], space_.projected_start(), contacts_);
    front.pivot = Eigen::MatrixXcd::Zero(space_.size(), space_.size());
    front.seen = Eigen::MatrixXcd::Zero(contacts_, contacts_);
  }
  take_newest_block();
}

void PencilElimination::take_newest_block() {
  const Eigen::MatrixXcd newest = space_.newest_mass().cast<std::complex<double>>();
  for (std::size_t n = 0; n < pencils_.size(); ++n) {
    if (fronts_[n].converged) continue;
    fronts_[n].pivot += pencils_[n].mu * newest;
    fronts_[n].pivot.diagonal().array() += pencils_[n].kappa;
  }
}

bool PencilElimination::advance(double tolerance, const Eigen::VectorXd& theta) {
  const Eigen::MatrixXcd coupling = space_.coupling().cast<std::complex<double>>();
  bool converged = true;
  for (std::size_t n = 0; n < pencils_.size(); ++n) {
    if (!fronts_[n].converged) {
      const double least = tolerance * distance_from_singular(pencils_[n], theta);
      advance(fronts_[n], pencils_[n], coupling, least);
    }
    converged = converged && fronts_[n].converged;
  }
  return converged;
}

void PencilElimination::advance(Front& front, const HarmonicPencil& pencil, const Eigen::MatrixXcd& coupling,
                                double least) const {
  const ComplexLuFactors factors(front.pivot);
  const Eigen::MatrixXcd newest = factors.solve(front.rest);
  // What M carries out of the space is P-orthogonal to it: the residual, and the next block's right-hand
  // side.
  const Eigen::MatrixXcd outside = complex_product(-pencil.mu, coupling, newest);
  front.seen += complex_product_of_transposed(front.rest.leftCols(contacts_), newest.leftCols(contacts_));
  double error = outside.leftCols(contacts_).squaredNorm() / (least * front.seen.norm());
  if (pencil.load.size() > 0) {
    front.self += front.rest.col(contacts_).cwiseProduct(newest.col(contacts_)).sum();
    error = std::max(error, outside.col(contacts_).squaredNorm() / (least * std::abs(front.self)));
  }
  front.converged = error <= 1.0;
  front.rest = outside;
  // Schur complement of the block just eliminated; the next diagonal block is added when the space has grown.
  front.pivot = complex_product(-pencil.mu * pencil.mu, coupling,
                                factors.solve(Eigen::MatrixXcd(coupling.transpose())));
}

PencilModes::PencilModes(const BlockLanczos& space, int contacts)
    : contacts_(contacts), left_out_of_start_(space.left_out_of_start()) {
  const RitzPairs modes = ritz_pairs(space);
  theta_ = modes.values;
  rows_ = product_of_transposed(modes.vectors, space.projected_start());
  contact_rows_ = rows_.leftCols(contacts);
  seen_ = contact_rows_.transpose();
  outside_ = product(space.coupling(), modes.vectors.bottomRows(space.coupling().cols()));
  left_out_ = product(space.left_out(), modes.vectors);
}

std::optional<Eigen::VectorXcd> PencilModes::inverse_of(const HarmonicPencil& pencil) const {
  const Eigen::VectorXcd z = pencil.kappa + (pencil.mu * theta_.array().cast<Complex>()).array();
  const double scale = std::abs(pencil.kappa) + std::abs(pencil.mu) * theta_.maxCoeff();
  if (!(z.cwiseAbs().minCoeff() > std::numeric_limits<double>::epsilon() * scale)) return std::nullopt;
  return Eigen::VectorXcd(z.cwiseInverse());
}

Eigen::MatrixXcd PencilModes::receptance(const Eigen::VectorXcd& inverse) const {
  return scaled_product(seen_, inverse, contact_rows_);
}

Eigen::VectorXcd PencilModes::free_response(const HarmonicPencil& pencil,
                                            const Eigen::VectorXcd& inverse) const {
  return image_of_complex(seen_, inverse.cwiseProduct(load_of(pencil)));
}

Eigen::VectorXcd PencilModes::load_of(const HarmonicPencil& pencil) const {
  return image_in_complex(rows_.rightCols(pencil.load.size()), pencil.load);
}

PencilModes::Error PencilModes::relative_error(const HarmonicPencil& pencil) const {
  const std::optional<Eigen::VectorXcd> found = inverse_of(pencil);
  if (!found) return {kInfinity, kInfinity};
  const Eigen::VectorXcd& inverse = *found;
  const double nearest = distance_from_singular(pencil, theta_), turn = std::abs(pencil.mu);
  Error error;
  // What is not a number bounds nothing.
  const auto take_larger = [](double& bound, double value) {
    bound = std::isnan(value) ? kInfinity : std::max(bound, value);
  };
  const auto add = [&](double outside, double left_out, double scale) {
    if (scale == 0.0) return;
    take_larger(error.all, (outside + left_out) * (outside + left_out) / (nearest * scale));
    take_larger(error.outside, outside * outside / (nearest * scale));
  };
  // rho of all columns of W.
  const auto of_contacts = [&](const Eigen::MatrixXd& rows) {
    return rows.rows() == 0 ? 0.0 : turn * scaled_product(rows, inverse, contact_rows_).norm();
  };
  add(of_contacts(outside_), of_contacts(left_out_) + left_out_of_start_.leftCols(contacts_).norm(),
      receptance(inverse).norm());
  if (pencil.load.size() == 0) return error;
  const Eigen::VectorXcd load = load_of(pencil), y = inverse.cwiseProduct(load);
  add(turn * image_of_complex(outside_, y).norm(),
      turn * image_of_complex(left_out_, y).norm() +
          image_of_complex(left_out_of_start_.rightCols(pencil.load.size()), pencil.load).norm(),
      std::abs(load.dot(y)));
  return error;
}

}  // namespace signorini
