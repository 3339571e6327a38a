#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <functional>
#include <sstream>

#include "problems/assembly/damping.hpp"
#include "problems/assembly/solid.hpp"
#include "problems/files/toml_tree.hpp"
#include "problems/matrix_properties.hpp"
#include "problems/scene/scene_file.hpp"
#include "problems/scene/scene_layout.hpp"
#include "tests/problems/assembly/box_meshes.hpp"
#include "tests/problems/temporary_folder.hpp"

namespace signorini::scene_mesh_test {
namespace {

constexpr std::string_view kScene = R"(schema = 1
name = "own"
[system]
kind = "mesh"
mesh = "model/box.msh"
fixed = ["x-"]
young = 2e6
poisson = 0.25
density = 1000.0
damping = { alpha = 0.5, beta = 1e-3 }
contact_mass = "massless"
[forcing]
frequency = 3.0
[[forcing.term]]
group = "x+"
direction = "y"
cos = 6.0
sin = -2.0
[[contact]]
group = "z-"
direction = "z-"
gap = 0.125
)";

constexpr std::string_view kBar = R"(schema = 1
name = "own"
[system]
kind = "bar"
elements = 3
length = 1.0
area = 1.0
young = 1.0
density = 1.0
damping = { alpha = 0.1 }
[forcing]
frequency = 1.0
)";

std::string refused(const std::function<void()>& action) {
  try {
    action();
    return "";
  } catch (const SceneError& error) {
    return error.what();
  }
}

class MeshScene : public testing::Test {
 protected:
  MeshScene() { write("model/box.msh", test::gmsh_text(box_)); }

  void write(const std::string& name, const std::string& text) const {
    static_cast<void>(folder_.write(name, text));
  }
  // The scene with its line `number` replaced, and more text after it.
  [[nodiscard]] std::filesystem::path scene(int number = 0, const std::string& replacement = "",
                                            const std::string& more = "") const {
    std::istringstream stream{std::string(kScene)};
    std::string text;
    int count = 0;
    for (std::string line; std::getline(stream, line);) {
      text += ++count == number ? replacement : line;
      text += '\n';
    }
    return folder_.write("scene.toml", text + more);
  }
  [[nodiscard]] std::string refusal(int number, const std::string& replacement,
                                    const std::string& more = "") const {
    const std::filesystem::path path = scene(number, replacement, more);
    const std::string message = refused([&] { load_scene(path); });
    const std::string folder = folder_.path().string() + "/";
    return message.starts_with(folder) ? message.substr(folder.size()) : message;
  }
  [[nodiscard]] SolidMesh held() const { return held_at(box_, {"x-"}); }

  test::BoxMesh box_{11, {2, 1, 1}, {1.0, 0.5, 0.25}};
  test::TemporaryFolder folder_;
};

TEST_F(MeshScene, IsTheSolidOfItsMesh) {
  const Problem problem = load_scene(scene());
  const SolidMesh mesh = held();
  Solid body{.mesh = std::make_shared<const SolidMesh>(mesh),
             .young = 2e6,
             .poisson = 0.25,
             .density = 1000.0,
             .contact_mass = ContactMass::massless};
  for (const Contact& contact : problem.contacts) body.contacts.push_back(contact.normal[0].first);
  const Structure expected = assemble(body);
  EXPECT_EQ(problem.kind, "mesh");
  EXPECT_EQ(Eigen::MatrixXd(problem.mass()), Eigen::MatrixXd(expected.mass));
  EXPECT_EQ(Eigen::MatrixXd(problem.stiffness()), Eigen::MatrixXd(expected.stiffness));
  const SparseMatrix damping =
      damping_matrix(ProportionalDamping{.alpha = 0.5, .beta = 1e-3}, expected.mass, expected.stiffness);
  EXPECT_EQ(Eigen::MatrixXd(problem.damping()), Eigen::MatrixXd(damping));
  ASSERT_TRUE(problem.structure->proportional) << "what it was assembled by is kept";
  EXPECT_EQ(problem.structure->proportional->alpha, 0.5);
  EXPECT_EQ(problem.structure->proportional->beta, 1e-3);
}

