#include "problems/files/gmsh_mesh.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <sstream>

#include "problems/files/toml_tree.hpp"
#include "tests/problems/assembly/box_meshes.hpp"

namespace signorini::gmsh_mesh_test {
namespace {

using Places = std::vector<Eigen::Vector3d>;

// Two tetrahedra; their nodes not in order, some with parameters; a loose node; three named groups, of which
// one has an entity of another, one surface without a name, and one name that no entity has.
constexpr std::string_view kMesh = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
5
0 7 "tip"
1 4 "edge"
2 1 "foot side"
2 2 "unused"
3 1 "body"
$EndPhysicalNames
$Entities
1 1 2 1
1 0 0 1 1 7
4 0 0 0 1 0 0 1 -4 2 1 -2
5 0 0 0 1 1 0 2 1 9 1 4
6 0 0 0 1 1 1 0 1 4
1 0 0 0 1 1 1 1 1 0
$EndEntities
$Comments
whatever $Nodes says, 3 4
$EndComments
$Nodes
3 6 10 99
2 5 1 3
30
10
20
1 0 0 0.5 0.25
0 0 0 0.5 0.25
0 1 0 0.5 0.25
0 1 0 1
40
0 0 1e0
3 1 0 2
99
50
7 7 7
-1.5 0 0
$EndNodes
$Elements
7 7 1 7
0 1 15 1
1 40
1 4 1 1
2 10 20
2 5 2 1
3 10 20 30
2 6 16 1
4 10 20 30 40 99 50 10 20
3 1 4 2
5 10 30 20 40
6 10 20 50 40
3 9 4 0
2 6 2 1
7 20 30 40
$EndElements
)";

SolidMesh read(std::string_view text) { return read_gmsh_mesh(text, "a.msh"); }

std::string refusal(std::string_view text) {
  try {
    read(text);
    return "";
  } catch (const SceneError& error) {
    return error.what();
  }
}

// The good file with its line `number` replaced, by nothing at all if there is no replacement.
std::string with_line(int number, const std::optional<std::string>& replacement) {
  std::istringstream stream{std::string(kMesh)};
  std::string text;
  int count = 0;
  for (std::string line; std::getline(stream, line);) {
    if (++count != number)
      text += line + '\n';
    else if (replacement)
      text += *replacement + '\n';
  }
  return text;
}

// Without the lines from one to another, both included.
std::string without_lines(int first, int last) {
  std::istringstream stream{std::string(kMesh)};
  std::string text;
  int count = 0;
  for (std::string line; std::getline(stream, line);) {
    if (++count < first || count > last) text += line + '\n';
  }
  return text;
}

void expect_the_mesh(const SolidMesh& mesh) {
  EXPECT_EQ(mesh.nodes, (Places{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {-1.5, 0, 0}})) << "10 to 50";
  EXPECT_EQ(mesh.held, 0);
  ASSERT_EQ(mesh.solids.size(), 1U);
  EXPECT_EQ(mesh.solids[0].shape, shape_of_gmsh_type(4));
  EXPECT_EQ(mesh.solids[0].nodes, (std::vector<int>{0, 2, 1, 3, 0, 1, 4, 3}));
  std::vector<std::string> names;
  for (const auto& [name, group] : mesh.groups) names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{"9", "edge", "foot side", "tip"})) << "9 has no name";
  const auto expect_group = [&](const char* name, int type, const std::vector<int>& nodes) {
    const MeshGroup& group = mesh.groups.at(name);
    ASSERT_EQ(group.size(), 1U) << name;
    EXPECT_EQ(group[0].shape, shape_of_gmsh_type(type)) << name;
    EXPECT_EQ(group[0].nodes, nodes) << name;
  };
  expect_group("tip", 15, {3});
  expect_group("edge", 1, {0, 1});
  expect_group("foot side", 2, {0, 1, 2});
  expect_group("9", 2, {0, 1, 2});
}

