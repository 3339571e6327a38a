#include "harness/schematic/schematic.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "harness/schematic/drawing.hpp"
#include "problems/scene/scene_layout.hpp"
#include "tests/problems/temporary_folder.hpp"

namespace signorini::schematic_test {
namespace {

Drawing drawn(const SceneSource& source) {
  return schematic(load_scene(source), load_outline(source).layout, load_outline(source).damped_stops);
}
Drawing drawn(const std::string& name) { return drawn(find_scene(name)); }

/// A scene of these tables, driven at its first coordinate.
Drawing drawn_text(const std::string& tables) {
  const test::TemporaryFolder folder;
  const auto file = folder.write(
      "own.toml",
      "schema = 1\nname = \"own\"\n[forcing]\nfrequency = 1\n[[forcing.term]]\ndof = 0\ncos = 1\n" + tables);
  return drawn(SceneSource(file));
}

std::map<std::string, int> counts(const Drawing& drawing) {
  std::map<std::string, int> found;
  for (const Part& part : drawing.parts) ++found[part.kind];
  return found;
}

std::vector<std::string> texts(const Drawing& drawing, const std::string& kind) {
  std::vector<std::string> found;
  for (const Part& part : drawing.parts)
    for (const Label& label : part.labels)
      if (part.kind == kind) found.push_back(label.words);
  return found;
}

std::size_t strokes(const Drawing& drawing) {
  std::size_t count = 0;
  for (const Part& part : drawing.parts) count += part.strokes.size();
  return count;
}

/// Everything on the sheet, in letters of 0.55 times their size, which is wide.
void expect_on_the_sheet(const Drawing& drawing, const std::string& name) {
  const Box box = extent(drawing);
  const auto inside = [&](double x, double y) {
    return std::isfinite(x) && std::isfinite(y) && x >= box.low.x() - kDrawingMargin &&
           x <= box.high.x() + kDrawingMargin && y >= box.low.y() - kDrawingMargin &&
           y <= box.high.y() + kDrawingMargin;
  };
  EXPECT_LT(box.size().x(), 32.0) << name;
  EXPECT_LT(box.size().y(), 20.0) << name;
  for (const Part& part : drawing.parts) {
    for (const Stroke& stroke : part.strokes)
      for (const Place& place : stroke.places)
        EXPECT_TRUE(inside(place.x(), place.y())) << name << " " << part.kind;
    for (const Label& label : part.labels) {
      double letters = 0.0;
      for (const char c : label.words)
        letters += (static_cast<unsigned char>(c) & 0xC0U) == 0x80U ? 0.0 : 1.0;
      const double width = 0.55 * kTextSize * letters;
      const double left = label.place.x() - (label.anchor == Anchor::start    ? 0.0
                                             : label.anchor == Anchor::middle ? 0.5 * width
                                                                              : width);
      EXPECT_TRUE(inside(left, label.place.y()) && inside(left + width, label.place.y() + kTextSize))
          << name << ": " << label.words;
    }
  }
}

/// No two texts of loads upon each other.
void expect_loads_apart(const Drawing& drawing, const std::string& name) {
  std::vector<Label> labels;
  for (const Part& part : drawing.parts)
    for (const Label& label : part.labels)
      if (part.kind == "load" && !label.words.empty()) labels.push_back(label);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const Box one = extent(labels[i]), other = extent(labels[k]);
      const bool apart =
          (one.low.array() >= other.high.array()).any() || (other.low.array() >= one.high.array()).any();
      EXPECT_TRUE(apart) << name << ": " << labels[k].words << ", " << labels[i].words;
    }
  }
}

TEST(Schematic, DrawsEverySceneThatShipsWithItsStopsAndGaps) {
  for (const SceneSource& source : shipped_scenes()) {
    if (load_header(source).carries(kLarge)) continue;
    const Problem problem = load_scene(source);
    const Drawing drawing = drawn(source);
    expect_on_the_sheet(drawing, problem.name);
    expect_loads_apart(drawing, problem.name);
    const auto parts = counts(drawing);
    EXPECT_EQ(problem.contacts.empty(), !parts.contains("stop")) << problem.name;
    EXPECT_EQ(problem.contacts.empty(), !parts.contains("gap")) << problem.name;
    for (const std::string& words : texts(drawing, "gap"))
      EXPECT_NE(words.find("g = "), std::string::npos) << problem.name;
    EXPECT_EQ(problem.force.empty(), !parts.contains("load")) << problem.name;
  }
}