TEST_F(MeshScene, HasContactsAndALoadOnGroups) {
  const Problem problem = load_scene(scene());
  const SolidMesh mesh = held();
  ASSERT_EQ(problem.contacts.size(), 4U * 3U) << "of 5 x 3 nodes 3 are at rest";
  for (const Contact& contact : problem.contacts) {
    ASSERT_EQ(contact.normal.size(), 1U);
    EXPECT_EQ(contact.normal[0].second, -1.0) << "downwards";
    EXPECT_EQ(contact.gap, 0.125);
    const auto [node, axis] = mesh.place(contact.normal[0].first);
    EXPECT_EQ(axis, 2);
    EXPECT_EQ(mesh.nodes[static_cast<std::size_t>(node)].z(), 0.0);
  }
  double cos = 0.0, sin = 0.0;
  for (const ForceTerm& term : problem.force) {
    const auto [node, axis] = mesh.place(term.dof);
    EXPECT_EQ(axis, 1);
    EXPECT_EQ(mesh.nodes[static_cast<std::size_t>(node)].x(), 1.0);
    cos += term.cos;
    sin += term.sin;
  }
  EXPECT_NEAR(cos, 6.0, 1e-13);
  EXPECT_NEAR(sin, -2.0, 1e-13);
}

TEST_F(MeshScene, TakesContactsEitherWayAlongEveryAxis) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool upward : {true, false}) {
      const std::string way = {"xyz"[axis], upward ? '+' : '-'};
      const Problem problem = load_scene(scene(21, "direction = \"" + way + "\""));
      for (const Contact& contact : problem.contacts) {
        EXPECT_EQ(contact.normal[0].first % 3, axis) << way;
        EXPECT_EQ(contact.normal[0].second, upward ? 1.0 : -1.0) << way;
      }
    }
  }
}

TEST_F(MeshScene, LiesInTheFolderOfTheSceneAndIsAmongItsFiles) {
  const std::filesystem::path path = scene();
  const std::vector<std::filesystem::path> expected{folder_.path() / "model" / "box.msh"};
  EXPECT_EQ(load_outline(path).files, expected);
  EXPECT_EQ(load_outline(path).coordinates, held().size());
  EXPECT_EQ(parse_scene_with_sources(kScene, path.string()).files, expected);
  EXPECT_EQ(load_outline(path).layout.index(), SystemLayout(std::make_shared<const SolidMesh>()).index());
  const auto mesh = std::get<std::shared_ptr<const SolidMesh>>(load_outline(path).layout);
  EXPECT_EQ(mesh->nodes, held().nodes);
  EXPECT_EQ(mesh->held, 9);
}

// A base that moves along z pulls as its inertia does: the mass by the displacement of a rigid body.
TEST_F(MeshScene, MovesWithABaseAlongAnAxis) {
  const Problem still = load_scene(scene());
  for (int axis = 0; axis < 3; ++axis) {
    const Problem moved = load_scene(scene(
        0, "",
        "[base]\ndisplacement = [{ cos = 0.5 }]\ndirection = \"" + std::string(1, "xyz"[axis]) + "\"\n"));
    Eigen::VectorXd load = Eigen::VectorXd::Zero(held().size());
    for (const ForceTerm& term : moved.force) load[term.dof] += force_amplitude(term, 3.0).real();
    for (const ForceTerm& term : still.force) load[term.dof] -= force_amplitude(term, 3.0).real();
    Eigen::VectorXd rigid = Eigen::VectorXd::Zero(load.size());
    for (int dof = axis; dof < load.size(); dof += 3) rigid[dof] = 1.0;
    const Eigen::VectorXd expected = 9.0 * 0.5 * (still.mass() * rigid);
    EXPECT_LT((load - expected).norm(), 1e-12 * expected.norm()) << axis;
  }
  EXPECT_EQ(refusal(0, "", "[base]\ndisplacement = [{ cos = 0.5 }]\ndirection = \"xy\"\n"),
            "scene.toml:25: base.direction = \"xy\" (must be \"x\", \"y\" or \"z\")");
}

