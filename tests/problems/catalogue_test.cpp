// The shipped scenes: each loads, and together they cover what the benchmark claims to cover.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <set>
#include <sstream>

#include "problems/matrix_properties.hpp"
#include "problems/scene/scene_layout.hpp"
#include "problems/skew_parts.hpp"
#include "problems/validation.hpp"

namespace signorini::catalogue_test {
namespace {

// All but the large ones.
std::vector<Problem> load_catalogue() {
  std::vector<Problem> scenes;
  for (const auto& path : shipped_files("catalogue")) {
    if (!load_header(path).carries(kLarge)) scenes.push_back(load_scene(path));
  }
  return scenes;
}

const std::vector<Problem>& catalogue() {
  static const std::vector<Problem> scenes = load_catalogue();
  return scenes;
}

long count(const std::function<bool(const Problem&)>& holds) {
  return std::count_if(catalogue().begin(), catalogue().end(), holds);
}

bool has_tag(const Problem& scene, std::string_view tag) {
  return std::find(scene.tags.begin(), scene.tags.end(), tag) != scene.tags.end();
}

bool has_restitution(const Problem& scene, double e) {
  const Law scene_law = scene.law();
  const auto* law = std::get_if<Restitution>(&scene_law);
  return law != nullptr && law->e == e;
}

double damping_ratio(const Problem& sdof) {
  return sdof.damping().coeff(0, 0) /
         (2.0 * std::sqrt(sdof.mass().coeff(0, 0) * sdof.stiffness().coeff(0, 0)));
}

// omega over the natural frequency
double frequency_ratio(const Problem& sdof) {
  return sdof.frequency / std::sqrt(sdof.stiffness().coeff(0, 0) / sdof.mass().coeff(0, 0));
}

// Reading a scene of finite elements takes its matrices for semi-definite: they are.
TEST(Catalogue, PassesTheWholeCheck) {
  for (const Problem& scene : catalogue()) EXPECT_NO_THROW(validate(scene)) << scene.name;
}

TEST(Catalogue, NamesAreFileNames) {
  ASSERT_GE(catalogue().size(), 16U);
  for (const auto& path : shipped_files("catalogue")) {
    const std::string name = load_header(path).name;
    EXPECT_EQ(name, path.stem().string());
    EXPECT_EQ(find_scene(name), path);
  }
}

TEST(Catalogue, EverySceneIsDescribed) {
  std::set<std::string> titles;
  for (const auto& path : shipped_files("catalogue")) {
    const SceneHeader scene = load_header(path);
    EXPECT_TRUE(titles.insert(scene.title).second) << scene.name << ": " << scene.title;
    EXPECT_FALSE(scene.title.empty()) << scene.name;
    EXPECT_FALSE(scene.reference.empty()) << scene.name;
    const std::set<std::string> tags(scene.tags.begin(), scene.tags.end());
    EXPECT_EQ(tags.size(), scene.tags.size()) << scene.name;
  }
  for (const Problem& scene : catalogue()) {
    EXPECT_FALSE(scene.force.empty()) << scene.name;
    EXPECT_TRUE(has_tag(scene, scene.kind)) << scene.name;
  }
}

// Each with an instance that is a scene, and in the suite that its name begins with.
TEST(Populations, OfferInstances) {
  const std::vector<std::filesystem::path> files = shipped_files("populations");
  ASSERT_GE(files.size(), 6U);
  for (const auto& path : files) {
    EXPECT_TRUE(offers_instances(path)) << path;
    const Problem scene = load_scene({path, "11-2"});
    EXPECT_EQ(scene.name, path.stem().string() + "@11-2");
    EXPECT_EQ(find_scene(scene.name), SceneSource(path, "11-2"));
    EXPECT_TRUE(has_tag(scene, "population")) << scene.name;
  }
}

TEST(LoadHeader, ReadsWhatTheSceneSaysOfItself) {
  const SceneSource path = find_scene("chain2-penalty");
  const SceneHeader header = load_header(path);
  const Problem scene = load_scene(path);
  EXPECT_EQ(header.name, scene.name);
  EXPECT_EQ(header.title, scene.title);
  EXPECT_EQ(header.reference, scene.reference);
  EXPECT_EQ(header.tags, scene.tags);
  EXPECT_TRUE(header.carries("penalty"));
  EXPECT_FALSE(header.carries("pen"));
}

TEST(Catalogue, TagsSayWhatTheSceneIs) {
  for (const Problem& scene : catalogue()) {
    SCOPED_TRACE(scene.name);
    EXPECT_EQ(has_tag(scene, "contact-free"), scene.contacts.empty());
    EXPECT_EQ(has_tag(scene, "single-point"), scene.contacts.size() == 1);
    EXPECT_EQ(has_tag(scene, "two-sided"), scene.contacts.size() == 2);
    EXPECT_EQ(has_tag(scene, "multi-point"), scene.contacts.size() > 2);
    EXPECT_TRUE(scene.size() <= 1000 && scene.contacts.size() <= 30) << "or tag it large";
    EXPECT_EQ(has_tag(scene, "penalty"), std::holds_alternative<Penalty>(scene.law()));
    EXPECT_EQ(has_tag(scene, "massless"), std::holds_alternative<Massless>(scene.law()));
    EXPECT_EQ(has_tag(scene, "mixed-laws"), std::holds_alternative<MixedLaws>(scene.law()));
    EXPECT_EQ(has_tag(scene, "subharmonic"), scene.subharmonic > 1);
    const auto any_gap = [&](auto holds) {
      return std::any_of(scene.contacts.begin(), scene.contacts.end(),
                         [&](const Contact& c) { return holds(c.gap); });
    };
    EXPECT_EQ(has_tag(scene, "preload"), any_gap([](double gap) { return gap < 0.0; }));
    EXPECT_EQ(has_tag(scene, "zero-gap"), any_gap([](double gap) { return gap == 0.0; }));
    if (has_tag(scene, "sticking")) {
      EXPECT_LT(std::get<Restitution>(scene.law()).e, 1.0) << "an elastic stop lets go";
    }
    EXPECT_EQ(has_tag(scene, "damped-stop"), !load_outline(find_scene(scene.name)).damped_stops.empty());
    EXPECT_EQ(has_tag(scene, "clearance"), !is_definite(symmetric_part(scene.stiffness())));
    if (scene.kind == "sdof" && scene.size() == 1 &&
        !has_tag(scene, "clearance")) {  // without the face of a damped stop
      EXPECT_EQ(has_tag(scene, "light-damping"), damping_ratio(scene) <= 0.01 + 1e-12);
      EXPECT_EQ(has_tag(scene, "near-resonance"), std::abs(frequency_ratio(scene) - 1.0) <= 0.1 + 1e-12);
      EXPECT_EQ(has_tag(scene, "below-resonance"), frequency_ratio(scene) < 0.9 - 1e-12);
      EXPECT_EQ(has_tag(scene, "above-resonance"), frequency_ratio(scene) > 1.1 + 1e-12);
    }
  }
}

TEST(Catalogue, CoversLawsAndRestitutions) {
  for (const double e : {1.0, 0.8, 0.5, 0.0}) {
    EXPECT_GE(count([=](const Problem& scene) { return has_restitution(scene, e); }), 2)
        << "restitution " << e;
  }
  EXPECT_GE(
      count([](const Problem& scene) { return has_restitution(scene, 1.0) && has_tag(scene, "impact"); }), 8)
      << "the only law that the Fourier methods represent";
  EXPECT_GE(count([](const Problem& scene) { return has_tag(scene, "penalty"); }), 2);
  EXPECT_GE(count([](const Problem& scene) { return has_tag(scene, "massless"); }), 1);
  EXPECT_GE(count([](const Problem& scene) { return has_tag(scene, "mixed-laws"); }), 1);
  EXPECT_GE(count([](const Problem& scene) { return has_tag(scene, "contact-free"); }), 1);
  EXPECT_GE(count([](const Problem& scene) { return has_tag(scene, "open"); }), 1);
}

TEST(Catalogue, CoversGapsStopsAndMotions) {
  EXPECT_GE(
      count([](const Problem& scene) { return !scene.contacts.empty() && scene.contacts[0].gap > 0.0; }), 8);
  EXPECT_GE(count([](const Problem& scene) { return has_tag(scene, "zero-gap"); }), 2);
  EXPECT_GE(count([](const Problem& scene) { return has_tag(scene, "preload"); }), 3);
  EXPECT_GE(count([](const Problem& scene) { return has_tag(scene, "permanent-contact"); }), 1);
  EXPECT_GE(count([](const Problem& scene) { return has_tag(scene, "sticking"); }), 3);
  EXPECT_GE(count([](const Problem& scene) { return has_tag(scene, "subharmonic"); }), 1);
  EXPECT_GE(count([](const Problem& scene) { return has_tag(scene, "two-sided"); }), 2);
}

TEST(Catalogue, CoversPenaltiesSoftAndStiff) {
  std::set<double> ratios;
  for (const Problem& scene : catalogue()) {
    if (const Law law_of_all = scene.law(); const auto* law = std::get_if<Penalty>(&law_of_all)) {
      ratios.insert(law->stiffness[0] / contact_stiffness_scale(scene)(0));
    }
  }
  ASSERT_FALSE(ratios.empty());
  EXPECT_LE(*ratios.begin(), 100.0);
  EXPECT_GE(*ratios.rbegin(), 1e4);
}

TEST(Catalogue, CoversDampingAndResonance) {
  double least = INFINITY;
  double most = 0.0;
  for (const Problem& scene : catalogue()) {
    if (scene.kind != "sdof" || !has_tag(scene, "impact") || has_tag(scene, "clearance")) continue;
    least = std::min(least, damping_ratio(scene));
    most = std::max(most, damping_ratio(scene));
  }
  EXPECT_LE(least, 0.0015 * (1.0 + 1e-12));
  EXPECT_GE(most, 0.15 * (1.0 - 1e-12));
  for (const char* tag : {"below-resonance", "near-resonance", "above-resonance"}) {
    EXPECT_GE(count([=](const Problem& scene) { return has_tag(scene, tag) && has_restitution(scene, 1.0); }),
              1)
        << tag;
  }
}

TEST(Catalogue, CoversChainsWithOneContact) {
  for (const int size : {2, 3, 10}) {
    const auto fits = [=](const Problem& scene) {
      return scene.kind == "chain" && scene.size() == size && scene.contact_count() == 1;
    };
    EXPECT_GE(count([&](const Problem& scene) { return fits(scene) && has_restitution(scene, 1.0); }), 1)
        << size;
  }
  EXPECT_GE(count([](const Problem& scene) {
              const Law scene_law = scene.law();
              const auto* law = std::get_if<Restitution>(&scene_law);
              return scene.kind == "chain" && law != nullptr && law->e < 1.0;
            }),
            1);
}

TEST(Catalogue, CoversFiniteElementsWithAMasslessContact) {
  const auto massless_bar = [](const Problem& scene) {
    return scene.kind == "bar" && std::ranges::none_of(contacts_with_mass(scene), std::identity());
  };
  EXPECT_GT(count(massless_bar), 0);
}

TEST(Catalogue, CoversStructuresWithManyContacts) {
  for (const char* kind : {"chain", "beam", "rotor", "shaft"}) {
    EXPECT_GE(
        count([&](const Problem& scene) { return scene.kind == kind && has_tag(scene, "multi-point"); }), 1)
        << kind;
  }
  EXPECT_GE(count([](const Problem& scene) { return scene.kind == "matrices"; }), 1);
  int large_blocks = 0;
  for (const auto& path : shipped_files("catalogue")) {
    const SceneHeader scene = load_header(path);
    if (scene.carries(kLarge)) {
      EXPECT_TRUE(scene.carries("structure")) << scene.name << ": of use in no suite otherwise";
    }
    if (scene.carries(kLarge) && scene.carries("block")) ++large_blocks;
  }
  EXPECT_GE(large_blocks, 2);
}

TEST(Catalogue, FarStopIsNeverReachedAndClosedStopNeverLeft) {
  const Problem far = load_scene(find_scene("sdof-far-stop"));
  const double w = far.frequency;
  const std::complex<double> Z(far.stiffness().coeff(0, 0) - w * w * far.mass().coeff(0, 0),
                               w * far.damping().coeff(0, 0));
  EXPECT_LT(std::abs(load_harmonic(far, 1)(0) / Z), far.contacts[0].gap);

  const Problem closed = load_scene(find_scene("sdof-preload-closed"));
  for (int i = 0; i < 100; ++i) {
    const double force = closed.stiffness().coeff(0, 0) * closed.contacts[0].gap -
                         load_at(closed, i * closed.period() / 100.0)(0);
    EXPECT_LT(force, 0.0) << "the stop pushes at all times";
  }
}

std::string manual() {
  std::ifstream stream(problems_folder().parent_path() / "docs" / "scene-format.md");
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// The scenes of the manual, each a fenced block.
std::vector<std::string> documented_scenes() {
  std::istringstream stream(manual());
  std::vector<std::string> scenes;
  bool inside = false;
  for (std::string line; std::getline(stream, line);) {
    if (line == "```toml") {
      inside = true;
      scenes.emplace_back();
    } else if (line == "```") {
      inside = false;
    } else if (inside) {
      scenes.back() += line + '\n';
    }
  }
  return scenes;
}

TEST(SceneFormatManual, ExamplesLoad) {
  const std::vector<std::string> scenes = documented_scenes();
  ASSERT_EQ(scenes.size(), 3U);

  const Problem oscillator = parse_scene(scenes[0], "docs/scene-format.md");
  EXPECT_EQ(oscillator.name, "my-oscillator");
  EXPECT_EQ(oscillator.kind, "sdof");
  EXPECT_TRUE(has_restitution(oscillator, 0.8));

  const Problem chain = parse_scene(scenes[1], "docs/scene-format.md");
  EXPECT_EQ(chain.size(), 3);
  EXPECT_EQ(chain.contact_count(), 2);
  EXPECT_EQ(std::get<Penalty>(chain.law()).stiffness.size(), 2U);

  const Problem level = parse_scene(scenes[0] + scenes[2], "docs/scene-format.md", "1e-4");
  EXPECT_EQ(level.name, "my-oscillator@1e-4");
  EXPECT_DOUBLE_EQ(level.contacts.at(0).gap, 0.9999);
}

TEST(SceneFormatManual, ShowsTheErrorAsItIs) {
  std::string scene = documented_scenes().at(0);
  const std::string_view sound = "damping = 0.1";
  scene.replace(scene.find(sound), sound.size(), "damping = -0.1");
  try {
    parse_scene(scene, "my-oscillator.toml");
    FAIL() << "accepted";
  } catch (const SceneError& error) {
    EXPECT_NE(manual().find(std::string("    ") + error.what() + "\n"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace signorini::catalogue_test