TEST(Schematic, OfAnOscillatorHasItsParts) {
  const Drawing drawing = drawn("sdof-stop");
  const auto parts = counts(drawing);
  for (const char* kind : {"mass", "spring", "damper", "stop", "load"}) EXPECT_EQ(parts.at(kind), 1) << kind;
  EXPECT_EQ(parts.at("wall"), 2);  // the left end and the floor
  EXPECT_EQ(texts(drawing, "gap"), std::vector<std::string>{"g = 0.2 m"});
  EXPECT_EQ(texts(drawing, "load"), std::vector<std::string>{"1 cos ωt N"});
  EXPECT_EQ(texts(drawing, "mass"), std::vector<std::string>{"1 kg"});
  EXPECT_EQ(texts(drawing, "note"), std::vector<std::string>{"ω = 2.2 rad/s, e = 1"});
}

TEST(Schematic, OfADampedStopHasItsSpringAndItsDamperAtTheMass) {
  const Drawing drawing = drawn("sdof-damped-stop");
  EXPECT_EQ(counts(drawing).at("mass"), 1);
  EXPECT_EQ(counts(drawing).at("stop"), 1);
  EXPECT_EQ(texts(drawing, "gap"), std::vector<std::string>{"g = 0.2 m"});
  EXPECT_EQ(texts(drawing, "note"), std::vector<std::string>{"ω = 2 rad/s, stop of 100 N/m and 4 N s/m"});
  const auto stop_strokes = [](const Drawing& of) {
    const auto stop = std::ranges::find(of.parts, std::string("stop"), &Part::kind);
    return stop->strokes.size();
  };
  const std::size_t spring = stop_strokes(
      drawn_text("[system]\nkind = \"sdof\"\nmass = 1\ndamping = 0.1\nstiffness = 1\n[[contact]]\ndof = 0\n"
                 "gap = 0.2\n[law]\npenalty = 100\n"));
  EXPECT_EQ(stop_strokes(drawing), spring + 4) << "rod, cylinder, piston and rod";
}

TEST(Schematic, OfTwoSidedStopsHasOneOnEachSideOfAPin) {
  const Drawing drawing = drawn("sdof-two-sided-uneven");
  EXPECT_EQ(counts(drawing).at("stop"), 2);
  EXPECT_EQ(texts(drawing, "gap"), (std::vector<std::string>{"g = 0.3 m", "g = 0.8 m"}));
}

TEST(Schematic, OfAChainHasEachElement) {
  const auto parts = counts(drawn("chain10-stops"));
  for (const char* kind : {"mass", "spring", "damper", "stop"}) EXPECT_EQ(parts.at(kind), 10) << kind;
  EXPECT_EQ(counts(drawn("chain3-massless")).at("node"), 1);
  EXPECT_EQ(counts(drawn("chain3-massless")).at("damper"), 2);
}

TEST(Schematic, OfANetworkHasLinksGroundAndStopsBetweenMasses) {
  const Drawing drawing = drawn_text(
      "[system]\nkind = \"chain\"\nmasses = [1, 1, 1]\nsprings = [0, 1, 1]\ndampers = [0, 0, 0]\n"
      "ground_springs = [2, 0, 2]\nlinks = [[0, 2, 3.0, 0.5]]\n[[contact]]\nnormal = [[0, 1.0], [1, "
      "-1.0]]\ngap = 0.1\n"
      "[[contact]]\nnormal = [[2, 1.0], [1, -1.0]]\ngap = 0.4\n[[contact]]\nnormal = [[0, 1.0], [1, "
      "1.0]]\ngap = 1\n"
      "[law]\nrestitution = 0.5\n");
  const auto parts = counts(drawing);
  EXPECT_EQ(parts.at("spring"), 2 + 2 + 1);
  EXPECT_EQ(parts.at("damper"), 1);
  EXPECT_EQ(parts.at("wall"), 2);  // of the two ground springs: no element joins the row to a wall
  EXPECT_EQ(texts(drawing, "gap"), (std::vector<std::string>{"g = 0.1 m", "g = 0.4 m"}));
  EXPECT_NE(texts(drawing, "note").front().find("1 contact of several coordinates not drawn"),
            std::string::npos);
  expect_on_the_sheet(drawing, "network");
}

