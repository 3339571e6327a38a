#include "harness/plots/schematic_plot.hpp"

#include <gtest/gtest.h>

#include "harness/files.hpp"
#include "harness/schematic/drawing.hpp"
#include "harness/schematic/schematic.hpp"
#include "problems/scene/scene_layout.hpp"
#include "tests/harness/program.hpp"
#include "tests/problems/temporary_folder.hpp"

namespace signorini::schematic_plot_test {
namespace {

namespace fs = std::filesystem;

TEST(SchematicPlot, IsWrittenInTheFormatOfTheEnding) {
  const test::TemporaryFolder folder;
  const SceneSource source = find_scene("rotor-12-facets");
  const Drawing drawing = schematic(load_scene(source), load_outline(source).layout);
  for (const auto& [name, magic] : {std::pair{"a.svg", "<svg"}, {"a.pdf", "%PDF"}, {"a.png", "\x89PNG"}}) {
    write_schematic(folder.path() / name, drawing);
    EXPECT_EQ(read_file(folder.path() / name).rfind(magic, 0), 0U) << name;
  }
}

TEST(SchematicPlot, QuotesWordsForGnuplot) {
  Drawing drawing;
  drawing.add("line").strokes.push_back(
      {.places = {{0.0, 0.0}, {1.0, 1.0}}, .fill = Fill::body, .closed = true});
  drawing.add("text").labels.push_back({.words = "it's'; system('x')"});
  const Figure figure = schematic_figure(drawing);
  EXPECT_NE(figure.script.find("set label 'it''s''; system(''x'')' at"), std::string::npos) << figure.script;
  EXPECT_NE(figure.data.find("0.000 0.000\n1.000 1.000\n0.000 0.000\n"), std::string::npos);  // closed
}

TEST(SchematicPlot, OfTheDocumentsAreThoseOfTheCatalogue) {
  for (const char* name : {"beam20-ten-stops", "block-nine-contacts", "chain3-massless", "rotor-12-facets"}) {
    const SceneSource source = find_scene(name);
    EXPECT_EQ(read_file(fs::path(SIGNORINI_SOURCE_TREE) / "docs/pictures" / (std::string(name) + ".svg")),
              svg_of(schematic(load_scene(source), load_outline(source).layout)))
        << "signorini show " << name << " --plot docs/pictures/" << name << ".svg";
  }
}

TEST(PlotOption, OfShowDrawsTheSceneAndRefusesMethods) {
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "a.svg").string();
  EXPECT_EQ(test::run_program("show sdof-stop --plot " + file).code, 0);
  EXPECT_NE(read_file(file).find("g = 0.2 m"), std::string::npos);
  const test::Outcome outcome = test::run_program("show hat-lcp --plot " + file);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("a method has no picture"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace signorini::schematic_plot_test
