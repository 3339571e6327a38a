#include "problems/scene/scene_file.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <fstream>
#include <random>
#include <sstream>

#include "tests/problems/scene/malformed_scenes.hpp"
#include "tests/problems/scene/malformed_structures.hpp"
#include "tests/problems/temporary_folder.hpp"

namespace signorini::test::scene_file_test {
namespace {

namespace fs = std::filesystem;

std::string spoiled(const Malformed& bad) {
  if (bad.line == 0) return std::string(bad.replacement);
  std::istringstream stream{std::string(bad.scene)};
  std::string text;
  int number = 0;
  for (std::string original; std::getline(stream, original);) {
    text += ++number == bad.line ? std::string(bad.replacement) : original;
    text += '\n';
  }
  return text;
}

// What the reader says, "" if nothing.
std::string complaint(std::string_view text) {
  try {
    parse_scene(text, "bad.toml");
    return "";
  } catch (const SceneError& error) {
    return error.what();
  }
}

template <class Action>
std::string scene_error(Action action) {
  try {
    action();
    return "";
  } catch (const SceneError& error) {
    return error.what();
  }
}

class MalformedScene : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedScene, IsRefusedInOneLineThatNamesTheCulprit) {
  EXPECT_EQ(complaint(spoiled(GetParam())), "bad.toml:" + std::string(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(Table, MalformedScene, testing::ValuesIn(kMalformed),
                         [](const auto& info) { return std::string(info.param.label); });

INSTANTIATE_TEST_SUITE_P(Structures, MalformedScene, testing::ValuesIn(kMalformedStructures),
                         [](const auto& info) { return std::string(info.param.label); });

TEST(ParseScene, AcceptsTheScenesThatTheTableSpoils) {
  EXPECT_EQ(complaint(kOscillator), "");
  EXPECT_EQ(complaint(kContactFree), "");
  EXPECT_EQ(complaint(kChain), "");
  EXPECT_EQ(complaint(kBar), "");
  EXPECT_EQ(complaint(kBeam), "");
  EXPECT_EQ(complaint(kRotor), "");
  EXPECT_EQ(complaint(kShaft), "");
  EXPECT_EQ(complaint(kBlock), "");
}

TEST(ParseScene, SaysWhereTextIsNotToml) {
  const auto expect = [](std::string_view text, std::string_view line) {
    const std::string message = complaint(text);
    const std::string beginning =
        "bad.toml:" + std::string(line) + ": file = not TOML (must be valid TOML 1.0; ";
    EXPECT_EQ(message.substr(0, beginning.size()), beginning);
    EXPECT_TRUE(message.ends_with(")")) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  };
  expect("schema = = 1\n", "1");
  expect("schema = 1\nname\n", "2");
  expect("schema = 1\nname = \"open\n", "2");
  expect("schema = 1\n[system\n", "2");
  expect("schema = 1\nschema = 1\n", "2");
  expect("schema = 1\n[law]\n[law]\n", "3");
  expect("a = " + std::string(100000, '['), "1");
  expect(std::string_view("\x7f"
                          "ELF\x02\x01\x01\0\0\0",
                          10),
         "1");
  expect("schema = 1\nname = \"\xff\xfe\"\n", "2");
}

TEST(ParseScene, NeverFallsOverNoise) {
  std::mt19937 random(4711);
  std::uniform_int_distribution<int> byte(0, 255);
  std::uniform_int_distribution<std::size_t> place(0, kOscillator.size() - 1);
  int refused = 0;
  for (int trial = 0; trial < 500; ++trial) {
    std::string text(kOscillator);
    for (int i = 0; i < 3; ++i) text[place(random)] = static_cast<char>(byte(random));
    const std::string message = complaint(text);
    if (message.empty()) continue;
    ++refused;
    EXPECT_EQ(message.substr(0, 9), "bad.toml:");
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  EXPECT_GT(refused, 250) << "most of it is damage";
}

constexpr const char* kEveryField = R"(
  schema = 1
  name = "all-fields2"
  title = "Everything at once"
  reference = "nowhere"
  tags = ["one", "two words"]
  [system]
  kind = "chain"
  masses = [1, 2.5, 4]
  dampers = [0.0, 0.5, 0.25]
  springs = [10, 20, 40.0]
  [forcing]
  frequency = 3
  subharmonic = 2
  [[forcing.term]]
  dof = 2
  harmonic = 0
  cos = -1
  [[forcing.term]]
  dof = 0
  sin = 0.5
  [[forcing.term]]
  dof = 1
  harmonic = 5
  cos = 2.0
  sin = -3
  [[contact]]
  dof = 1
  gap = 0
  [[contact]]
  normal = [[2, 0.8], [0, -0.6]]
  gap = -0.25
  [law]
  penalty = [1e3, 2000]
)";

TEST(ParseScene, KeepsEveryField) {
  const Problem problem = parse_scene(kEveryField, "all.toml");
  EXPECT_EQ(problem.name, "all-fields2");
  EXPECT_EQ(problem.title, "Everything at once");
  EXPECT_EQ(problem.reference, "nowhere");
  EXPECT_EQ(problem.tags, (std::vector<std::string>{"one", "two words"}));
  EXPECT_EQ(problem.kind, "chain");
  EXPECT_EQ(Eigen::MatrixXd(problem.mass()), Eigen::MatrixXd(Eigen::Vector3d(1.0, 2.5, 4.0).asDiagonal()));
  Eigen::Matrix3d D;
  D << 0.5, -0.5, 0, -0.5, 0.75, -0.25, 0, -0.25, 0.25;
  EXPECT_EQ(Eigen::MatrixXd(problem.damping()), D);
  Eigen::Matrix3d K;
  K << 30, -20, 0, -20, 60, -40, 0, -40, 40;
  EXPECT_EQ(Eigen::MatrixXd(problem.stiffness()), K);
  EXPECT_EQ(problem.frequency, 3.0);
  EXPECT_EQ(problem.subharmonic, 2);
  ASSERT_EQ(problem.force.size(), 3U);
  const auto expect_term = [&](std::size_t i, int dof, int harmonic, double cos, double sin) {
    EXPECT_EQ(problem.force[i].dof, dof);
    EXPECT_EQ(problem.force[i].harmonic, harmonic);
    EXPECT_EQ(problem.force[i].cos, cos);
    EXPECT_EQ(problem.force[i].sin, sin);
  };
  expect_term(0, 2, 0, -1.0, 0.0);
  expect_term(1, 0, 1, 0.0, 0.5);
  expect_term(2, 1, 5, 2.0, -3.0);
  ASSERT_EQ(problem.contacts.size(), 2U);
  EXPECT_EQ(problem.contacts[0].normal, (std::vector<std::pair<int, double>>{{1, 1.0}}));
  EXPECT_EQ(problem.contacts[0].gap, 0.0);
  EXPECT_EQ(problem.contacts[1].normal, (std::vector<std::pair<int, double>>{{2, 0.8}, {0, -0.6}}));
  EXPECT_EQ(problem.contacts[1].gap, -0.25);
  EXPECT_EQ(std::get<Penalty>(problem.law()).stiffness, (std::vector<double>{1000.0, 2000.0}));
}

TEST(ParseScene, FillsInWhatIsLeftOut) {
  const Problem problem = parse_scene(kContactFree, "free.toml");

  EXPECT_EQ(problem.kind, "sdof");
  EXPECT_EQ(problem.size(), 1);
  EXPECT_EQ(problem.damping().coeff(0, 0), 0.1);
  EXPECT_EQ(problem.title + problem.reference, "");
  EXPECT_TRUE(problem.tags.empty());
  EXPECT_EQ(problem.subharmonic, 1);
  EXPECT_TRUE(problem.force.empty());
  EXPECT_TRUE(std::holds_alternative<std::monostate>(problem.law()));
}

TEST(ParseScene, InfersTheLawOfMasslessContacts) {
  EXPECT_TRUE(std::holds_alternative<Massless>(parse_scene(kChain, "massless.toml").law()));
  const Problem penalty = parse_scene(std::string(kChain) + "[law]\npenalty = 7.0\n", "penalty.toml");
  EXPECT_EQ(std::get<Penalty>(penalty.law()).stiffness, std::vector<double>{7.0});
}

TEST(ParseScene, AssemblesBarsAndBeams) {
  const Problem bar = parse_scene(kBar, "bar.toml");
  EXPECT_EQ(bar.kind, "bar");
  EXPECT_EQ(bar.size(), 3);
  EXPECT_DOUBLE_EQ(bar.stiffness().coeff(0, 0), 6.0);
  EXPECT_DOUBLE_EQ(bar.mass().coeff(2, 2), 1.0 / 9.0);
  EXPECT_DOUBLE_EQ(bar.damping().coeff(2, 2), 0.1 / 9.0 + 0.01 * 3.0);

  const Problem beam = parse_scene(kBeam, "beam.toml");
  EXPECT_EQ(beam.size(), 4);
  EXPECT_DOUBLE_EQ(beam.stiffness().coeff(2, 2), 12.0 * 8.0);
  EXPECT_TRUE(std::holds_alternative<Massless>(beam.law())) << "implied by contact_mass";
  EXPECT_EQ(contacts_with_mass(beam), std::vector<bool>(beam.contacts.size(), false));
}

TEST(ParseScene, MakesContactsAndLoadsOfTheFacesOfABlock) {
  const Problem block =
      parse_scene(std::string(kBlock) + "[[contact]]\nface = \"y-\"\ngap = 0.25\n", "b.toml");
  EXPECT_EQ(block.kind, "block");
  ASSERT_EQ(block.size(), 2 * 4 * 5 * 3);
  ASSERT_EQ(block.contact_count(), 2 * 2 + 2 * 5);
  // Node (1, 1, 4): the numbering of the manual.
  EXPECT_EQ(block.contacts[1].normal, (std::vector<std::pair<int, double>>{{3 * (1 * 5 + 4) + 2, 1.0}}));
  EXPECT_EQ(block.contacts[1].gap, 0.5);
  EXPECT_EQ(block.contacts[4].normal, (std::vector<std::pair<int, double>>{{1, -1.0}}));
  EXPECT_TRUE(std::holds_alternative<Massless>(block.law()));
  const Eigen::VectorXd load = load_at(block, 0.0);
  EXPECT_NEAR(load.sum(), 1.0, 1e-14);
  EXPECT_NEAR(load(3 * 20 + 2), 1.0 / 12.0 / 4.0, 1e-15) << "a corner bears a quarter of a brick's share";
}

TEST(ParseScene, AssemblesAShaft) {
  const Problem shaft = parse_scene(kShaft, "shaft.toml");
  EXPECT_EQ(shaft.kind, "shaft");
  EXPECT_EQ(shaft.size(), 20);
  EXPECT_EQ(shaft.contact_count(), 5);
  EXPECT_DOUBLE_EQ(shaft.stiffness().coeff(0, 0), 12.0 * 64.0 + 1.0);
  EXPECT_DOUBLE_EQ(shaft.damping().coeff(0, 0), 0.1 + 0.01 * (12.0 * 64.0 + 1.0));
  EXPECT_DOUBLE_EQ(shaft.mass().coeff(10, 10), 1.0 + 2.0 * 156.0 / 420.0 / 4.0);
}

TEST(ParseScene, AssemblesAChainWithGroundAndLinks) {
  std::string text(kChain);
  const std::string_view springs = "springs = [1.0, 1.0, 50.0]\n";
  text.insert(text.find(springs) + springs.size(),
              "ground_springs = [4, 0, 0]\nground_dampers = [0, 0.5, 0]\nlinks = [[0, 2, 3.0, 0.25]]\n");
  const Problem chain = parse_scene(text, "chain.toml");
  EXPECT_EQ(chain.stiffness().coeff(0, 0), 1.0 + 1.0 + 4.0 + 3.0);
  EXPECT_EQ(chain.stiffness().coeff(2, 0), -3.0);
  EXPECT_EQ(chain.damping().coeff(1, 1), 0.1 + 0.5);
  EXPECT_EQ(chain.damping().coeff(0, 2), -0.25);
}

TEST(ParseScene, TakesConsistentMassUnlessToldOtherwise) {
  std::string text(kBar);
  text.erase(text.find("contact_mass"), std::string_view("contact_mass = \"consistent\"\n").size());
  EXPECT_EQ(Eigen::MatrixXd(parse_scene(text, "bar.toml").mass()),
            Eigen::MatrixXd(parse_scene(kBar, "bar.toml").mass()));
}

TEST(ParseScene, GivesEveryContactTheOnePenalty) {
  std::string text(kOscillator);
  text.replace(text.find("restitution = 1.0"), 17, "penalty = 50");
  text += "[[contact]]\nnormal = [[0, -1]]\ngap = 1\n";
  EXPECT_EQ(std::get<Penalty>(parse_scene(text, "two.toml").law()).stiffness,
            (std::vector<double>{50.0, 50.0}));
}

TEST(LoadScene, NamesTheFileInItsComplaint) {
  const TemporaryFolder folder;
  EXPECT_EQ(load_scene(folder.write("good.toml", kOscillator)).name, "bad");

  const fs::path empty = folder.write("empty.toml", "");
  EXPECT_EQ(scene_error([&] { load_scene(empty); }), empty.string() + ":1: schema = missing (must be 1)");
  const fs::path absent = folder.path() / "absent.toml";
  EXPECT_EQ(scene_error([&] { load_scene(absent); }), absent.string() + ": file = missing (must exist)");
  EXPECT_EQ(scene_error([&] { load_scene(folder.path()); }),
            folder.path().string() + ": file = a folder (must be a file)");
  const fs::path huge = folder.write("huge.toml", std::string((1U << 24U) + 1, '#'));
  EXPECT_EQ(scene_error([&] { load_scene(huge); }),
            huge.string() + ": file = more than 16 MiB (must be a file of at most 16 MiB)");
}

TEST(LoadScene, RefusesAFileThatCannotBeRead) {
  // Opens, but its first page is never mapped: the read fails even for root.
  EXPECT_EQ(scene_error([] { load_scene(fs::path("/proc/self/mem")); }),
            "/proc/self/mem: file = unreadable (must be a file that may be read)");
}

// Numbers each within their range, whose structure is not: modes of a bar of 1e300 m.
TEST(ParseScene, RefusesAStructureThatCannotBeAssembled) {
  const std::string bar =
      "schema = 1\nname = \"long\"\n[system]\nkind = \"bar\"\nelements = 10\nlength = 1e300\narea = 1e-4\n"
      "young = 2e11\ndensity = 7800.0\ndamping = { modal = 0.01 }\n[forcing]\nfrequency = 1.0\n";
  try {
    parse_scene(bar, "bar.toml");
    FAIL() << "a bar of 1e300 m";
  } catch (const SceneError& error) {
    EXPECT_NE(std::string(error.what()).find("bar.toml:"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace signorini::test::scene_file_test