TEST(Schematic, OfStructuresHasMeshContactsAndLoads) {
  EXPECT_EQ(counts(drawn("beam20-ten-stops")).at("stop"), 10);
  EXPECT_EQ(texts(drawn("beam20-ten-stops"), "gap"), std::vector<std::string>{"10 stops, g = 0.037 … 0.1 m"});
  EXPECT_EQ(counts(drawn("beam-pair")).at("beam"), 2);
  EXPECT_EQ(counts(drawn("beam-pair")).at("stop"), 3);
  EXPECT_EQ(counts(drawn("bar10-massless")).at("stop"), 1);
  const Drawing block = drawn("block-nine-contacts");
  EXPECT_EQ(counts(block).at("face"), 3);
  EXPECT_EQ(texts(block, "gap"), std::vector<std::string>{"9 nodes, g = 0.02 m"});
  EXPECT_EQ(texts(block, "load"), std::vector<std::string>{"4·10⁻⁵ cos ωt N"});
  const Drawing rotor = drawn("rotor-12-facets");
  EXPECT_EQ(texts(rotor, "gap"), std::vector<std::string>{"g = 0.2 m"});
  EXPECT_NE(texts(rotor, "note").front().find("stator of 12 facets"), std::string::npos);
  EXPECT_EQ(counts(drawn("shaft-12-facets")).at("spring"), 2);
  EXPECT_EQ(texts(drawn("matrices-cantilever"), "contact-node"), std::vector<std::string>{"u[18]"});
}

TEST(Schematic, OfAMeshHasItsEdgesSupportStopsAndLoads) {
  const Drawing drawing = drawn("mesh-fan-blade");
  const auto parts = counts(drawing);
  for (const char* kind : {"edges", "support", "stop", "gap", "load"})
    EXPECT_EQ(parts.count(kind), 1U) << kind;
  EXPECT_EQ(parts.at("stop"), 1) << "all contacts are upwards";
  EXPECT_EQ(parts.at("load"), 1) << "the load is along y";
  for (const Part& part : drawing.parts) {
    if (part.kind != "edges" && part.kind != "support") continue;
    EXPECT_GT(part.strokes.size(), 20U) << part.kind;
  }
  const std::size_t contacts = load_scene(find_scene("mesh-fan-blade")).contacts.size();
  EXPECT_EQ(texts(drawing, "gap"), std::vector<std::string>{fmt::format("{} nodes, g = 0.0002 m", contacts)});
  expect_on_the_sheet(drawing, "mesh-fan-blade");
  expect_loads_apart(drawing, "mesh-fan-blade");
}

/// Tables [[contact]] on every `pitch`-th coordinate, a hundred in all.
std::string hundred_contacts(int pitch) {
  std::string tables;
  for (int i = 1; i <= 100; ++i)
    tables += fmt::format("[[contact]]\ndof = {}\ngap = {}\n", pitch * i - pitch % 2, 0.1 + 0.001 * i);
  return tables + "[law]\npenalty = 10\n";
}

TEST(Schematic, OfTenThousandElementsAndAHundredContactsStaysLegible) {
  const std::string bar =
      "elements = 10000\nlength = 1\narea = 1\nyoung = 1\ndensity = 1\ndamping = { alpha = 1 }\n";
  std::string ones = "[1";
  for (int i = 1; i < 10000; ++i) ones += ", 1";
  ones += "]";
  for (const std::string& tables : {"[system]\nkind = \"bar\"\n" + bar + hundred_contacts(99),
                                    "[system]\nkind = \"beam\"\ninertia = 1\n" + bar + hundred_contacts(100),
                                    "[system]\nkind = \"chain\"\nmasses = " + ones + "\nsprings = " + ones +
                                        "\ndampers = " + ones + "\n" + hundred_contacts(99)}) {
    const Drawing drawing = drawn_text(tables);
    EXPECT_LT(strokes(drawing), 400U) << tables.substr(0, 30);
    EXPECT_LT(drawing.parts.size(), 120U) << tables.substr(0, 30);
    expect_on_the_sheet(drawing, tables.substr(0, 30));
    const std::string svg = svg_of(drawing);
    EXPECT_NE(svg.find("10000 "), std::string::npos);
    EXPECT_LT(svg.size(), 60000U);
  }
}

}  // namespace
}  // namespace signorini::schematic_test
