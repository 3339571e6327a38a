#include "harness/orbits/orbit_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "harness/failure.hpp"
#include "tests/harness/orbits/sample_orbits.hpp"

namespace signorini::orbit_file_test {
namespace {

using test::sample_file;
using test::sample_orbit;

TEST(OrbitFiles, ComeBackAsTheyWereWritten) {
  const std::string text = print_orbit_file(sample_file());
  const OrbitFile back = parse_orbit_file(text, "file");
  EXPECT_EQ(print_orbit_file(back), text);
  EXPECT_TRUE(compare_orbits(sample_file(), back).differences.empty());
}

TEST(OrbitFiles, AreRefusedWithTheirNameInOneLine) {
  for (const std::string& text : {std::string("{"), std::string("[]"), std::string("{\"schema\": 7}"),
                                  std::string("{\"schema\": 1, \"scene\": 3}")}) {
    try {
      parse_orbit_file(text, "some.json");
      ADD_FAILURE() << text;
    } catch (const UsageError& error) {
      const std::string line = error.what();
      EXPECT_EQ(line.rfind("some.json: ", 0), 0U) << line;
      EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    }
  }
}

TEST(OrbitJson, CountsEventsAndLeavesOutWhatIsNotKnown) {
  FoundOrbit orbit = sample_orbit();
  nlohmann::ordered_json json = to_json(orbit);
  EXPECT_EQ(json.at("impacts"), 1);
  EXPECT_EQ(json.at("contact_phases"), 1);
  EXPECT_EQ(json.at("found_by").size(), 1U);
  EXPECT_EQ(json.at("events").at(0).at("value"), -1.0);
  EXPECT_FALSE(json.at("events").at(1).contains("value"));
  orbit.certified.floquet.reset();
  orbit.certified.stable.reset();
  json = to_json(orbit);
  EXPECT_FALSE(json.contains("floquet"));
  EXPECT_FALSE(json.contains("stable"));
}

TEST(FoundOrbit, KnowsItsLargestMultiplier) {
  FoundOrbit orbit = sample_orbit();
  EXPECT_DOUBLE_EQ(orbit.largest_multiplier().value(), std::hypot(0.5, 0.25));
  orbit.certified.floquet->clear();
  EXPECT_FALSE(orbit.largest_multiplier().has_value());
}

}  // namespace
}  // namespace signorini::orbit_file_test
