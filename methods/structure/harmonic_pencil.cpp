#include "methods/structure/harmonic_pencil.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "methods/structure/dynamic_stiffness.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

// Damping relative to stiffness and inertia below which it is rounding.
constexpr double kUndamped = 1e-12;

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

PencilDistance distance_from_singular(const HarmonicPencil& pencil, const Eigen::VectorXd& theta) {
  const double top = theta.maxCoeff();
  // The nearest point to the origin of the straight line of kappa + mu theta, 0 <= theta <= top.
  const double size = std::norm(pencil.mu);
  const double nearest =
      size > 0.0 ? std::clamp(-(std::conj(pencil.mu) * pencil.kappa).real() / size, 0.0, top) : 0.0;
  const double least = std::abs(pencil.kappa + pencil.mu * nearest);
  const double scale = std::abs(pencil.kappa) + std::abs(pencil.mu) * top;
  if (least > kUndamped * scale) return {least, true};
  return {(pencil.kappa + (pencil.mu * theta.array().cast<Complex>())).abs().minCoeff(), false};
}

}  // namespace signorini
