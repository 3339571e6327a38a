// Lies about exact orbits, told to the judge: gross ones about the motion, and such that have x right and the
// contact force wrong. None may be certified.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "harness/judge/certificate.hpp"
#include "harness/judge/exact_certificate.hpp"
#include "harness/judge/measures/contact_agreement.hpp"
#include "harness/judge/measures/contact_response.hpp"
#include "harness/judge/measures/measures.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/refinement.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini::judge_attack_test {
namespace {

/// A motion that is told: samples at any count by a formula, and what goes with them.
class ToldMotion final : public Trajectory {
 public:
  using Telling = std::function<Samples(int count)>;
  ToldMotion(double period, int contacts, Telling samples)
      : period_(period), contacts_(contacts), samples_(std::move(samples)) {}

  [[nodiscard]] int contact_count() const override { return contacts_; }
  [[nodiscard]] double period() const override { return period_; }
  [[nodiscard]] Samples sample(int count) const override { return samples_(count); }
  [[nodiscard]] std::vector<Impulse> impulses() const override { return told_impulses; }
  [[nodiscard]] std::optional<int> bandwidth() const override { return told_bandwidth; }
  [[nodiscard]] std::optional<std::vector<ContactEvent>> events() const override { return told_events; }

  std::vector<Impulse> told_impulses = {};
  std::optional<int> told_bandwidth = {};
  std::optional<std::vector<ContactEvent>> told_events = {};

 private:
  double period_;
  int contacts_;
  Telling samples_;
};

/// The exact orbit of a scene, and its problem.
struct Truth {
  std::string name = {};
  Problem problem = {};
  std::shared_ptr<const Trajectory> orbit = {};

