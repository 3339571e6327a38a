#include "harness/plots/motion_plot.hpp"

#include <gtest/gtest.h>

#include "harness/plots/plot_file.hpp"
#include "harness/report/figures/gnuplot.hpp"
#include "tests/harness/sample_records.hpp"
#include "tests/problems/temporary_folder.hpp"

namespace signorini::motion_plot_test {
namespace {

Scene two_stops() {
  Scene scene;
  scene.problem.contacts = {{.normal = {{0, 1.0}}, .gap = 0.5}, {.normal = {{1, 1.0}}, .gap = -1.25}};
  return scene;
}

// Two contacts, of which the second takes the larger impulse.
Waveforms motions() {
  const Waveform waveform{.t = {0.0, 1.0, 2.0},
                          .x = {{0.0, 0.5, 0.0}, {-2.0, -1.25, -2.0}},
                          .velocity = {{0.0, 1.0, 0.0}, {3.0, 4.0, 3.0}},
                          .force = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}},
                          .impulse = {{0.0, -1.0, -1.0}, {0.0, -2.0, -2.0}}};
  return {.contacts = {0, 1}, .answer = waveform, .orbit = waveform};
}

TEST(MotionPlot, ShowsTheContactWithMostImpulseItsStopAndItsImpacts) {
  Record record = test::full_record();
  record.certificate.events = {
      {.time = 1.0, .contact = 1, .kind = ContactEvent::Kind::impact, .value = -2.0},
      {.time = 0.5, .contact = 0, .kind = ContactEvent::Kind::impact, .value = -1.0}};
  const Figure figure = motion_plot(two_stops(), record, motions());
  EXPECT_NE(figure.data.find("\n1 -1.25 4 -2\n"), std::string::npos) << figure.data;
  EXPECT_NE(figure.data.find("\n1 -1.25\n\n\n"), std::string::npos);  // the impact, on its stop
  EXPECT_EQ(figure.data.find("0.5 -1.25"), std::string::npos);        // not the other contact's
  EXPECT_NE(figure.script.find("plot -1.25 with lines"), std::string::npos);
  EXPECT_NE(figure.script.find("set arrow from -1.25, graph 0"), std::string::npos);
}

TEST(MotionPlot, ShowsBothStopsOfAContactBetweenTwo) {
  Scene scene = two_stops();
  scene.problem.contacts[0] = {.normal = {{1, -1.0}}, .gap = 2.5};  // u[1] >= -2.5
  Record record = test::full_record();
  record.certificate.events = {
      {.time = 0.5, .contact = 0, .kind = ContactEvent::Kind::impact, .value = -1.0}};
  const Figure figure = motion_plot(scene, record, motions());
  for (const char* wall : {"plot -1.25 with lines", "-2.5 with lines", "set arrow from -2.5, graph 0"})
    EXPECT_NE(figure.script.find(wall), std::string::npos) << figure.script;
  EXPECT_NE(figure.data.find("\n0.5 -2.5\n"), std::string::npos) << figure.data;
}

TEST(MotionPlot, CanBeDrawnWithAndWithoutAnOrbit) {
  const test::TemporaryFolder folder;
  Waveforms alone = motions();
  alone.orbit.reset();
  EXPECT_NO_THROW(
      write_plot(folder.path() / "a.svg", motion_plot(two_stops(), test::full_record(), motions())));
  EXPECT_NO_THROW(write_plot(folder.path() / "b.svg", motion_plot(two_stops(), test::full_record(), alone)));
}

TEST(MotionPlot, StacksItsPanelsInASingleColumn) {
  const Figure figure = motion_plot(two_stops(), test::full_record(), motions(), Column::single);
  EXPECT_EQ(figure.width, kSingleColumn);
  EXPECT_NE(figure.script.find("layout 4,1"), std::string::npos);
  EXPECT_NO_THROW((void)drawn(figure, "svg"));
}

}  // namespace
}  // namespace signorini::motion_plot_test