TEST(ReadGmshMesh, HasTheNodesElementsAndGroupsOfTheFile) { expect_the_mesh(read(kMesh)); }

TEST(ReadGmshMesh, TakesLineEndsOfWindowsBlankLinesAndNoEndOfLine) {
  std::string windows, blank;
  for (const char c : kMesh) {
    windows += c == '\n' ? "\r\n" : std::string(1, c);
    blank += c == '\n' ? "\t\n  \n" : std::string(1, c);
  }
  expect_the_mesh(read(windows));
  expect_the_mesh(read(blank));
  expect_the_mesh(read(kMesh.substr(0, kMesh.size() - 1)));
}

TEST(ReadGmshMesh, PassesOverOtherSections) {
  expect_the_mesh(
      read(fmt::format("{}$NodeData\n1\n\"T\"\n$EndNodeData\n$Periodic\n0\n$EndPeriodic\n", kMesh)));
  expect_the_mesh(read(without_lines(20, 22)));
}

// Entities 4 and 5 and the volume are parts of a partition now, of parents whose groups they are in; of the
// two points of the file one is between the parts, whose group is its own.
TEST(ReadGmshMesh, ReadsAPartitionAsTheWhole) {
  std::string text = without_lines(13, 19);
  const std::string entities =
      "$Entities\n1 1 1 1\n1 0 0 1 1 7\n2 0 0 0 1 0 0 1 -4 0\n3 0 0 0 1 1 0 2 1 9 0\n1 0 0 0 1 1 1 1 1 0\n"
      "$EndEntities\n$PartitionedEntities\n2\n1\n77 2\n1 1 1 1\n1 0 1 1 1 0 0 1 0\n"
      "4 1 2 2 1 2 0 0 0 1 0 0 0 0\n5 2 3 1 1 0 0 0 1 1 0 0 0\n1 3 1 1 2 0 0 0 1 1 1 1 1 0\n"
      "$EndPartitionedEntities\n";
  text.replace(text.find("$Entities\n"), 10, entities);
  expect_the_mesh(read(text));
}

TEST(ReadGmshMesh, NeedsNeitherNamesNorEntities) {
  const SolidMesh mesh = read(without_lines(4, 19));
  EXPECT_EQ(mesh.nodes.size(), 5U);
  EXPECT_TRUE(mesh.groups.empty());
}

TEST(ReadGmshMesh, GivesAnEntityOfTwoGroupsToBoth) {
  const SolidMesh mesh = read(with_line(16, "5 0 0 0 1 1 0 2 1 2 0"));
  ASSERT_TRUE(mesh.groups.contains("unused"));
  EXPECT_EQ(mesh.groups.at("unused")[0].nodes, mesh.groups.at("foot side")[0].nodes);
  const SolidMesh same = read(with_line(9, "2 9 \"foot side\""));
  EXPECT_EQ(same.groups.at("foot side")[0].nodes, (std::vector<int>{0, 1, 2})) << "not twice";
}

TEST(ReadGmshMesh, ReturnsWhatWasWritten) {
  for (const int type : test::kSolidTypes) {
    const SolidMesh mesh = test::distorted_box(type, {2, 1, 2}, {1.2, 0.5, 0.3});
    const SolidMesh again = read(test::gmsh_text(mesh));
    EXPECT_EQ(again.nodes, mesh.nodes) << type;
    ASSERT_EQ(again.solids.size(), 1U);
    EXPECT_EQ(again.solids[0].shape, mesh.solids[0].shape);
    EXPECT_EQ(again.solids[0].nodes, mesh.solids[0].nodes) << type;
    ASSERT_EQ(again.groups.size(), 6U);
    for (const auto& [name, group] : mesh.groups)
      EXPECT_EQ(again.groups.at(name)[0].nodes, group[0].nodes) << type << " " << name;
  }
}

struct Malformed {
  int line;                                // of the good file, that is replaced
  std::optional<std::string> replacement;  // nothing: it is gone
  std::string message;
};

