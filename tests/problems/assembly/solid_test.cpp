#include "problems/assembly/solid.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>
#include <set>
#include <sstream>

#include "problems/assembly/block.hpp"
#include "problems/files/gmsh_mesh.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"
#include "problems/matrix_properties.hpp"
#include "problems/validation.hpp"
#include "tests/problems/assembly/box_meshes.hpp"
#include "tests/problems/assembly/linear_motions.hpp"
#include "tests/support/data_folder.hpp"

namespace signorini::solid_test {
namespace {

using test::BoxMesh;
using test::distorted_box;
using test::kSolidTypes;

using Field = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

const Eigen::Vector3d kLengths(1.2, 0.5, 0.3);
const double kVolume = kLengths.prod();

Solid solid(SolidMesh mesh, double poisson = 0.3, ContactMass contact_mass = ContactMass::consistent) {
  return {.mesh = std::make_shared<const SolidMesh>(std::move(mesh)),
          .young = 7e10,
          .poisson = poisson,
          .density = 2700.0,
          .contact_mass = contact_mass};
}

// A displacement field at all nodes, those at rest first.
Eigen::VectorXd at_nodes(const SolidMesh& mesh, const Field& field) {
  Eigen::VectorXd u(3 * std::ssize(mesh.nodes));
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
    u.segment<3>(3 * static_cast<Eigen::Index>(node)) = field(mesh.nodes[node]);
  return u;
}

std::vector<Eigen::VectorXd> linear_motions(const SolidMesh& mesh) {
  return test::linear_motions([&](const Field& field) { return at_nodes(mesh, field); });
}

// Natural frequencies, lowest first [rad/s].
Eigen::VectorXd frequencies(const Structure& structure) {
  return generalised_eigen(structure.stiffness, structure.mass).values.cwiseSqrt();
}

std::vector<int> coordinates(const SolidMesh& mesh, const std::string& group, int axis) {
  std::vector<int> result;
  for (const Contact& contact : contacts_on_group(mesh, mesh.groups.at(group), axis, true, 0.0))
    result.push_back(contact.normal[0].first);
  return result;
}

std::vector<int> both(std::vector<int> one, const std::vector<int>& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

// Bricks of one mesh are those of the other, node by node, wherever nodes stand in it.
TEST(AssembleSolid, OfBricksIsTheBlock) {
  for (const ContactMass kind : {ContactMass::consistent, ContactMass::lumped}) {
    const Block block{.mesh = {.elements = {3, 2, 4}, .lengths = {1.2, 0.5, 0.3}},
                      .young = 7e10,
                      .poisson = 0.31,
                      .density = 2700.0,
                      .contact_mass = kind};
    const Solid body = solid(held_at(BoxMesh(5, {3, 2, 4}, kLengths), {"y+"}), 0.31, kind);
    std::vector<int> in_block;  // coordinate, of the block, of each of the solid
    for (const Eigen::Vector3d& place : body.mesh->nodes) {
      Node node;
      for (int a = 0; a < 3; ++a)
        node[static_cast<std::size_t>(a)] = static_cast<int>(std::lround(place[a] / block.mesh.spacing(a)));
      for (int axis = 0; axis < 3; ++axis) in_block.push_back(3 * block.mesh.number(node) + axis);
    }
    const auto expect_same = [&](const SparseMatrix& found, const SparseMatrix& expected) {
      const Eigen::MatrixXd mapped = Eigen::MatrixXd(expected)(in_block, in_block);
      EXPECT_LT((Eigen::MatrixXd(found) - mapped).cwiseAbs().maxCoeff(), 1e-13 * largest_entry(expected));
    };
    EXPECT_NE(in_block[0], 0);
    expect_same(unheld_mass(body), unclamped_mass(block));
    expect_same(unheld_stiffness(body), unclamped_stiffness(block));
  }
}

TEST(AssembleSolid, IsWhatIsNotHeld) {
  const Solid body = solid(held_at(distorted_box(11, {2, 1, 1}, kLengths), {"x-"}));
  const Structure structure = assemble(body);
  const int size = body.mesh->size();
  EXPECT_EQ(structure.damping.rows(), size);
  EXPECT_EQ(structure.damping.nonZeros(), 0);
  EXPECT_EQ(Eigen::MatrixXd(structure.mass),
            Eigen::MatrixXd(unheld_mass(body)).bottomRightCorner(size, size));
  EXPECT_EQ(Eigen::MatrixXd(structure.stiffness),
            Eigen::MatrixXd(unheld_stiffness(body)).bottomRightCorner(size, size));
}

TEST(AssembleSolid, HasSixRigidMotionsWhileFree) {
  for (const int type : kSolidTypes) {
    const Solid body = solid(distorted_box(type, {2, 2, 1}, kLengths));
    const SparseMatrix K = unheld_stiffness(body);
    EXPECT_EQ(largest_entry(K - SparseMatrix(K.transpose())), 0.0) << "symmetric to the last bit";
    for (int a = 0; a < 3; ++a) {
      const Eigen::Vector3d axis = Eigen::Vector3d::Unit(a);
      const Eigen::VectorXd shift = at_nodes(*body.mesh, [&](const Eigen::Vector3d&) { return axis; });
      const Eigen::VectorXd turn =
          at_nodes(*body.mesh, [&](const Eigen::Vector3d& x) { return Eigen::Vector3d(axis.cross(x)); });
      EXPECT_LT((K * shift).cwiseAbs().maxCoeff(), 1e-14 * largest_entry(K) * 81) << type;
      EXPECT_LT((K * turn).cwiseAbs().maxCoeff(), 1e-14 * largest_entry(K) * 81) << type;
    }
    const Eigen::VectorXd values = symmetric_eigenvalues(K);
    EXPECT_GT(values(0), -1e-13 * values.tail(1)(0)) << type;
    EXPECT_LT(values(5), 1e-13 * values.tail(1)(0)) << type;
    EXPECT_GT(values(6), 1e-5 * values.tail(1)(0)) << type << ": and no seventh";
  }
}

// With constant strain every element is exact: no force on inner nodes, and the energy of the solid.
TEST(AssembleSolid, PassesThePatchTest) {
  Eigen::Matrix3d gradient;
  gradient << 1.0, -0.3, 0.2, 0.7, -0.4, 0.1, 0.5, 0.9, 0.6;
  const Eigen::Matrix3d strain = 0.5 * (gradient + gradient.transpose());
  for (const int type : kSolidTypes) {
    const Solid body = solid(distorted_box(type, {2, 2, 2}, kLengths), 0.31);
    const SolidMesh& mesh = *body.mesh;
    const Eigen::VectorXd u =
        at_nodes(mesh, [&](const Eigen::Vector3d& x) { return Eigen::Vector3d(gradient * x); });

    const Eigen::VectorXd force = unheld_stiffness(body) * u;

    const double mu = body.young / (2.0 * (1.0 + body.poisson));
    const double lambda = body.young * body.poisson / ((1.0 + body.poisson) * (1.0 - 2.0 * body.poisson));
    const double energy =
        kVolume * (2.0 * mu * strain.squaredNorm() + lambda * strain.trace() * strain.trace());
    EXPECT_NEAR(u.dot(force), energy, 1e-13 * energy) << type;
    int inner = 0;
    for (int node = 0; node < std::ssize(mesh.nodes); ++node) {
      const Eigen::Array3d share = mesh.nodes[static_cast<std::size_t>(node)].array() / kLengths.array();
      if ((share < 1e-9).any() || (share > 1.0 - 1e-9).any()) continue;
      ++inner;
      EXPECT_LT(force.segment<3>(3 * node).norm(), 1e-13 * force.norm()) << type;
    }
    EXPECT_EQ(inner, shape_of_gmsh_type(type)->degree == 1 ? 1 : 27);
  }
}

// Of a skewed box, whose elements have straight edges: x = A s, s evenly in the unit cube.
TEST(AssembleSolid, HasTheMassAndTheMomentsOfTheBody) {
  Eigen::Matrix3d A;
  A << 1.2, 0.2, 0.1, -0.1, 0.5, 0.0, 0.2, 0.1, 0.3;
  const Eigen::Matrix3d of_cube = Eigen::Matrix3d::Constant(0.25) + Eigen::Matrix3d::Identity() / 12.0;
  for (const int type : kSolidTypes) {
    BoxMesh box(type, {2, 3, 1}, Eigen::Vector3d::Ones());
    for (Eigen::Vector3d& node : box.nodes) node = (A * node).eval();
    const Solid body = solid(box);
    const SparseMatrix M = unheld_mass(body);
    const double m = body.density * A.determinant();
    const Eigen::Vector3d first = m * A * Eigen::Vector3d::Constant(0.5);
    const Eigen::Matrix3d second = m * A * of_cube * A.transpose();
    const std::vector<Eigen::VectorXd> motions = linear_motions(*body.mesh);
    for (std::size_t a = 0; a < 3; ++a) {
      const Eigen::VectorXd& shift = motions[4 * a];
      EXPECT_NEAR(shift.dot(M * shift), m, 1e-13 * m) << type;
      EXPECT_EQ(shift.dot(M * motions[4 * ((a + 1) % 3)]), 0.0) << type;
      for (int i = 0; i < 3; ++i) {
        const Eigen::VectorXd& along = motions[4 * a + 1 + static_cast<std::size_t>(i)];
        EXPECT_NEAR(shift.dot(M * along), first[i], 1e-13 * m) << type;
        for (int k = 0; k < 3; ++k)
          EXPECT_NEAR(along.dot(M * motions[4 * a + 1 + static_cast<std::size_t>(k)]), second(i, k),
                      1e-13 * m)
              << type;
      }
    }
  }
}

TEST(AssembleSolid, KeepsTheMassOfEveryElementWhenLumped) {
  for (const int type : kSolidTypes) {
    const Solid body = solid(distorted_box(type, {2, 2, 1}, kLengths), 0.3, ContactMass::lumped);
    const SparseMatrix M = unheld_mass(body);
    const double m = body.density * kVolume;
    EXPECT_EQ(M.nonZeros(), M.rows()) << type << ": diagonal";
    EXPECT_GT(M.diagonal().minCoeff(), 0.0) << type;
    EXPECT_NEAR(M.sum(), 3.0 * m, 1e-13 * m) << type;
  }
}

// Of one straight tetrahedron of 10 nodes, in closed form; lumped, Hinton's shares: 1/36 a corner, 4/27 an
// edge.
TEST(AssembleSolid, HasTheMassMatrixOfAStraightTetrahedron) {
  SolidMesh one;
  one.solids = {{.shape = shape_of_gmsh_type(11), .nodes = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}}};
  const Eigen::Matrix3Xd places = reference_nodes(*shape_of_gmsh_type(11));
  for (int node = 0; node < 10; ++node) one.nodes.emplace_back(places.col(node));
  const Solid body = solid(one);
  const double m = body.density / 6.0;
  const std::array<std::set<int>, 10> at{
      {{0}, {1}, {2}, {3}, {0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}}};
  const Eigen::MatrixXd M = unheld_mass(body);
  for (std::size_t a = 0; a < 10; ++a) {
    for (std::size_t b = 0; b < 10; ++b) {
      std::set<int> all = at[a];
      all.insert(at[b].begin(), at[b].end());
      const std::size_t ends = at[a].size() + at[b].size(), common = ends - all.size();
      const double share = ends == 2   ? (common == 1 ? 6.0 : 1.0)
                           : ends == 3 ? (common == 1 ? -4.0 : -6.0)
                                       : std::pow(2.0, 3.0 + static_cast<double>(common));
      EXPECT_NEAR(M(static_cast<Eigen::Index>(3 * a), static_cast<Eigen::Index>(3 * b)), m * share / 420.0,
                  1e-14 * m)
          << a << ", " << b;
    }
  }
  const Eigen::VectorXd shares = unheld_mass(solid(one, 0.3, ContactMass::lumped)).diagonal() / m;
  EXPECT_LT((shares.head(12).array() - 1.0 / 36.0).abs().maxCoeff(), 1e-14);
  EXPECT_LT((shares.tail(18).array() - 4.0 / 27.0).abs().maxCoeff(), 1e-14);
}

TEST(AssembleSolid, KeepsMassAndMomentsWithoutMassAtContacts) {
  for (const int type : kSolidTypes) {
    const SolidMesh mesh = held_at(distorted_box(type, {2, 2, 2}, kLengths), {"x-"});
    const Solid consistent = solid(mesh);
    const SparseMatrix before = unheld_mass(consistent);
    const double m = consistent.density * kVolume;
    const std::vector<int> top = coordinates(mesh, "z+", 2), end = coordinates(mesh, "x+", 0);
    const std::vector<std::vector<int>> patterns{
        end, top, both(top, end), both(coordinates(mesh, "z+", 0), coordinates(mesh, "z-", 1)), {top[1]}};
    for (const std::vector<int>& contacts : patterns) {
      Solid massless = solid(mesh, 0.3, ContactMass::massless);
      massless.contacts = contacts;

      const SparseMatrix after = unheld_mass(massless);
      const SparseMatrix held = assemble(massless).mass;

      for (const Eigen::VectorXd& a : linear_motions(mesh)) {
        for (const Eigen::VectorXd& b : linear_motions(mesh))
          EXPECT_NEAR(a.dot(after * b), a.dot(before * b), 1e-13 * m) << type;
      }
      EXPECT_TRUE(is_semidefinite(held)) << type;
      const std::set<int> touched(contacts.begin(), contacts.end());
      for (int i = 0; i < mesh.size(); ++i) {
        EXPECT_EQ(Eigen::VectorXd(held.col(i)).cwiseAbs().sum() == 0.0, touched.contains(i))
            << type << ": " << i;
        EXPECT_EQ(Eigen::VectorXd(held.row(i).transpose()).cwiseAbs().sum() == 0.0, touched.contains(i));
      }
      EXPECT_EQ(Eigen::MatrixXd(unheld_stiffness(massless)), Eigen::MatrixXd(unheld_stiffness(consistent)));
    }
  }
}

TEST(AssembleSolid, WithoutContactsIsConsistent) {
  const SolidMesh mesh = held_at(distorted_box(11, {2, 1, 1}, kLengths), {"x-"});
  EXPECT_EQ(Eigen::MatrixXd(unheld_mass(solid(mesh, 0.3, ContactMass::massless))),
            Eigen::MatrixXd(unheld_mass(solid(mesh))));
}

std::string refusal(const Solid& body) {
  try {
    assemble(body);
    return "";
  } catch (const InvalidProblem& error) {
    return error.what();
  }
}

TEST(AssembleSolid, RefusesContactsWithoutNodesThatCouldCarryTheirMass) {
  const std::string expected =
      "system.contact_mass = massless (must leave nodes without contact, not all in one plane, about every "
      "contact, to carry its mass)";
  // Bricks, one layer of them: beneath the contacts there is one plane of nodes.
  const SolidMesh plate = held_at(BoxMesh(5, {3, 3, 1}, kLengths), {"x-"});
  Solid body = solid(plate, 0.3, ContactMass::massless);
  body.contacts = coordinates(plate, "z+", 2);
  EXPECT_EQ(refusal(body), "") << "nodes at rest are not in that plane";
  const SolidMesh free_plate = BoxMesh(5, {3, 3, 1}, kLengths);
  body.mesh = std::make_shared<const SolidMesh>(free_plate);
  body.contacts = coordinates(free_plate, "z+", 2);
  EXPECT_EQ(refusal(body), expected);
  body.contacts = both(body.contacts, coordinates(free_plate, "z-", 2));
  EXPECT_EQ(refusal(body), expected) << "all of them are touched";
  body.contacts = coordinates(free_plate, "z+", 2);
  body.contact_mass = ContactMass::lumped;
  EXPECT_EQ(refusal(body), "");
}

// Layers of a plate a twentieth as thick as its bricks are wide: there are nodes beneath, in three planes.
TEST(AssembleSolid, FindsCarriersInAPlateOfThinLayers) {
  const SolidMesh plate(BoxMesh(5, {4, 4, 3}, {4.0, 4.0, 0.15}));
  Solid body = solid(plate, 0.3, ContactMass::massless);
  body.contacts = coordinates(plate, "z+", 2);
  EXPECT_EQ(refusal(body), "");
}

TEST(AssembleSolid, RefusesAFlatElement) {
  BoxMesh flat(4, {1, 1, 1}, kLengths);
  for (Eigen::Vector3d& node : flat.nodes) node.y() = 0.0;
  EXPECT_EQ(refusal(solid(flat)).find("system.mesh = an element about ("), 0U) << refusal(solid(flat));
}

// A slender beam, twenty times as long as it is thick, held at x = 0: Euler and Bernoulli's first frequency.
TEST(AssembleSolid, BendsLikeABeam) {
  constexpr double kLength = 2.0, kSide = 0.1, kFirst = 1.8751040687119611;
  for (const auto& [type, cells] : {std::pair(11, 16), std::pair(12, 8)}) {
    const Solid body = solid(held_at(BoxMesh(type, {cells, 1, 1}, {kLength, kSide, kSide}), {"x-"}), 0.3);
    const double exact = kFirst * kFirst / (kLength * kLength) * kSide / std::sqrt(12.0) *
                         std::sqrt(body.young / body.density);
    const Eigen::VectorXd found = frequencies(assemble(body));
    EXPECT_NEAR(found[0], exact, 0.01 * exact) << type;
    EXPECT_NEAR(found[1], exact, 0.01 * exact) << type << ": about the other axis";
    EXPECT_GT(found[2], 5.0 * exact) << type << ": the next is 6.27 times as high";
  }
}

// A steel body of tetrahedra of 10 nodes, its surface "foot" at rest.
Solid corner() {
  std::ifstream file(test::data_folder() / "mesh-corner" / "corner.msh");
  EXPECT_TRUE(file);
  std::ostringstream text;
  text << file.rdbuf();
  Solid body = solid(held_at(read_gmsh_mesh(text.str(), "corner.msh"), {"foot"}));
  body.young = 2.1e11;
  body.density = 7850.0;
  return body;
}

// M of tetrahedra of 10 nodes by four points each, which is not enough for it.
SparseMatrix four_point_mass(const Solid& body) {
  const ElementShape& shape = *shape_of_gmsh_type(11);
  const SolidMesh& mesh = *body.mesh;
  Entries entries;
  for (int element = 0; element < mesh.solids.front().count(); ++element) {
    const std::span<const int> nodes = mesh.solids.front().of(element);
    const auto place = [&](std::size_t i) { return mesh.nodes[static_cast<std::size_t>(nodes[i])]; };
    const double volume =
        std::abs((place(1) - place(0)).cross(place(2) - place(0)).dot(place(3) - place(0))) / 6.0;
    for (int point = 0; point < 4; ++point) {
      Eigen::Vector4d shares = Eigen::Vector4d::Constant((5.0 - std::sqrt(5.0)) / 20.0);
      shares[point] = (5.0 + 3.0 * std::sqrt(5.0)) / 20.0;
      const Eigen::VectorXd N = shape_functions(shape, shares.tail(3)).col(0);
      for (int i = 0; i < 300; ++i) {
        const int a = i / 30, b = i / 3 % 10, axis = i % 3;
        entries.emplace_back(3 * nodes[static_cast<std::size_t>(a)] + axis,
                             3 * nodes[static_cast<std::size_t>(b)] + axis,
                             body.density * volume / 4.0 * N[a] * N[b]);
      }
    }
  }
  return clamped(from_entries(entries, 3 * std::ssize(mesh.nodes)), 3 * mesh.held);
}

void expect_frequencies(const Eigen::VectorXd& found, const std::vector<double>& expected, double tolerance) {
  for (std::size_t mode = 0; mode < expected.size(); ++mode)
    EXPECT_NEAR(found[static_cast<Eigen::Index>(mode)], expected[mode], tolerance * expected[mode]) << mode;
}

// By CalculiX 2.20, an independent program, on tests/data/mesh-corner/corner.msh: C3D10 (whose last two nodes
// are those of Gmsh the other way round), consistent mass, *FREQUENCY for 6 modes, the surface "foot" at
// rest, E = 2.1e11, nu = 0.3, rho = 7850; angular frequencies with all digits that it prints. It takes four
// points for the mass of C3D10, as for the stiffness: with the exact mass, higher modes are up to 2e-4 lower.
TEST(AssembleSolid, HasTheFrequenciesOfAnIndependentProgram) {
  const Solid body = corner();
  const std::vector<double> c3d10{0.3644533e4, 0.4667498e4, 0.1139850e5,
                                  0.1468110e5, 0.4237111e5, 0.5389242e5};
  Structure structure = assemble(body);
  expect_frequencies(frequencies(structure), c3d10, 2e-4);
  structure.mass = four_point_mass(body);
  expect_frequencies(frequencies(structure), c3d10, 1e-6);
}

}  // namespace
}  // namespace signorini::solid_test
