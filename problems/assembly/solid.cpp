#include "problems/assembly/solid.hpp"

#include <Eigen/Core>
#include <algorithm>

#include "problems/linear_algebra/orthogonal.hpp"
#include "problems/linear_algebra/singular_values.hpp"
#include "problems/validation.hpp"

namespace signorini {

namespace {

// For each node those that share an element with it, itself included, rising.
using Neighbours = std::vector<std::vector<int>>;

Neighbours neighbours_of(const SolidMesh& mesh) {
  Neighbours neighbours(mesh.nodes.size());
  for (const ElementList& elements : mesh.solids) {
    for (int element = 0; element < elements.count(); ++element) {
      const std::span<const int> nodes = elements.of(element);
      for (const int node : nodes) {
        auto& near = neighbours[static_cast<std::size_t>(node)];
        near.insert(near.end(), nodes.begin(), nodes.end());
      }
    }
  }
  for (auto& near : neighbours) {
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
  }
  return neighbours;
}

// A sparse matrix of square blocks, `width` coordinates to a node, zero wherever two nodes share an element:
// its place for a block is found by bisection, and no list of triplets is kept, which would be many times it.
class BlockSum {
 public:
  BlockSum(const Neighbours& neighbours, int width) : neighbours_(neighbours), width_(width) {
    const auto size = static_cast<Eigen::Index>(neighbours.size()) * width;
    sum_.resize(size, size);
    Eigen::Index entries = 0;
    for (const auto& near : neighbours) entries += std::ssize(near) * width * width;
    sum_.reserve(entries);
    for (std::size_t node = 0; node < neighbours.size(); ++node) {
      for (int column = 0; column < width; ++column) {
        const Eigen::Index place = static_cast<Eigen::Index>(node) * width + column;
        sum_.startVec(place);
        for (const int other : neighbours[node]) {
          for (int row = 0; row < width; ++row) sum_.insertBack(other * width + row, place) = 0.0;
        }
      }
    }
    sum_.finalize();
  }

  template <class Block>
  void add(int row_node, int column_node, const Block& block) {
    const auto& near = neighbours_[static_cast<std::size_t>(column_node)];
    const auto place = std::ranges::lower_bound(near, row_node) - near.begin();
    for (int column = 0; column < width_; ++column) {
      const Eigen::Index first =
          sum_.outerIndexPtr()[column_node * width_ + column] + static_cast<Eigen::Index>(place) * width_;
      for (int row = 0; row < width_; ++row) sum_.valuePtr()[first + row] += block(row, column);
    }
  }

  [[nodiscard]] const SparseMatrix& sum() const { return sum_; }

 private:
  const Neighbours& neighbours_;
  int width_;
  SparseMatrix sum_;
};

// A scalar per pair of nodes, for each axis by itself.
SparseMatrix on_three_axes(const SparseMatrix& nodal) {
  SparseMatrix whole(3 * nodal.rows(), 3 * nodal.cols());
  whole.reserve(3 * nodal.nonZeros());
  for (int column = 0; column < nodal.outerSize(); ++column) {
    for (int axis = 0; axis < 3; ++axis) {
      whole.startVec(3 * column + axis);
      for (SparseMatrix::InnerIterator entry(nodal, column); entry; ++entry)
        whole.insertBack(3 * entry.row() + axis, 3 * column + axis) = entry.value();
    }
  }
  whole.finalize();
  return whole;
}

using Scalar = Eigen::Matrix<double, 1, 1>;

// Integral of rho N_a N_b over an element, n x n [kg].
Eigen::MatrixXd element_mass(const Solid& solid, const std::vector<ElementPoint>& points) {
  const Eigen::Index n = points.front().values.size();
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(n, n);
  for (const ElementPoint& point : points)
    mass += solid.density * point.volume * point.values * point.values.transpose();
  if (solid.contact_mass != ContactMass::lumped) return mass;
  return (mass.sum() / mass.trace() * mass.diagonal()).asDiagonal();
}

// Nodes without contact along an axis about one with contact, as a follower's leaders.
class MassCarriers {
 public:
  MassCarriers(const Solid& solid, const Neighbours& neighbours)
      : mesh_(*solid.mesh), neighbours_(neighbours), touched_(3 * mesh_.nodes.size(), false) {
    for (const int dof : solid.contacts) touched_[static_cast<std::size_t>(dof + 3 * mesh_.held)] = true;
  }

  // \throws InvalidProblem
  [[nodiscard]] Follower follower(int node, int axis) const {
    constexpr int kMostRings = 4;
    std::vector<int> ring{node};
    for (int rings = 0; rings < kMostRings; ++rings) {
      ring = around(ring);
      std::vector<int> free;
      for (const int other : ring) {
        if (!touched_[static_cast<std::size_t>(3 * other + axis)]) free.push_back(other);
      }
      const Eigen::VectorXd weights = linear_weights(node, free);
      if (weights.size() == 0) continue;
      Follower follower{.dof = 3 * node + axis, .leaders = {}};
      for (std::size_t i = 0; i < free.size(); ++i)
        follower.leaders.emplace_back(3 * free[i] + axis, weights[static_cast<Eigen::Index>(i)]);
      return follower;
    }
    throw InvalidProblem("system.contact_mass", "massless",
                         "must leave nodes without contact, not all in one plane, about every contact, to "
                         "carry its mass");
  }