TEST_F(MeshScene, IsFreeWithoutFixedGroups) {
  const auto mesh = std::get<std::shared_ptr<const SolidMesh>>(load_outline(scene(6, "")).layout);
  EXPECT_EQ(mesh->held, 0);
  EXPECT_EQ(mesh->nodes, box_.nodes);
  const auto both =
      std::get<std::shared_ptr<const SolidMesh>>(load_outline(scene(6, "fixed = [\"x-\", \"y+\"]")).layout);
  EXPECT_EQ(both->held, 9 + 12);
}

TEST_F(MeshScene, IsRefusedForItsFileInOneLine) {
  const std::string file = " (must be the name of a mesh file of Gmsh, relative to the scene's folder";
  EXPECT_EQ(refusal(5, ""), "scene.toml:3: system.mesh = missing" + file + ")");
  EXPECT_EQ(refusal(5, "mesh = 1"), "scene.toml:5: system.mesh = 1" + file + ")");
  EXPECT_EQ(refusal(5, "mesh = \"\""), "scene.toml:5: system.mesh = \"\"" + file + ")");
  EXPECT_EQ(refusal(5, "mesh = \"box.msh\""),
            "scene.toml:5: system.mesh = \"box.msh\"" + file + "; it is missing)");
  EXPECT_EQ(refusal(5, "mesh = \"model\""),
            "scene.toml:5: system.mesh = \"model\"" + file + "; it is a folder)");
  write("model/bad.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n");
  EXPECT_EQ(refusal(5, "mesh = \"model/bad.msh\"").substr(0, 33), "model/bad.msh:2: format = \"2.2 0 ");
  test::BoxMesh flat = box_;
  for (Eigen::Vector3d& node : flat.nodes) node.x() = 1.0;
  write("model/flat.msh", test::gmsh_text(flat));
  const std::string message = refusal(5, "mesh = \"model/flat.msh\"");
  EXPECT_EQ(message.find("scene.toml:5: system.mesh = an element about ("), 0U) << message;
}

TEST_F(MeshScene, IsRefusedForItsGroupsInOneLine) {
  const std::string names = " (must be the name of a group of the mesh, which has 6 of them; did you mean ";
  EXPECT_EQ(refusal(6, "fixed = [\"x-\", \"x_\"]").substr(0, 38), "scene.toml:6: system.fixed[1] = \"x_\" (");
  for (const auto& [line, key, text] :
       {std::tuple(6, "fixed = [\"x-x\"]", "6: system.fixed[0] = \"x-x\""),
        std::tuple(15, "group = \"x-x\"", "15: forcing.term[0].group = \"x-x\""),
        std::tuple(20, "group = \"x-x\"", "20: contact[0].group = \"x-x\"")}) {
    const std::string message = refusal(line, key);
    EXPECT_EQ(message.find(std::string("scene.toml:") + text + names + "x-"), 0U) << message;
  }
  EXPECT_EQ(refusal(6, "fixed = \"x-\""),
            "scene.toml:6: system.fixed = \"x-\" (must be a list of groups of the mesh, held at rest)");
  EXPECT_EQ(refusal(6, "fixed = [1]"),
            "scene.toml:6: system.fixed[0] = 1 (must be the name of a group of the mesh)");
  EXPECT_EQ(refusal(20, "group = \"x-\""),
            "scene.toml:20: contact[0].group = \"x-\" (must have a node that can move)");
  EXPECT_EQ(refusal(15, "group = \"x-\""),
            "scene.toml:15: forcing.term[0].group = \"x-\" (must have nodes that can move, and faces with an "
            "area)");
  box_.groups.clear();
  write("model/box.msh", test::gmsh_text(box_));
  EXPECT_EQ(
      refusal(0, ""),
      "scene.toml:6: system.fixed[0] = \"x-\" (must be the name of a group of the mesh, which has none: in "
      "Gmsh, Physical Surface(\"NAME\"))");
}

