#include "problems/assembly/block.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "problems/linear_algebra/orthogonal.hpp"
#include "problems/linear_algebra/sparse/sparse_factors.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"
#include "problems/matrix_properties.hpp"
#include "problems/validation.hpp"
#include "tests/problems/assembly/linear_motions.hpp"

namespace signorini::block_test {
namespace {

using Field = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

Block block(const std::array<int, 3>& elements, double poisson,
            ContactMass contact_mass = ContactMass::consistent) {
  return {.mesh = {.elements = elements, .lengths = {1.2, 0.5, 0.3}},
          .young = 7e10,
          .poisson = poisson,
          .density = 2700.0,
          .contact_mass = contact_mass};
}

double volume(const BlockMesh& mesh) { return mesh.lengths[0] * mesh.lengths[1] * mesh.lengths[2]; }

Eigen::Vector3d place(const BlockMesh& mesh, const Node& node) {
  return {node[0] * mesh.spacing(0), node[1] * mesh.spacing(1), node[2] * mesh.spacing(2)};
}

// A displacement field at all nodes, those of the clamped face first.
Eigen::VectorXd at_nodes(const BlockMesh& mesh, const Field& field) {
  Eigen::VectorXd u(mesh.size() + mesh.clamped());
  for_each_node({0, 0, 0}, mesh.elements,
                [&](const Node& node) { u.segment<3>(3 * mesh.number(node)) = field(place(mesh, node)); });
  return u;
}

std::vector<Eigen::VectorXd> linear_motions(const BlockMesh& mesh) {
  return test::linear_motions([&](const Field& field) { return at_nodes(mesh, field); });
}

TEST(BlockMesh, CountsCoordinatesAlongZThenYThenX) {
  const BlockMesh mesh{.elements = {3, 2, 4}};
  EXPECT_EQ(mesh.size(), 3 * 3 * 3 * 5);
  EXPECT_EQ(mesh.clamped(), 3 * 3 * 5);
  EXPECT_EQ(mesh.coordinate({1, 0, 0}, 0), 0);
  EXPECT_EQ(mesh.coordinate({1, 0, 1}, 0), 3);
  EXPECT_EQ(mesh.coordinate({1, 1, 0}, 2), 3 * 5 + 2);
  EXPECT_EQ(mesh.coordinate({2, 0, 0}, 1), 3 * 15 + 1);
  EXPECT_EQ(mesh.coordinate({3, 2, 4}, 2), mesh.size() - 1);
  for (int dof = 0; dof < mesh.size(); ++dof) {
    const auto [node, axis] = mesh.place(dof);
    EXPECT_EQ(mesh.coordinate(node, axis), dof);
  }
}

TEST(AssembleBlock, HasSixRigidMotionsWhileUnclamped) {
  const Block solid = block({2, 3, 2}, 0.3);
  const SparseMatrix K = unclamped_stiffness(solid);

  for (int a = 0; a < 3; ++a) {
    const Eigen::VectorXd shift = at_nodes(
        solid.mesh, [=](const Eigen::Vector3d&) { return Eigen::Vector3d(Eigen::Vector3d::Unit(a)); });
    const Eigen::VectorXd turn = at_nodes(solid.mesh, [=](const Eigen::Vector3d& x) {
      return Eigen::Vector3d(Eigen::Vector3d::Unit(a).cross(x));
    });
    EXPECT_LT((K * shift).cwiseAbs().maxCoeff(), 1e-14 * largest_entry(K) * 81);
    EXPECT_LT((K * turn).cwiseAbs().maxCoeff(), 1e-14 * largest_entry(K) * 81);
  }
  const Eigen::VectorXd values = symmetric_eigenvalues(K);
  EXPECT_LT(values(5), 1e-13 * values.tail(1)(0));
  EXPECT_GT(values(6), 1e-4 * values.tail(1)(0)) << "and no seventh";
}

// With constant strain every brick is exact: no force on inner nodes, and the energy of the solid.
TEST(AssembleBlock, PassesThePatchTest) {
  const Block solid = block({3, 2, 4}, 0.31);
  const BlockMesh& mesh = solid.mesh;
  Eigen::Matrix3d gradient;
  gradient << 1.0, -0.3, 0.2, 0.7, -0.4, 0.1, 0.5, 0.9, 0.6;
  const Eigen::VectorXd u =
      at_nodes(mesh, [&](const Eigen::Vector3d& x) { return Eigen::Vector3d(gradient * x); });

  const SparseMatrix K = unclamped_stiffness(solid);
  const Eigen::VectorXd force = K * u;

  const Eigen::Matrix3d strain = 0.5 * (gradient + gradient.transpose());
  const double mu = solid.young / (2.0 * (1.0 + solid.poisson));
  const double lambda = solid.young * solid.poisson / ((1.0 + solid.poisson) * (1.0 - 2.0 * solid.poisson));
  const double energy =
      volume(mesh) * (2.0 * mu * strain.squaredNorm() + lambda * strain.trace() * strain.trace());
  EXPECT_NEAR(u.dot(force), energy, 1e-13 * energy);
  for_each_node({1, 1, 1}, {2, 1, 3}, [&](const Node& node) {
    EXPECT_LT(force.segment<3>(3 * mesh.number(node)).norm(), 1e-13 * force.norm());
  });
  EXPECT_EQ(largest_entry(K - SparseMatrix(K.transpose())), 0.0) << "symmetric to the last bit";
}

TEST(AssembleBlock, HasTheMassAndTheMomentsOfTheSolid) {
  const Block solid = block({3, 2, 4}, 0.2);
  const BlockMesh& mesh = solid.mesh;
  const double m = solid.density * volume(mesh);
  const std::vector<Eigen::VectorXd> motions = linear_motions(mesh);
  for (const ContactMass kind : {ContactMass::consistent, ContactMass::lumped}) {
    const SparseMatrix M = unclamped_mass(block({3, 2, 4}, 0.2, kind));
    for (std::size_t a = 0; a < 3; ++a) {
      const Eigen::VectorXd& shift = motions[4 * a];
      EXPECT_NEAR(shift.dot(M * shift), m, 1e-13 * m);
      EXPECT_NEAR(shift.dot(M * motions[4 * ((a + 1) % 3)]), 0.0, 1e-13 * m);
      for (std::size_t by = 0; by < 3; ++by) {
        const double length = mesh.lengths[by];
        const Eigen::VectorXd& along = motions[4 * a + 1 + by];
        EXPECT_NEAR(shift.dot(M * along), m * length / 2.0, 1e-13 * m);
        if (kind == ContactMass::lumped) continue;
        EXPECT_NEAR(along.dot(M * along), m * length * length / 3.0, 1e-13 * m);
      }
    }
  }
}

// Without Poisson's ratio a pull at the end is the bar's: F x / (E A) at every node.
TEST(AssembleBlock, StretchesAsHookeSays) {
  const Block solid = block({5, 2, 3}, 0.0);
  const BlockMesh& mesh = solid.mesh;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(mesh.size());
  for (const auto& [dof, share] : load_on_face(mesh, {.axis = 0, .upper = true}, 0))
    load(dof) += 500.0 * share;

  const SparseLlt factors(assemble(solid).stiffness);
  const Eigen::VectorXd u = factors.solve(load);

  const double tip = 500.0 * mesh.lengths[0] / (solid.young * mesh.lengths[1] * mesh.lengths[2]);
  for_each_node({1, 0, 0}, mesh.elements, [&](const Node& node) {
    EXPECT_NEAR(u(mesh.coordinate(node, 0)), tip * node[0] / 5.0, 1e-12 * tip);
    EXPECT_NEAR(u(mesh.coordinate(node, 1)), 0.0, 1e-12 * tip);
    EXPECT_NEAR(u(mesh.coordinate(node, 2)), 0.0, 1e-12 * tip);
  });
}

// A beam of 10 x 1 x 1 under an end load, without Poisson's ratio; tip deflection over P / E.
double tip_deflection(int per_unit) {
  Block beam = block({10 * per_unit, 1, per_unit}, 0.0);
  beam.mesh.lengths = {10.0, 1.0, 1.0};
  beam.young = 1.0;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(beam.mesh.size());
  const Face end{.axis = 0, .upper = true};
  for (const auto& [dof, share] : load_on_face(beam.mesh, end, 2)) load(dof) = share;
  const SparseLlt factors(assemble(beam).stiffness);
  return load.dot(factors.solve(load));
}

// Timoshenko's beam: P L^3 / (3 E I) + 6/5 P L / (G A). Coarse bricks are too stiff.
TEST(AssembleBlock, BendsLikeABeamAtOrderTwo) {
  const double exact = 1000.0 * 12.0 / 3.0 + 1.2 * 10.0 * 2.0;
  const double coarse = tip_deflection(2) / exact - 1.0;
  const double fine = tip_deflection(4) / exact - 1.0;
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.2);
  EXPECT_LT(fine, 0.0);
  EXPECT_LT(std::abs(fine), 0.05);
}

// One brick deep under an end couple: of the curvature of the beam only 1 / (1 + a^2 / (2 b^2)), the price
// of bilinear shapes in bending, a and b the lengths of a brick along and across.
TEST(AssembleBlock, IsTooStiffInBendingByTheKnownFactor) {
  Block beam = block({6, 1, 1}, 0.0);
  const BlockMesh& mesh = beam.mesh;
  const double b = mesh.lengths[1];
  const double h = mesh.lengths[2];
  Eigen::VectorXd couple = Eigen::VectorXd::Zero(mesh.size());  // of 1 N m about the y axis
  for (int j = 0; j <= 1; ++j) {
    couple(mesh.coordinate({6, j, 0}, 0)) = 0.5 / h;
    couple(mesh.coordinate({6, j, 1}, 0)) = -0.5 / h;
  }
  const SparseLlt factors(assemble(beam).stiffness);
  const double tip = factors.solve(couple)(mesh.coordinate({6, 0, 0}, 2));

  const double EI = beam.young * b * h * h * h / 12.0;
  const double ratio = mesh.spacing(0) / h;
  const double exact = mesh.lengths[0] * mesh.lengths[0] / (2.0 * EI);
  EXPECT_NEAR(tip, exact / (1.0 + ratio * ratio / 2.0), 1e-11 * exact);
}

// Without Poisson's ratio the bar's axial modes, equal across the section, are modes of the solid.
TEST(AssembleBlock, HasTheAxialModesOfTheBarAtOrderTwo) {
  for (int k = 1; k <= 3; ++k) {
    const auto error = [&](int elements) {
      const Block solid = block({elements, 2, 1}, 0.0);
      const double b = (2 * k - 1) * std::numbers::pi / (2.0 * elements);
      Eigen::VectorXd mode = Eigen::VectorXd::Zero(solid.mesh.size());
      for_each_node({1, 0, 0}, solid.mesh.elements,
                    [&](const Node& node) { mode(solid.mesh.coordinate(node, 0)) = std::sin(b * node[0]); });
      const Structure structure = assemble(solid);
      const Eigen::VectorXd springs = structure.stiffness * mode;
      const Eigen::VectorXd inertia = structure.mass * mode;
      const double square = mode.dot(springs) / mode.dot(inertia);
      EXPECT_LT((springs - square * inertia).norm(),
                1e-12 * largest_entry(structure.stiffness) * mode.norm());
      const double exact = (2 * k - 1) * std::numbers::pi / 2.0 * std::sqrt(solid.young / solid.density) /
                           solid.mesh.lengths[0];
      return std::sqrt(square) / exact - 1.0;
    };
    const double fine = error(40);
    EXPECT_NEAR(std::log2(error(20) / fine), 2.0, 0.1) << "mode " << k;
    EXPECT_GT(fine, 0.0) << "mode " << k;
    EXPECT_LT(fine, 1e-2) << "mode " << k;
  }
}

// y and z change places, and with them nodes and displacements: nothing else.
TEST(AssembleBlock, DoesNotDependOnTheOrderOfItsAxes) {
  const Block solid = block({2, 3, 1}, 0.27);
  Block turned = solid;
  std::swap(turned.mesh.elements[1], turned.mesh.elements[2]);
  std::swap(turned.mesh.lengths[1], turned.mesh.lengths[2]);
  const auto in_turned = [&](int dof) {
    auto [node, axis] = solid.mesh.place(dof);
    std::swap(node[1], node[2]);
    return turned.mesh.coordinate(node, axis == 0 ? 0 : 3 - axis);
  };
  const Structure before = assemble(solid);
  const Structure after = assemble(turned);
  for (int i = 0; i < solid.mesh.size(); ++i) {
    for (int j = 0; j < solid.mesh.size(); ++j) {
      EXPECT_NEAR(after.stiffness.coeff(in_turned(i), in_turned(j)), before.stiffness.coeff(i, j),
                  1e-13 * largest_entry(before.stiffness));
      EXPECT_NEAR(after.mass.coeff(in_turned(i), in_turned(j)), before.mass.coeff(i, j),
                  1e-13 * largest_entry(before.mass));
    }
  }
}

std::vector<int> coordinates(const std::vector<Contact>& contacts) {
  std::vector<int> result;
  for (const Contact& contact : contacts) result.push_back(contact.normal[0].first);
  return result;
}

Patch everywhere(const BlockMesh& mesh, const Face& face) {
  const auto [first, second] = face.axes();
  return {{{0.0, mesh.lengths[static_cast<std::size_t>(first)]},
           {0.0, mesh.lengths[static_cast<std::size_t>(second)]}}};
}

std::vector<int> face_coordinates(const BlockMesh& mesh, const Face& face) {
  return coordinates(contacts_on_face(mesh, face, everywhere(mesh, face), 0.0));
}

TEST(AssembleBlock, KeepsMassAndMomentsWithoutMassAtContacts) {
  const Block consistent = block({3, 2, 3}, 0.3);
  const BlockMesh& mesh = consistent.mesh;
  const std::vector<int> end = face_coordinates(mesh, {.axis = 0, .upper = true});
  const std::vector<int> top = face_coordinates(mesh, {.axis = 2, .upper = true});
  std::vector<int> sides = face_coordinates(mesh, {.axis = 2, .upper = false});
  sides.insert(sides.end(), top.begin(), top.end());
  std::vector<int> edge = end;  // nodes with two contacts, in two directions
  edge.insert(edge.end(), top.begin(), top.end());
  const std::vector<std::vector<int>> patterns{
      end, top, sides, edge, {top[4]}, {mesh.coordinate({2, 1, 1}, 0), mesh.coordinate({3, 0, 2}, 1)}};
  const SparseMatrix before = unclamped_mass(consistent);
  for (const std::vector<int>& contacts : patterns) {
    Block massless = block({3, 2, 3}, 0.3, ContactMass::massless);
    massless.contacts = contacts;

    const SparseMatrix after = unclamped_mass(massless);
    const SparseMatrix clamped = assemble(massless).mass;

    const double m = massless.density * volume(mesh);
    for (const Eigen::VectorXd& a : linear_motions(mesh)) {
      for (const Eigen::VectorXd& b : linear_motions(mesh)) {
        EXPECT_NEAR(a.dot(after * b), a.dot(before * b), 1e-13 * m);
      }
    }
    EXPECT_TRUE(is_semidefinite(clamped));
    for (int i = 0; i < mesh.size(); ++i) {
      const bool touched = std::find(contacts.begin(), contacts.end(), i) != contacts.end();
      EXPECT_EQ(Eigen::VectorXd(clamped.row(i).transpose()).cwiseAbs().sum() == 0.0, touched)
          << "coordinate " << i;
    }
    EXPECT_EQ(PivotedQr(clamped).rank(), mesh.size() - std::ssize(contacts)) << "no other mass is lost";
  }
}

TEST(AssembleBlock, RefusesAContactWithTooFewNodesBehindIt) {
  Block massless = block({3, 2, 1}, 0.3, ContactMass::massless);
  massless.contacts = face_coordinates(massless.mesh, {.axis = 2, .upper = true});
  EXPECT_THROW(assemble(massless), InvalidProblem);
  massless.contacts = face_coordinates(massless.mesh, {.axis = 1, .upper = true});
  EXPECT_NO_THROW(assemble(massless));
}

// Node by node at most 27 neighbours: memory grows with Nd alone.
TEST(AssembleBlock, StaysSparseForAHundredThousandCoordinates) {
  Block solid = block({40, 28, 28}, 0.3, ContactMass::massless);
  const BlockMesh& mesh = solid.mesh;
  ASSERT_GE(mesh.size(), 100000);
  solid.contacts = face_coordinates(mesh, {.axis = 0, .upper = true});

  const Structure structure = assemble(solid);

  long pairs = 1;  // of neighbours or a node with itself
  for (const int elements : mesh.elements) pairs *= 3 * (elements + 1) - 2;
  EXPECT_LE(structure.stiffness.nonZeros(), 9 * pairs);
  EXPECT_LE(structure.mass.nonZeros(), 2 * 3 * pairs);
}

TEST(ContactsOnFace, AreThoseOfThePatchAlongTheOutwardNormal) {
  const BlockMesh mesh{.elements = {4, 5, 6}, .lengths = {2.0, 1.0, 3.0}};
  const Face bottom{.axis = 2, .upper = false};
  // Nodes are 0.5 m and 0.2 m apart; the second patch ends on nodes.
  EXPECT_EQ(contacts_on_face(mesh, bottom, everywhere(mesh, bottom), 0.1).size(), 4U * 6U);
  const std::vector<Contact> contacts = contacts_on_face(mesh, bottom, {{{1.0, 1.5}, {0.6, 0.95}}}, 0.1);

  ASSERT_EQ(contacts.size(), 4U);
  EXPECT_EQ(coordinates(contacts),
            (std::vector<int>{mesh.coordinate({2, 3, 0}, 2), mesh.coordinate({2, 4, 0}, 2),
                              mesh.coordinate({3, 3, 0}, 2), mesh.coordinate({3, 4, 0}, 2)}));
  for (const Contact& contact : contacts) {
    EXPECT_EQ(contact.normal[0].second, -1.0);
    EXPECT_EQ(contact.gap, 0.1);
  }
  const Face end{.axis = 0, .upper = true};
  EXPECT_EQ(contacts_on_face(mesh, end, everywhere(mesh, end), 0.0).size(), 6U * 7U);
  EXPECT_EQ(contacts_on_face(mesh, end, everywhere(mesh, end), 0.0)[0].normal[0].second, 1.0);
  EXPECT_TRUE(contacts_on_face(mesh, bottom, {{{0.0, 0.4}, {0.0, 1.0}}}, 0.1).empty()) << "clamped nodes";
}

// Spread evenly: the work on a linear motion of the face is the force times its mean.
TEST(LoadOnFace, WorksLikeAnEvenTraction) {
  const BlockMesh mesh{.elements = {4, 5, 6}, .lengths = {2.0, 1.0, 3.0}};
  const auto work = [&](const Face& face, int direction, const Field& field) {
    const Eigen::VectorXd u = at_nodes(mesh, field);
    double sum = 0.0;
    for (const auto& [dof, share] : load_on_face(mesh, face, direction)) {
      EXPECT_EQ(dof % 3, direction);
      sum += share * u(dof + mesh.clamped());
    }
    return sum;
  };
  const Field linear = [](const Eigen::Vector3d& x) {
    return Eigen::Vector3d(1.0 + x(1), 2.0 - 3.0 * x(2), x(0) * 0.7);
  };
  EXPECT_NEAR(work({.axis = 0, .upper = true}, 0, linear), 1.5, 1e-14);
  EXPECT_NEAR(work({.axis = 0, .upper = true}, 1, linear), 2.0 - 4.5, 1e-14);
  EXPECT_NEAR(work({.axis = 1, .upper = false}, 2, linear), 0.7, 1e-14) << "the clamped edge does not move";
}

}  // namespace
}  // namespace signorini::block_test