TEST(ReadGmshMesh, RefusesMalformedFilesInOneLine) {
  const std::string format =
      " (must be 4.1 0 8: a text file of that version, as gmsh -format msh41 writes it)";
  const std::string tag = "must be a whole number in 1..2147483648)";
  const std::string name = "must stand in \"\", of at most 127 bytes, without control characters";
  const std::string place = "must be a number within -1e60..1e60)";
  const std::vector<Malformed> cases{
      {1, "$Nodes", "1: file = \"$Nodes\" (must begin with $MeshFormat)"},
      {1, "solid cube", "1: file = \"solid cube\" (must begin with $MeshFormat)"},
      {2, "2.2 0 8", "2: format = \"2.2 0 8\"" + format},
      {2, "4 0 8", "2: format = \"4 0 8\"" + format},
      {2, "4.1 1 8", "2: format = \"4.1 1 8\"" + format},
      {2, "4.1", "2: format = \"4.1\" (must have 3 words)"},
      {3, "$Nodes", "3: line = \"$Nodes\" (must be $EndMeshFormat)"},
      {4, "PhysicalNames", "4: line = \"PhysicalNames\" (must begin a section, as $Nodes does)"},
      {5, "4", "10: line = \"3 1 \"body\"\" (must be $EndPhysicalNames)"},
      {5, "6", "11: name = \"$EndPhysicalNames\" (must have 3 words)"},
      {5, "-1", "5: count of names = \"-1\" (word 1 must be a whole number in 0..1000000)"},
      {5, "1e9", "5: count of names = \"1e9\" (word 1 must be a whole number in 0..1000000)"},
      {5, "1000001", "5: count of names = \"1000001\" (word 1 must be a whole number in 0..1000000)"},
      {6, "4 7 \"tip\"", "6: name = \"4 7 \"tip\"\" (word 1 must be a whole number in 0..3)"},
      {6, "0 0 \"tip\"", "6: name = \"0 0 \"tip\"\" (word 2 " + tag},
      {6, "0 7 tip", "6: name = \"0 7 tip\" (" + name + ")"},
      {6, "0 7 \"\"", "6: name = \"0 7 \"\"\" (" + name + ")"},
      {6, "0 7 \"", "6: name = \"0 7 \"\" (" + name + ")"},
      {6, "0 7 \"a\x1b[31m\"", "6: name = \"0 7 \"a\\x1b[31m\"\" (" + name + ")"},
      {13, "1 1 2", "13: counts of entities = \"1 1 2\" (must have 4 words)"},
      {13, "1 1 2 999999999999",
       "13: counts of entities = \"1 1 2 999999999999\" (word 4 must be a whole number in 0..1000000)"},
      {14, "1 0 0 1 2 7",
       "14: entity = \"1 0 0 1 2 7\" (word 7 must be a whole number in -2147483648..2147483648)"},
      {16, "5 0 0 0 1 1 0 999999 1",
       "16: entity = \"5 0 0 0 1 1 0 999999 1\" (word 10 must be a whole number in -2147483648..2147483648)"},
      {16, "5 0 0 0 1 1 0 1000001 1",
       "16: entity = \"5 0 0 0 1 1 0 1000001 1\" (word 8 must be a whole number in 0..1000000)"},
      {22, "$EndComment", "57: section = $Comments (must end with $EndComments)"},
      {23, "$Comments", "23: section = \"$Comments\" (must be there once)"},
      {23, std::nullopt, "23: line = \"3 6 10 99\" (must begin a section, as $Nodes does)"},
      {24, "3 5 10 99", "35: block of nodes = \"3 1 0 2\" (word 4 must be a whole number in 0..1)"},
      {24, "3 7 10 99", "39: nodes = 6 (must be 7)"},
      {24, "3 -1 10 99",
       "24: counts of nodes = \"3 -1 10 99\" (word 2 must be a whole number in 0..2000000)"},
      {24, "3 2000001 10 99",
       "24: counts of nodes = \"3 2000001 10 99\" (word 2 must be a whole number in 0..2000000)"},
      {24, "3 2000000 10 99", "39: nodes = 6 (must be 2000000)"},
      {24, "4 6 10 99", "40: block of nodes = \"$EndNodes\" (must have 4 words)"},
      {24, "2 4 10 99", "35: line = \"3 1 0 2\" (must be $EndNodes)"},
      {25, "2 5 1 -3", "25: block of nodes = \"2 5 1 -3\" (word 4 must be a whole number in 0..6)"},
      {25, "2 5 1 4", "33: place of a node = \"40\" (must have 3 words)"},
      {26, "10", "39: node = 10 (must be given once)"},
      {26, "0", "26: node = \"0\" (word 1 " + tag},
      {26, "2147483649", "26: node = \"2147483649\" (word 1 " + tag},
      {26, "1.5", "26: node = \"1.5\" (word 1 " + tag},
      {29, "nan 0 0", "29: place of a node = \"nan 0 0\" (word 1 " + place},
      {29, "0 inf 0", "29: place of a node = \"0 inf 0\" (word 2 " + place},
      {29, "0 0 -1e999", "29: place of a node = \"0 0 -1e999\" (word 3 " + place},
      {29, "0 0 1e101", "29: place of a node = \"0 0 1e101\" (word 3 " + place},
      {29, "0 0", "29: place of a node = \"0 0\" (must have 3 words)"},
      {29, "0,0 0 0", "29: place of a node = \"0,0 0 0\" (word 1 " + place},
  };
  for (const Malformed& given : cases)
    EXPECT_EQ(refusal(with_line(given.line, given.replacement)), "a.msh:" + given.message);
  EXPECT_EQ(refusal(""), "a.msh:1: file = empty (must begin with $MeshFormat)");
  EXPECT_EQ(refusal("\n \n"), "a.msh:2: file = empty (must begin with $MeshFormat)");
}