 private:
  // What shares an element with any of these, rising.
  [[nodiscard]] std::vector<int> around(const std::vector<int>& nodes) const {
    std::vector<int> wider;
    for (const int node : nodes) {
      const auto& near = neighbours_[static_cast<std::size_t>(node)];
      wider.insert(wider.end(), near.begin(), near.end());
    }
    std::ranges::sort(wider);
    wider.erase(std::unique(wider.begin(), wider.end()), wider.end());
    return wider;
  }

  // Weights of least square sum with sum w_i = 1 and sum w_i (x_i - x) = 0; empty where the nodes are in one
  // plane, or so far to one side of x that weights would be large.
  [[nodiscard]] Eigen::VectorXd linear_weights(int node, const std::vector<int>& free) const {
    constexpr double kFlat = 1e-6;     // least extent of the nodes over their largest
    constexpr double kLargest = 10.0;  // sum of magnitudes
    if (free.size() < 4) return {};
    Eigen::Matrix3Xd around(3, std::ssize(free));
    for (std::size_t i = 0; i < free.size(); ++i)
      around.col(static_cast<Eigen::Index>(i)) =
          mesh_.nodes[static_cast<std::size_t>(free[i])] - mesh_.nodes[static_cast<std::size_t>(node)];
    const Eigen::Vector3d middle = around.rowwise().mean();
    const SingularValues shape = left_singular_vectors(around.colwise() - middle);
    const Eigen::Vector3d extents = shape.values.head<3>();
    if (!(extents[2] > kFlat * extents[0])) return {};
    // In units of the extents along their own axes, however thin the elements.
    Eigen::MatrixXd motions(4, around.cols());
    motions.row(0).setOnes();
    motions.bottomRows<3>() = extents.cwiseInverse().asDiagonal() * (shape.U.transpose() * around);
    const Eigen::VectorXd weights = least_norm_solve(motions, Eigen::VectorXd(Eigen::VectorXd::Unit(4, 0)));
    return weights.lpNorm<1>() <= kLargest ? weights : Eigen::VectorXd();
  }

  const SolidMesh& mesh_;
  const Neighbours& neighbours_;
  std::vector<bool> touched_;  // by coordinate, nodes at rest included
};

SparseMatrix mass_of(const Solid& solid, const Neighbours& neighbours) {
  BlockSum sum(neighbours, 1);
  for_each_solid(*solid.mesh, [&](std::span<const int> nodes, const std::vector<ElementPoint>& points) {
    const Eigen::MatrixXd element = element_mass(solid, points);
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      for (std::size_t b = 0; b < nodes.size(); ++b) {
        sum.add(nodes[a], nodes[b],
                Scalar(element(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b))));
      }
    }
  });
  SparseMatrix mass = on_three_axes(sum.sum());
  if (solid.contact_mass == ContactMass::lumped) mass.prune(0.0);
  if (solid.contact_mass != ContactMass::massless || solid.contacts.empty()) return mass;
  const MassCarriers carriers(solid, neighbours);
  std::vector<Follower> followers;
  for (const int dof : solid.contacts) {
    const auto [node, axis] = solid.mesh->place(dof);
    followers.push_back(carriers.follower(node, axis));
  }
  return redistributed(mass, followers);
}

SparseMatrix stiffness_of(const Solid& solid, const Neighbours& neighbours) {
  const double shear = solid.young / (2.0 * (1.0 + solid.poisson));
  const double lame = 2.0 * shear * solid.poisson / (1.0 - 2.0 * solid.poisson);
  BlockSum sum(neighbours, 3);
  for_each_solid(*solid.mesh, [&](std::span<const int> nodes, const std::vector<ElementPoint>& points) {
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        // Integral of lambda grad N_a grad N_b^T + mu (grad N_b grad N_a^T + (grad N_a . grad N_b) 1).
        Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
        for (const ElementPoint& point : points) {
          const Eigen::Vector3d along_a = point.gradients.row(static_cast<Eigen::Index>(a)),
                                along_b = point.gradients.row(static_cast<Eigen::Index>(b));
          block +=
              point.volume * (lame * along_a * along_b.transpose() + shear * along_b * along_a.transpose());
          block.diagonal().array() += point.volume * shear * along_a.dot(along_b);
        }
        if (a == b) block = (0.5 * (block + block.transpose())).eval();  // symmetric to the last bit
        sum.add(nodes[a], nodes[b], block);
        if (a != b) sum.add(nodes[b], nodes[a], Eigen::Matrix3d(block.transpose()));
      }
    }
  });
  return sum.sum();
}

}  // namespace

SparseMatrix unheld_mass(const Solid& solid) { return mass_of(solid, neighbours_of(*solid.mesh)); }

SparseMatrix unheld_stiffness(const Solid& solid) { return stiffness_of(solid, neighbours_of(*solid.mesh)); }

Structure assemble(const Solid& solid) {
  const int fixed = 3 * solid.mesh->held;
  Structure structure{.mass = {}, .damping = {solid.mesh->size(), solid.mesh->size()}, .stiffness = {}};
  // A statement each: what is not held is gone before the next matrix is made.
  clamped(unheld_mass(solid), fixed).swap(structure.mass);
  clamped(unheld_stiffness(solid), fixed).swap(structure.stiffness);
  return structure;
}

}  // namespace signorini