TEST_F(MeshScene, IsRefusedIfNothingCanMove) {
  const test::BoxMesh one(4, {1, 1, 1}, {1.0, 1.0, 1.0});
  write("model/box.msh", test::gmsh_text(one));
  EXPECT_EQ(refusal(6, "fixed = [\"x-\", \"x+\"]"),
            "scene.toml:6: system.fixed = [\"x-\", \"x+\"] (must leave a node that can move)");
}

TEST_F(MeshScene, IsRefusedForWhatContradictsItself) {
  const std::string way = " (must be \"x+\", \"x-\", \"y+\", \"y-\", \"z+\" or \"z-\": the way to the stop)";
  for (const std::string direction : {"z", "w+", "z*", "+z", ""})
    EXPECT_EQ(refusal(21, "direction = \"" + direction + "\""),
              "scene.toml:21: contact[0].direction = \"" + direction + "\"" + way);
  EXPECT_EQ(refusal(21, ""), "scene.toml:19: contact[0].direction = missing" + way);
  EXPECT_EQ(refusal(20, "dof = 0"),
            "scene.toml:21: contact[0].direction = \"z-\" (must be absent: no group is given)");
  EXPECT_EQ(refusal(22, "gap = 0.1\ndof = 0"),
            "scene.toml:23: contact[0].dof = 0 (must be absent: group is given)");
  EXPECT_EQ(refusal(22, "gap = 0.1\nface = \"z+\""),
            "scene.toml:23: contact[0].face = \"z+\" (must be absent: group is given)");
  EXPECT_EQ(refusal(22, ""), "scene.toml:19: contact[0].gap = missing (must be a finite number [m])");
  EXPECT_EQ(refusal(20, "face = \"z+\""),
            "scene.toml:21: contact[0].direction = \"z-\" (must be absent: no group is given)");
  EXPECT_EQ(refusal(0, "", "[[contact]]\nface = \"z+\"\ngap = 0"),
            "scene.toml:24: contact[1].face = \"z+\" (must be absent: only a block has faces)");
  EXPECT_EQ(refusal(15, "face = \"x+\""),
            "scene.toml:15: forcing.term[0].face = \"x+\" (must be absent: only a block has faces)");
  EXPECT_EQ(refusal(15, "dof = 0"),
            "scene.toml:16: forcing.term[0].direction = \"y\" (must be absent: neither a face nor a group is "
            "given)");
  EXPECT_EQ(refusal(17, "dof = 0"),
            "scene.toml:15: forcing.term[0].group = \"x+\" (must be absent: dof is given)");
  EXPECT_EQ(refusal(17, "face = \"x+\""),
            "scene.toml:15: forcing.term[0].group = \"x+\" (must be absent: face is given)");
  EXPECT_EQ(refusal(16, ""),
            "scene.toml:14: forcing.term[0].direction = missing (must be \"x\", \"y\" or \"z\")");
  EXPECT_EQ(refusal(8, "poisson = 0.5"),
            "scene.toml:8: system.poisson = 0.5 (must be a number between -1 and 0.5 [-])");
  EXPECT_EQ(refusal(9, "density = 0"),
            "scene.toml:9: system.density = 0 (must be a positive number [kg/m^3])");
  EXPECT_EQ(
      refusal(9, "elements = 3"),
      "scene.toml:9: system.elements = 3 (unknown key; known: kind, mesh, fixed, young, poisson, density, "
      "damping, contact_mass)");
}

TEST(SceneOfAnotherKind, HasNoGroups) {
  const auto refusal = [](const std::string& tables) {
    return refused([&] { parse_scene(std::string(kBar) + tables, "bar.toml"); });
  };
  EXPECT_EQ(refusal("[[contact]]\ngroup = \"tip\"\ndirection = \"x+\"\ngap = 0.1\n"),
            "bar.toml:14: contact[0].group = \"tip\" (must be absent: only a mesh has groups)");
  EXPECT_EQ(refusal("[[forcing.term]]\ngroup = \"tip\"\ndirection = \"x\"\ncos = 1\n"),
            "bar.toml:14: forcing.term[0].group = \"tip\" (must be absent: only a mesh has groups)");
}

}  // namespace
}  // namespace signorini::scene_mesh_test