TEST(ReadGmshMesh, RefusesMalformedElementsInOneLine) {
  const std::string tag = "must be a whole number in 1..2147483648)";
  const std::string solids =
      " (word 3, the type of elements, must be one of 4 (tetrahedra of 4 nodes), 11 (tetrahedra of 10 "
      "nodes), 5 "
      "(hexahedra of 8 nodes), 12 (hexahedra of 27 nodes)";
  const std::string faces =
      " (word 3, the type of elements, must be one of 2 (triangles of 3 nodes), 9 (triangles of 6 nodes), 3 "
      "(quadrangles of 4 nodes), 10 (quadrangles of 9 nodes)";
  const std::string complete = ": Mesh.SecondOrderIncomplete = 0 makes complete ones)";
  const std::vector<Malformed> cases{
      {42, "7 6 1 7", "55: block of elements = \"2 6 2 1\" (word 4 must be a whole number in 0..0)"},
      {42, "7 8 1 7", "56: elements = 1 too few (must be as many as their count says)"},
      {42, "7 -7 1 7",
       "42: counts of elements = \"7 -7 1 7\" (word 2 must be a whole number in 0..20000000)"},
      {42, "7 9999999999 1 7",
       "42: counts of elements = \"7 9999999999 1 7\" (word 2 must be a whole number in 0..20000000)"},
      {42, "7 20000000 1 7", "56: elements = 19999993 too few (must be as many as their count says)"},
      {42, "1000000 7 1 7", "57: block of elements = \"$EndElements\" (must have 4 words)"},
      {43, "4 1 15 1", "43: block of elements = \"4 1 15 1\" (word 1 must be a whole number in 0..3)"},
      {44, "1 41", "44: element = \"1 41\" (word 2 must be the tag of a node)"},
      {44, "1 -40", "44: element = \"1 -40\" (word 2 " + tag},
      {44, "1", "44: element = \"1\" (must have 2 words)"},
      {44, "1 50", ""},
      {44, "1 99", "57: group = tip (node 99 must be one of a solid element)"},
      {47, "2 5 16 1",
       "47: block of elements = \"2 5 16 1\"" + faces + "; 16 are quadrangles of 8 nodes" + complete},
      {47, "2 5 4 1", "47: block of elements = \"2 5 4 1\"" + faces + ")"},
      {51, "3 1 17 2",
       "51: block of elements = \"3 1 17 2\"" + solids + "; 17 are hexahedra of 20 nodes" + complete},
      {51, "3 1 6 2",
       "51: block of elements = \"3 1 6 2\"" + solids +
           "; 6 are prisms of 6 nodes: without Recombine and layers of prisms, Gmsh makes tetrahedra of the "
           "volume)"},
      {51, "3 1 29 2",
       "51: block of elements = \"3 1 29 2\"" + solids + "; gmsh -order 2 makes the second degree)"},
      {51, "3 1 2 2", "51: block of elements = \"3 1 2 2\"" + solids + ")"},
      {51, "3 1 0 2", "51: block of elements = \"3 1 0 2\" (word 3 must be a whole number in 1..2147483647)"},
      {51, "3 1 11 2", "52: element = \"5 10 30 20 40\" (must be its tag and 10 nodes)"},
      {51, "3 1 4 1", "53: block of elements = \"6 10 20 50 40\" (word 1 must be a whole number in 0..3)"},
      {52, "5 10 30 20", "52: element = \"5 10 30 20\" (must be its tag and 4 nodes)"},
      {52, "5 10 30 20 40 50", "52: element = \"5 10 30 20 40 50\" (must be its tag and 4 nodes)"},
      {52, "5 10 30 20 x", "52: element = \"5 10 30 20 x\" (word 5 " + tag},
      {57, "$EndElement", "57: line = \"$EndElement\" (must be $EndElements)"},
      {57, std::nullopt, "56: line = \"7 20 30 40\" (must be $EndElements)"},
  };
  for (const Malformed& given : cases)
    EXPECT_EQ(refusal(with_line(given.line, given.replacement)),
              given.message.empty() ? "" : "a.msh:" + given.message);
  EXPECT_EQ(refusal(without_lines(23, 40)), "a.msh:23: section = \"$Elements\" (must come after $Nodes)");
  const std::string none =
      "elements = no solid (must be tetrahedra or hexahedra: in Gmsh, Mesh 3 and a named "
      "physical volume)";
  EXPECT_EQ(refusal(without_lines(41, 57)), "a.msh:40: " + none);
  EXPECT_EQ(refusal("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"), "a.msh:3: " + none);
}

