#include "methods/structure/bases/ritz_reduction.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <utility>
#include <vector>

#include "methods/solvers/constants.hpp"
#include "methods/solvers/dense_products.hpp"
#include "problems/linear_algebra/products.hpp"
#include "problems/linear_algebra/sparse/sparse_products.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"

namespace signorini {

namespace {

// 1 / omega^2 relative to the largest, below which a Ritz value is rounding: its vector moves statically.
constexpr double kStatic = 1e-13;

/// Numbers that are added up side by side.
using Lanes = Eigen::Array4d;
constexpr Eigen::Index kLanes = 4;

/// high + low = x, each of half the digits [ogita2005].
struct Halves {
  Lanes high, low;
  EIGEN_ALWAYS_INLINE explicit Halves(const Lanes& x) {
    constexpr double kSplit = 134217729.0;  // 2^27 + 1
    const Lanes scaled = kSplit * x;
    high = scaled - (scaled - x);
    low = x - high;
  }
};

/// Sums in twice the precision of their terms [ogita2005]. Where a processor has no fused multiply-add that
/// every build may use, std::fma is a call for each number: halves give the same rounding of a product.
struct LongSums {
  Lanes high = Lanes::Zero(), low = Lanes::Zero();
  EIGEN_ALWAYS_INLINE void add(const Lanes& a, const Halves& of_a, const Lanes& b) {
    const Halves of_b(b);
    const Lanes product = a * b;
    Lanes rounding = of_a.high * of_b.high - product;
    rounding += of_a.high * of_b.low;
    rounding += of_a.low * of_b.high;
    rounding += of_a.low * of_b.low;
    const Lanes sum = high + product, part = sum - high;
    low += ((high - (sum - part)) + (product - part)) + rounding;
    high = sum;
  }
};

/// Columns by rows: those of V from `first` on, zero beyond the last.
using LaneRows = Eigen::Matrix<double, kLanes, Eigen::Dynamic>;
LaneRows lanes_of(const Eigen::MatrixXd& V, Eigen::Index first) {
  LaneRows rows = LaneRows::Zero(kLanes, V.rows());
  const Eigen::Index count = std::min(kLanes, V.cols() - first);
  rows.topRows(count) = V.middleCols(first, count).transpose();
  return rows;
}

/// V^T A V for symmetric A, sums in twice the precision.
Eigen::MatrixXd long_projection(const SparseMatrix& A, const Eigen::MatrixXd& V) {
  const Eigen::Index count = V.cols();
  Eigen::MatrixXd result(count, count);
  for (Eigen::Index first = 0; first < count; first += kLanes) {
    const LaneRows lanes = lanes_of(V, first);
    // Row i of V^T (A V_j), j the columns in these lanes.
    std::vector<LongSums> sums(static_cast<std::size_t>(count));
    for (int row = 0; row < A.outerSize(); ++row) {
      LongSums moved;
      for (SparseMatrix::InnerIterator it(A, row); it; ++it) {
        const Lanes value = Lanes::Constant(it.value());
        moved.add(value, Halves(value), lanes.col(it.row()).array());
      }
      const Halves of_moved(moved.high);
      for (Eigen::Index i = 0; i < count; ++i) {
        LongSums& sum = sums[static_cast<std::size_t>(i)];
        sum.add(moved.high, of_moved, Lanes::Constant(V(row, i)));
        sum.low += V(row, i) * moved.low;
      }
    }
    for (Eigen::Index i = 0; i < count; ++i) {
      const LongSums& sum = sums[static_cast<std::size_t>(i)];
      const Lanes row = sum.high + sum.low;
      for (Eigen::Index j = first; j < std::min(count, first + kLanes); ++j) result(i, j) = row[j - first];
    }
  }
  return 0.5 * (result + result.transpose());
}

}  // namespace

SparseMatrix side_by_side(const SparseMatrix& A, const SparseMatrix& B) {
  SparseMatrix both(A.rows(), A.cols() + B.cols());
  both.reserve(A.nonZeros() + B.nonZeros());
  for (const SparseMatrix* part : {&A, &B}) {
    const int first = part == &A ? 0 : static_cast<int>(A.cols());
    for (int column = 0; column < part->outerSize(); ++column) {
      both.startVec(first + column);
      for (SparseMatrix::InnerIterator it(*part, column); it; ++it)
        both.insertBackByOuterInner(first + column, static_cast<int>(it.row())) = it.value();
    }
  }
  both.finalize();
  return both;
}

Eigen::MatrixXd random_columns(Eigen::Index n, Eigen::Index k) {
  std::mt19937 random(1);
  const double range = static_cast<double>(std::mt19937::max()) + 1.0;
  Eigen::MatrixXd columns(n, k);
  for (double& entry : columns.reshaped()) entry = static_cast<double>(random()) / range - 0.5;
  return columns;
}

SparseMatrix ContactColumns::all() const { return side_by_side(normals, pushes); }

Eigen::MatrixXcd LoadColumns::coefficients(double base, int harmonics) const {
  Eigen::MatrixXcd result = Eigen::MatrixXcd::Zero(harmonics + 1, weight.rows());
  for (std::size_t h = 0; h < rates.size(); ++h) {
    const long n = std::lround(rates[h] / base);
    if (n > harmonics) continue;
    for (Eigen::Index c = 0; c < weight.rows(); ++c)
      result(n, c) += (n == 0 ? 1.0 : 0.5) * weight(c, static_cast<Eigen::Index>(h));
  }
  return result;
}

LoadColumns load_columns(const Problem& problem) {
  using Complex = std::complex<double>;
  LoadColumns result;
  std::vector<std::pair<Eigen::Index, Complex>> entries;  // of weight: the harmonic of each column
  const auto add = [&](const Eigen::VectorXd& shape, Complex unit) {
    const double length = shape.norm();
    if (length == 0.0) return;
    Contact& column = result.columns.emplace_back();
    for (int dof = 0; dof < shape.size(); ++dof) {
      if (shape[dof] != 0.0) column.normal.emplace_back(dof, shape[dof] / length);
    }
    entries.emplace_back(std::ssize(result.rates) - 1, unit * length);
  };
  for (int h = 0; h <= highest_load_harmonic(problem); ++h) {
    const Eigen::VectorXcd load = load_harmonic(problem, h);
    if (h > 0 && load.isZero(0.0)) continue;
    result.rates.push_back(h * problem.frequency);
    add(load.real(), 1.0);
    add(load.imag(), Complex(0.0, 1.0));
  }
  result.weight = Eigen::MatrixXcd::Zero(std::ssize(entries), std::ssize(result.rates));
  for (std::size_t c = 0; c < entries.size(); ++c)
    result.weight(static_cast<Eigen::Index>(c), entries[c].first) = entries[c].second;
  return result;
}

ContactColumns contact_columns(const Problem& problem) {
  ContactColumns result;
  const auto damping = proportional_damping(*problem.structure);
  if (!damping) {
    result.obstacle = "the damping is not a combination of mass and stiffness";
    return result;
  }
  result.damping = *damping;
  result.load = load_columns(problem);
  // The load's columns are ports as contacts are.
  Problem ports;
  ports.structure = problem.structure;
  ports.contacts = problem.contacts;
  ports.contacts.insert(ports.contacts.end(), result.load.columns.begin(), result.load.columns.end());
  MasslessElimination seen = eliminate_massless(ports);
  result.obstacle = std::move(seen.obstacle);
  if (!result.obstacle.empty()) return result;
  const SparseMatrix columns = sparse_product(coordinate_selection(seen.kept, problem.size()), seen.normals);
  const Eigen::Index contacts = problem.contact_count();
  result.normals = sparse_columns(columns, 0, contacts);
  result.pushes = sparse_columns(columns, contacts, columns.cols() - contacts);
  result.compliance = std::move(seen.massless_compliance);
  if (!seen.massless.empty())
    result.following = sparse_product(coordinate_selection(seen.massless, problem.size()), seen.following);
  result.with_mass = std::ssize(seen.kept);
  if (columns.cols() == 0) result.obstacle = "nothing acts on the structure";
  return result;
}

SpaceProjection projection_from_start(const BlockLanczos& space, Eigen::Index contacts) {
  const Eigen::MatrixXd rows = space.projected_start();
  RitzPairs pairs = ritz_pairs(space);
  return {.pairs = pairs,
          .ritz = pairs.vectors,
          .contacts = rows.leftCols(contacts),
          .loads = rows.rightCols(rows.cols() - contacts),
          .outside = Eigen::MatrixXd::Zero(rows.cols(), rows.cols())};
}

double refine_lowest(const Problem& problem, const BlockLanczos& space, const ContactColumns& columns,
                     SpaceProjection& projection) {
  constexpr Eigen::Index kRefined = 12;
  RitzPairs& pairs = projection.pairs;
  const Eigen::Index count = pairs.values.size(), lowest = std::min(kRefined, count);
  const Eigen::MatrixXd vectors = space.combined(pairs.vectors.rightCols(lowest));
  const Eigen::MatrixXd K = long_projection(problem.stiffness(), vectors);
  const Eigen::MatrixXd M = long_projection(problem.mass(), vectors);
  projection.contacts = product_of_transposed(pairs.vectors, projection.contacts);
  projection.loads = product_of_transposed(pairs.vectors, projection.loads);
  pairs.vectors = Eigen::MatrixXd::Identity(count, count);
  // M x = theta K x, theta rising as in the pairs.
  const SymmetricEigen refined = generalised_eigen(M, K);
  if (!refined.converged) return 1.0;
  const Eigen::VectorXd wrong = (pairs.values.tail(lowest).cwiseQuotient(refined.values).array() - 1.0).abs();
  const Eigen::MatrixXd better = product(vectors, refined.vectors);
  projection.ritz.rightCols(lowest) = product(projection.ritz.rightCols(lowest), refined.vectors);
  pairs.values.tail(lowest) = refined.values;
  projection.contacts.bottomRows(lowest) = sparse_product_of_transposed(columns.normals, better).transpose();
  projection.loads.bottomRows(lowest) = sparse_product_of_transposed(columns.pushes, better).transpose();
  const double largest = wrong.maxCoeff();
  return std::max({4.0 * kEpsilon, wrong[0], largest * largest});
}

StaticCompliance::StaticCompliance(const Problem& problem, BlockLanczos& space, const ContactColumns& columns)
    : all_(columns.all()), contacts_(columns.normals.cols()) {
  constexpr Eigen::Index kMost = 40;
  const Eigen::Index lowest = std::min(kMost, space.size() / 2), count = all_.cols();
  const Eigen::MatrixXd Q = space.combined(ritz_pairs(space).vectors.rightCols(lowest));
  carried_ = product_by_rows(problem.stiffness(), Q);
  held_ = sparse_product_of_transposed(all_, Q).transpose();
  rest_.resize(count, count);
  for (Eigen::Index first = 0; first < count; first += kMostSolvedAtOnce) {
    const Eigen::Index taken = std::min<Eigen::Index>(kMostSolvedAtOnce, count - first);
    const Eigen::MatrixXd held = held_.middleCols(first, taken);
    const Eigen::MatrixXd moved =
        space.solve(Eigen::MatrixXd(sparse_columns(all_, first, taken)) - dense_product(carried_, held));
    rest_.middleCols(first, taken) = sparse_product_of_transposed(all_, moved) -
                                     product_of_transposed(held_, transposed_product(carried_, moved));
    const Eigen::RowVectorXd inert =
        moved.cwiseProduct(product_by_rows(problem.mass(), moved)).colwise().sum();
    for (Eigen::Index j = 0; j < taken; ++j) {
      const double stiff = rest_(first + j, first + j);
      if (stiff > 0.0) largest_quotient_ = std::max(largest_quotient_, inert[j] / stiff);
    }
  }
  rest_ = (0.5 * (rest_ + rest_.transpose())).eval();
}

SpaceProjection StaticCompliance::projection(const BlockLanczos& space) {
  if (rows_.rows() == 0) {
    rows_.resize(0, all_.cols());
    outside_ = rest_;
  }
  const Eigen::Index known = rows_.rows();
  if (space.size() > known) {
    const Eigen::MatrixXd fresh = space.projected(all_, known);
    const Eigen::MatrixXd without = fresh - dense_product(space.projected(carried_, known), held_);  // V^T B'
    outside_ -= transposed_product(without, without);
    rows_.conservativeResize(space.size(), Eigen::NoChange);
    rows_.bottomRows(fresh.rows()) = fresh;
  }
  RitzPairs pairs = ritz_pairs(space);
  return {.pairs = pairs,
          .ritz = pairs.vectors,
          .contacts = rows_.leftCols(contacts_),
          .loads = rows_.rightCols(rows_.cols() - contacts_),
          .outside = outside_};
}

Eigen::VectorXd StaticCompliance::lengths() const {
  return (held_.colwise().squaredNorm().transpose() + rest_.diagonal()).cwiseMax(0.0).cwiseSqrt();
}

ContactReduction reduction_on(const ContactColumns& columns, const SpaceProjection& space,
                              Eigen::Index most) {
  ContactReduction result;
  const Eigen::Index contacts = columns.normals.cols();
  const Eigen::MatrixXcd& weight = columns.load.weight;
  result.compliance = columns.compliance.topLeftCorner(contacts, contacts);
  result.shift = product_in_complex(columns.compliance.topRightCorner(contacts, weight.rows()), weight);
  result.rates = columns.load.rates;
  const Eigen::VectorXd& theta = space.pairs.values;  // rising
  const Eigen::Index count = theta.size();
  Eigen::Index kept = 0;
  while (kept < std::min(most, count) && theta[count - 1 - kept] > kStatic * theta[count - 1]) ++kept;
  const Eigen::MatrixXd vectors = space.pairs.vectors.rightCols(kept).rowwise().reverse();
  const Eigen::VectorXd omega = theta.tail(kept).reverse().cwiseSqrt().cwiseInverse();
  result.squares = omega.cwiseAbs2();
  result.damp(columns.damping);
  result.rows = omega.asDiagonal() * product_of_transposed(vectors, space.contacts);
  const Eigen::MatrixXd modal = omega.asDiagonal() * product_of_transposed(vectors, space.loads);
  result.load = product_in_complex(modal, weight);
  const Eigen::MatrixXd rest = space.pairs.vectors.leftCols(count - kept);
  const Eigen::MatrixXd left = product_of_transposed(rest, space.contacts);
  const Eigen::MatrixXd pushed = product_of_transposed(left, product_of_transposed(rest, space.loads));
  result.compliance +=
      plus_product_of_transposed(space.outside.topLeftCorner(contacts, contacts), left, left);
  const Eigen::MatrixXd follows = space.outside.topRightCorner(contacts, weight.rows()) + pushed;
  result.shift += product_in_complex(follows, weight);
  return result;
}

}  // namespace signorini