  [[nodiscard]] bool has_impulses() const { return !orbit->impulses().empty(); }
  [[nodiscard]] bool has_contact() const { return has_impulses() || has_force(); }
  [[nodiscard]] bool has_force() const { return orbit->sample(1024).force.cwiseAbs().maxCoeff() > 0.0; }
};

Truth truth_of(const std::string& scene, std::optional<double> restitution = {}) {
  Truth truth{.name = scene, .problem = load_scene(find_scene(scene))};
  Problem asked = truth.problem;
  if (restitution) asked.set_law(Restitution{*restitution});
  truth.orbit = ExactOrbitMethod({}).prepare(asked)->solve({}).trajectory;
  return truth;
}

using Told = std::shared_ptr<ToldMotion>;

/// The orbit told with its samples changed by `edit`.
Told told(
    const Truth& truth, const std::function<void(Samples&)>& edit = [](Samples&) {}) {
  const std::shared_ptr<const Trajectory> orbit = truth.orbit;
  auto motion =
      std::make_shared<ToldMotion>(orbit->period(), orbit->contact_count(), [orbit, edit](int count) {
        Samples samples = orbit->sample(count);
        edit(samples);
        return samples;
      });
  motion->told_impulses = orbit->impulses();
  return motion;
}

/// Values that are `share` of a period later.
Eigen::MatrixXd later(const Eigen::MatrixXd& values, double share) {
  const auto rows = values.rows();
  const auto shift = static_cast<Eigen::Index>(std::lround(share * static_cast<double>(rows)));
  Eigen::MatrixXd result(rows, values.cols());
  for (Eigen::Index i = 0; i < rows; ++i) result.row((i + shift) % rows) = values.row(i);
  return result;
}

Told with_force(const Truth& truth, double factor) {
  Told motion = told(truth, [=](Samples& samples) { samples.force *= factor; });
  for (Impulse& impulse : motion->told_impulses) impulse.value *= factor;
  return motion;
}

Told with_late_force(const Truth& truth, double share) {
  Told motion = told(truth, [=](Samples& samples) { samples.force = later(samples.force, share); });
  for (Impulse& impulse : motion->told_impulses)
    impulse.time = std::fmod(impulse.time + share * motion->period(), motion->period());
  std::ranges::sort(motion->told_impulses, {}, &Impulse::time);
  return motion;
}

/// Of each impulse and of the force a part at its time, and another one later.
Told with_parts(const Truth& truth, double now, double then, double share) {
  Told motion = told(truth, [=](Samples& samples) {
    samples.force = now * samples.force + then * later(samples.force, share);
  });
  std::vector<Impulse>& impulses = motion->told_impulses;
  const std::vector<Impulse> own = impulses;
  for (Impulse& impulse : impulses) impulse.value *= now;
  for (Impulse impulse : own) {
    impulse.time = std::fmod(impulse.time + share * motion->period(), motion->period());
    impulse.value *= then;
    impulses.push_back(impulse);
  }
  std::ranges::sort(impulses, {}, &Impulse::time);
  return motion;
}

Told with_bandwidth(Told motion, int harmonics) {
  motion->told_bandwidth = harmonics;
  return motion;
}

Told with_chopped_force(const Truth& truth, int times) {
  return told(truth, [=](Samples& samples) {
    for (Eigen::Index i = 0; i < samples.force.rows(); ++i)
      samples.force.row(i) *= i * 2 * times / samples.force.rows() % 2 == 0 ? 2.0 : 0.0;
  });
}

Told with_mean_force(const Truth& truth) {
  const std::vector<Impulse> impulses = truth.orbit->impulses();
  const double period = truth.orbit->period();
  Told motion = told(truth, [=](Samples& samples) {
    Eigen::RowVectorXd mean = samples.force.colwise().mean();
    for (const Impulse& impulse : impulses) mean[impulse.contact] += impulse.value / period;
    samples.force.rowwise() = mean;
  });
  motion->told_impulses.clear();
  return motion;
}

std::vector<ContactEvent> impacts_of(const std::vector<Impulse>& impulses) {
  std::vector<ContactEvent> events;
  for (const Impulse& impulse : impulses)
    events.push_back({.contact = impulse.contact, .time = impulse.time, .impulse = impulse.value});
  return events;
}

/// The first forcing period of a longer one.
Told first_part(const Truth& truth) {
  const std::shared_ptr<const Trajectory> orbit = truth.orbit;
  const double period = truth.problem.forcing_period();
  const int order = static_cast<int>(std::lround(orbit->period() / period));
  auto motion = std::make_shared<ToldMotion>(period, orbit->contact_count(), [orbit, order](int count) {
    Samples samples = orbit->sample(count * order);
    samples.x.conservativeResize(count, Eigen::NoChange);
    samples.velocity.conservativeResize(count, Eigen::NoChange);
    samples.force.conservativeResize(count, Eigen::NoChange);
    return samples;
  });
  for (const Impulse& impulse : orbit->impulses()) {
    if (impulse.time < period) motion->told_impulses.push_back(impulse);
  }
  return motion;
}

struct Lie {
  std::string name;
  Told motion;
};

/// x right, the force wrong.
std::vector<Lie> lies_about_the_force(const Truth& truth) {
  std::vector<Lie> lies;
  for (const double factor : {0.51, 0.7, 1.4, 1.95})
    lies.push_back({"force times " + std::to_string(factor), with_force(truth, factor)});
  for (const double share : {0.04, 0.14, 0.5}) {
    lies.push_back({"late by " + std::to_string(share), with_late_force(truth, share)});
    lies.push_back({"late, one harmonic", with_bandwidth(with_late_force(truth, share), 1)});
  }
  lies.push_back({"split", with_bandwidth(with_parts(truth, 0.1, 0.9, 0.14), 1)});
  lies.push_back({"halves", with_parts(truth, 0.5, 0.5, 0.1)});
  for (const double share : {0.1, 0.24}) lies.push_back({"again", with_parts(truth, 1.0, share, 0.5)});
  lies.push_back({"again, one harmonic", with_bandwidth(with_parts(truth, 1.0, 0.24, 0.5), 1)});
  lies.push_back({"mean", with_mean_force(truth)});
  const Law scene_law = truth.problem.law();
  const auto* law = std::get_if<Restitution>(&scene_law);
  if (law != nullptr && law->e < 1.0 && truth.has_impulses())
    lies.push_back({"elastic", told(truth_of(truth.name, 1.0))});
  Told invented = with_parts(truth, 1.0, 0.24, 0.5);
  invented->told_events = impacts_of(invented->told_impulses);
  if (truth.has_impulses()) lies.push_back({"an event that did not happen", invented});
  for (const int times : {5, 12, 40}) {
    if (!truth.has_force() || truth.has_impulses()) continue;
    lies.push_back({"chopped", with_chopped_force(truth, times)});
    lies.push_back({"chopped, ten harmonics", with_bandwidth(with_chopped_force(truth, times), 10)});
  }
  return lies;
}

Told standing(const Truth& truth, double force) {
  Told motion = told(truth, [=](Samples& samples) {
    samples.x.rowwise() = samples.x.colwise().mean().eval();
    samples.velocity.setZero();
    samples.force.rowwise() = (force * samples.force.colwise().mean()).eval();
  });
  if (force == 0.0) motion->told_impulses.clear();
  return motion;
}

/// The response to the load alone, through the stops.
Told linear(const Truth& truth, double impulses) {
  const Problem problem = with_subharmonic(truth.problem, 1);
  const std::shared_ptr<const Trajectory> orbit = truth.orbit;
  auto motion =
      std::make_shared<ToldMotion>(orbit->period(), orbit->contact_count(), [problem, orbit](int count) {
        const int order = static_cast<int>(std::lround(orbit->period() / problem.forcing_period()));
        Samples samples = orbit->sample(count);
        const Eigen::MatrixXd free = contact_free_motion(problem, count / order).value();
        samples.x = free.replicate(order, 1);
        const double step = orbit->period() / count;
        samples.velocity =
            (later(samples.x, -1.0 / count + 1.0) - later(samples.x, 1.0 / count)) / (2.0 * step);
        samples.force.setZero();
        return samples;
      });
  for (Impulse impulse : orbit->impulses()) {
    impulse.value *= impulses;
    if (impulses > 0.0) motion->told_impulses.push_back(impulse);
  }
  return motion;
}

Told late(const Truth& truth, double share) {
  Told motion = with_late_force(truth, share);
  const Told force = motion;
  auto all =
      std::make_shared<ToldMotion>(motion->period(), motion->contact_count(), [force, share](int count) {
        Samples samples = force->sample(count);
        samples.x = later(samples.x, share);
        samples.velocity = later(samples.velocity, share);
        return samples;
      });
  all->told_impulses = motion->told_impulses;
  return all;
}

/// One contact stands still, whatever it does.
Told without_contact(const Truth& truth, int contact) {
  Told motion = told(truth, [=](Samples& samples) {
    samples.x.col(contact).setConstant(samples.x.col(contact).mean());
    samples.velocity.col(contact).setZero();
    samples.force.col(contact).setZero();
  });
  std::erase_if(motion->told_impulses, [&](const Impulse& impulse) { return impulse.contact == contact; });
  return motion;
}

std::vector<Lie> gross_lies(const Truth& truth) {
  std::vector<Lie> lies{{"stands", standing(truth, 0.0)}, {"rests", standing(truth, 1.0)}};
  if (contact_free_motion(with_subharmonic(truth.problem, 1), 16)) {
    lies.push_back({"linear", linear(truth, 0.0)});
    for (const double share : {1e-3, 0.7}) {
      if (truth.has_impulses()) lies.push_back({"linear, pushed", linear(truth, share)});
    }
  }
  const double periods = std::round(truth.orbit->period() / truth.problem.forcing_period());
  for (const double share : {0.1, 0.25, 0.5}) {
    // By whole periods of the load it is the truth.
    if (std::fmod(share * periods, 1.0) != 0.0) lies.push_back({"late", late(truth, share)});
  }
  const int contacts = truth.orbit->contact_count();
  for (int c = 0; contacts > 1 && c < contacts; ++c)
    lies.push_back({"contact " + std::to_string(c) + " stands", without_contact(truth, c)});
  if (truth.orbit->period() > 1.5 * truth.problem.forcing_period())
    lies.push_back({"half of it", first_part(truth)});
  return lies;
}

/// Whether the truth itself, as the orbit behind a lie, would certify it.
bool passes(const Truth& truth, const Told& lie) {
  const SampledAnswer answer = sample_answer(truth.problem, *lie);
  EXPECT_EQ(answer.defect, "") << truth.name;
  const Motion orbit = sample_motion(truth.problem, *truth.orbit);
  return distance(answer.motion, orbit).x_l2.value_or(1.0) <= kOwnOrbit &&
         contact_difference(truth.problem, answer.motion, orbit).text.empty();
}

/// Rigid stops, then others.
const std::string kResting = "sdof-preload-closed";
const std::vector<std::string> kScenes{"sdof-stop",          "sdof-stop-e08",     "sdof-stop-e05",
                                       "sdof-two-sided-e08", "sdof-subharmonic",  "sdof-preload-closed",
                                       "preload@-0.9",       "sdof-penalty-soft", "sdof-penalty-stiff",
                                       "chain3-massless",    "chain10-stops",     "bar10-massless"};

TEST(Judge, TakesTheTruth) {
  for (const std::string& scene : kScenes) {
    const Truth truth = truth_of(scene);
    EXPECT_TRUE(passes(truth, told(truth))) << scene;
  }
}

TEST(Judge, TakesNoLieAboutTheForce) {
  for (const std::string& scene : kScenes) {
    const Truth truth = truth_of(scene);
    for (const Lie& lie : lies_about_the_force(truth))
      EXPECT_FALSE(passes(truth, lie.motion)) << scene << ": " << lie.name;
  }
}

/// Of the searches at length: those whose orbits move, or the files of a folder SIGNORINI_ATTACKED_SCENES,
/// such as population.py writes.
std::vector<std::string> scenes_at_length() {
  std::vector<std::string> scenes = kScenes;
  std::erase(scenes, kResting);
  if (const char* folder = std::getenv("SIGNORINI_ATTACKED_SCENES")) {
    scenes.clear();
    for (const auto& file : std::filesystem::directory_iterator(folder)) scenes.push_back(file.path());
    std::ranges::sort(scenes);
  }
  return scenes;
}

TEST(Judge, TakesNoGrossLie) {
  for (const std::string& scene : kScenes) {
    if (scene == kResting) continue;
    const Truth truth = truth_of(scene);
    for (const Lie& lie : gross_lies(truth))
      EXPECT_FALSE(passes(truth, lie.motion)) << scene << ": " << lie.name;
  }
}

/// What becomes of lies that the harness searches the orbit of, as it does of any answer.
struct Count {
  int told = 0, certified = 0;
  int false_claims = 0, refuted = 0;  // farther than kNearOrbit from the truth, and those found wrong

