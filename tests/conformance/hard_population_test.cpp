// Two thousand oscillators with a stop, damped down to a ratio of 1e-4: how often the defaults converge from
// a cold start, and whether the harness ever disagrees with a method that says so.

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "harness/judge/certificate.hpp"
#include "harness/judge/exact_certificate.hpp"
#include "harness/run/trial.hpp"
#include "tests/support/population.hpp"

namespace signorini {
namespace {

constexpr int kScenes = 2000;

struct Tally {
  int scenes = 0;
  int converged = 0;
  int refuted = 0;  // the method says converged, the harness disagrees
  int certified = 0;
};

Record run(const MethodEntry& entry, const test::ImpactOscillator& oscillator) {
  const Scene scene{.problem = test::to_problem(oscillator)};
  const Case planned_case = make_case(scene, 0, {.entry = &entry});
  const Limits limits{.timeout = 20.0, .certificate_timeout = 20.0};
  const Reference none{.reason = "not asked for"};
  const OrbitTools orbits = orbit_tools();
  const RepresentedLaw law = entry.make({})->law(scene.problem);
  const Trial trial{.scene = scene,
                    .planned_case = planned_case,
                    .limits = limits,
                    .law = law,
                    .reference = none,
                    .scene_reference = none,
                    .orbits = orbits,
                    .timed = false};
  Record record;
  record.law = law;
  run_trial(trial, record, [&](const Record& so_far) { record = so_far; });
  apply_verdict(record);
  return record;
}

Tally tally(const char* method, bool conservative_only) {
  const MethodEntry& entry = find_method(method);
  Tally count;
  for (const test::ImpactOscillator& o : test::hard_population(kScenes)) {
    if (conservative_only && o.restitution != 1.0) continue;
    const Record record = run(entry, o);
    ++count.scenes;
    count.converged += record.status == Status::converged ? 1 : 0;
    count.refuted += record.status == Status::inaccurate ? 1 : 0;
    count.certified += record.certificate.status == CertificateStatus::certified ? 1 : 0;
    if (record.status == Status::converged) continue;
    std::printf("  %s d = %.6g, g = %.6g, w = %.6g, e = %g: %s, %s\n", method, o.damping, o.gap, o.frequency,
                o.restitution, std::string(status_name(record.status)).c_str(), record.message.c_str());
  }
  std::printf("%-18s %4d of %4d converged, %d refuted, %d certified\n", method, count.converged, count.scenes,
              count.refuted, count.certified);
  return count;
}

void expect_rate(const Tally& count, double least) {
  EXPECT_GE(count.converged, least * count.scenes);
  EXPECT_EQ(count.refuted, 0);
}

TEST(HardPopulation, ExactOrbitConvergesAndIsNeverRefuted) {
  expect_rate(tally("exact-orbit", false), 0.995);
}
TEST(HardPopulation, HatLcpConvergesAndIsNeverRefuted) { expect_rate(tally("hat-lcp", false), 0.995); }
TEST(HardPopulation, FourierLipschitzConvergesOnConservativeStopsAndIsNeverRefuted) {
  expect_rate(tally("fourier-lipschitz", true), 0.98);
}
TEST(HardPopulation, PenaltyHbmConvergesOnConservativeStopsAndIsNeverRefuted) {
  expect_rate(tally("penalty-hbm", true), 0.98);
}
TEST(HardPopulation, AftHbmConvergesOnConservativeStopsAndIsNeverRefuted) {
  expect_rate(tally("aft-hbm", true), 0.98);
}

}  // namespace
}  // namespace signorini