TEST(ReadGmshMesh, ShowsNoMoreOfALongLineThanAMessageHolds) {
  std::string line(100'000, 'x');
  line.append(" 0 0");
  const std::string message = refusal(with_line(29, line));
  EXPECT_LT(message.size(), 200U) << message;
  EXPECT_EQ(message.find("a.msh:29: place of a node = \"xxxxxxxxxxxx"), 0U);
}

TEST(ReadGmshMesh, RefusesEveryFileThatEndsTooEarly) {
  const std::size_t whole = kMesh.size() - 1;  // its last line may do without an end
  for (std::size_t length = 0; length < whole; ++length) {
    const std::string message = refusal(kMesh.substr(0, length));
    EXPECT_EQ(message.substr(0, 6), "a.msh:") << length;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  EXPECT_EQ(refusal(kMesh.substr(0, whole)), "");
}

TEST(ReadGmshMesh, NeverFallsOverNoise) {
  std::mt19937 random(99);
  std::uniform_int_distribution<int> byte(0, 255);
  std::uniform_int_distribution<std::size_t> place(0, kMesh.size() - 1);
  int refused = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::string text(kMesh);
    for (int i = 0; i < 3; ++i) text[place(random)] = static_cast<char>(byte(random));
    const std::string message = refusal(text);
    if (message.empty()) continue;
    ++refused;
    EXPECT_EQ(message.substr(0, 6), "a.msh:");
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace signorini::gmsh_mesh_test