  void add(const Truth& truth, const Lie& lie, const OrbitTools& tools) {
    constexpr double kSeconds = 20.0;
    const SampledAnswer answer = sample_answer(truth.problem, *lie.motion);
    const RepresentedLaw law =
        std::visit([](const auto& own) -> RepresentedLaw { return own; }, truth.problem.law());
    Record record;
    record.status = Status::converged;
    record.law = law;
    record.physics = measure_physics(truth.problem, law, answer.motion);
    record.certificate =
        certify(truth.problem, lie.motion, answer.motion, {}, tools, Deadline::after(kSeconds)).certificate;
    apply_verdict(record);
    const std::optional<Claim> claim = claim_of(record);
    ++told;
    certified += claim == Claim::certified ? 1 : 0;
    if (claim == Claim::certified)
      std::cout << truth.name << ": " << lie.name << ": certified, "
                << record.certificate.distance.value_or(0.0) << " away" << std::endl;
    const Motion orbit = sample_motion(truth.problem, *truth.orbit);
    if (!(distance(answer.motion, orbit).x_l2.value_or(1.0) > kNearOrbit)) return;
    ++false_claims;
    refuted += claim == Claim::refuted ? 1 : 0;
    if (claim != Claim::refuted)
      std::cout << truth.name << ": " << lie.name << ": " << record.certificate.reason << std::endl;
  }
};

Count tell(const std::function<std::vector<Lie>(const Truth&)>& lies) {
  const OrbitTools tools = orbit_tools();
  Count count;
  for (const std::string& scene : scenes_at_length()) {
    const Truth truth = truth_of(scene);
    if (!truth.orbit || !truth.has_contact()) continue;
    for (const Lie& lie : lies(truth)) count.add(truth, lie, tools);
  }
  std::cout << count.told << " lies, " << count.certified << " certified; " << count.false_claims
            << " far from the truth, " << count.refuted << " of them refuted\n";
  return count;
}

TEST(JudgeAtLength, CertifiesNoLieAboutTheForce) { EXPECT_EQ(tell(lies_about_the_force).certified, 0); }

TEST(JudgeAtLength, CertifiesNoGrossLieAndRefutesMost) {
  const Count count = tell(gross_lies);
  EXPECT_EQ(count.certified, 0);
  EXPECT_GE(count.refuted, 0.95 * count.false_claims);
  EXPECT_GE(count.false_claims, 50);
}

}  // namespace
}  // namespace signorini::judge_attack_test
