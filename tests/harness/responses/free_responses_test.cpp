// Free motions as responses: the exact curves of the suite `responses` against closed forms, and how methods
// stand against them.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "harness/responses/response_plan.hpp"
#include "harness/run/suite_run.hpp"
#include "harness/sweep/branch_response.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/stored_records.hpp"

namespace signorini::free_responses_test {
namespace {

constexpr double kPi = std::numbers::pi;

/// The zero of a function that falls between two ends.
double falling_zero(const std::function<double(double)>& f, double low, double high) {
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (f(middle) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// A free motion: its energy [J] and half of what its contact moves through [m].
struct FreeMotion {
  double energy = 0.0, amplitude = 0.0;
};

// m = 1, k = 10, a spring of 50 at .01: a part of an oscillation at w1 about 0, one of another at w2.
struct BilinearMass {
  double w1 = std::sqrt(10.0), w2 = std::sqrt(60.0), gap = 0.01;

  [[nodiscard]] double speed(double energy) const { return std::sqrt(2.0 * energy - 10.0 * gap * gap); }
  [[nodiscard]] double frequency(double energy) const {
    const double v = speed(energy), open = 2.0 * (kPi - std::atan2(v / w1, gap)) / w1;
    return 2.0 * kPi / (open + 2.0 * std::atan2(v / w2, gap * w1 * w1 / (w2 * w2)) / w2);
  }
  [[nodiscard]] FreeMotion at(double omega) const {
    const double energy =
        falling_zero([&](double e) { return omega - frequency(e); }, 0.5 * 10.0 * gap * gap, 1.0);
    const double rest = gap * (1.0 - w1 * w1 / (w2 * w2));  // about which it moves while held
    return {energy, 0.5 * (std::sqrt(2.0 * energy) / w1 + rest + std::hypot(gap - rest, speed(energy) / w2))};
  }
};

// Wall - m - m, m = k = 1: the modes with a spring on the first mass.
struct ChainModes {
  Eigen::Array2d rates;
  Eigen::Matrix2d shapes;

  explicit ChainModes(double spring) {
    Eigen::Matrix2d K;
    K << 2.0 + spring, -1.0, -1.0, 1.0;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(K);
    rates = solver.eigenvalues().array().sqrt();
    shapes = solver.eigenvectors();
  }
};

// Springs of 30 at +-1 before the first mass. Odd and even: from the turn to u = 0 it takes a quarter of the
// period, held for a time tau of it; place and velocity are continuous there, and u_1 = 1.
class ChainBetweenSprings {
 public:
  [[nodiscard]] FreeMotion at(double omega) const {
    constexpr double kShortest = 1e-5, kRatio = 1.02;  // of a quarter of the period; of the next one
    const double quarter = 0.5 * kPi / omega;
    const auto miss = [&](double tau) { return held_for(tau, quarter).miss; };
    for (double low = kShortest * quarter; low * kRatio < quarter; low *= kRatio) {  // the shortest contact
      const double high = kRatio * low;
      if (miss(low) > 0.0 && miss(high) <= 0.0)
        return held_for(falling_zero(miss, low, high), quarter).motion;
    }
    return {};
  }

 private:
  struct Held {
    double miss;
    FreeMotion motion;
  };
  [[nodiscard]] Held held_for(double tau, double quarter) const {
    const Eigen::Array2d left = open_.rates * (quarter - tau), passed = held_.rates * tau;
    const auto columns = [](const Eigen::Matrix2d& shapes, const Eigen::Array2d& factors) {
      return Eigen::Matrix2d(shapes * factors.matrix().asDiagonal());
    };
    Eigen::Matrix4d A;
    A << columns(open_.shapes, left.sin()), columns(held_.shapes, -passed.cos()),
        columns(open_.shapes, -open_.rates * left.cos()), columns(held_.shapes, held_.rates * passed.sin());
    const Eigen::Vector2d rest = Eigen::Vector2d::Constant(30.0 / 31.0);  // K u = (30, 0)
    const Eigen::Vector4d parts = A.partialPivLu().solve(Eigen::Vector4d(rest[0], rest[1], 0.0, 0.0));
    const Eigen::Array2d c = parts.head(2), d = parts.tail(2);
    const double u1 = open_.shapes.row(0).dot((left.sin() * c).matrix());
    return {u1 - 1.0,
            {0.5 * (open_.rates * c).square().sum(), rest[0] + held_.shapes.row(0).dot(d.matrix())}};
  }

  ChainModes open_{0.0}, held_{30.0};
};

// Rigid stops at +-1: J = 1 / S, S = sum phi_r^2 tan(w_r pi / (2 Omega)) / (2 w_r).
FreeMotion chain_between_rigid_stops(double omega) {
  const ChainModes modes(0.0);
  const Eigen::Array2d angles = modes.rates * (0.5 * kPi / omega);
  const Eigen::Array2d squares = modes.shapes.row(0).transpose().array().square();
  const double impulse = 1.0 / (squares * angles.tan() / (2.0 * modes.rates)).sum();
  EXPECT_GT(impulse, 0.0);
  return {impulse * impulse / 8.0 * (squares / angles.cos().square()).sum(), 1.0};
}

// The energies that others have: code_aster's V5.01.122 and 123, by other programs.
TEST(FreeResponses, HaveClosedFormsThatOthersConfirm) {
  EXPECT_NEAR(BilinearMass{}.frequency(0.00650108331626) / (2.0 * kPi), 0.6466310406, 1e-10);
  EXPECT_NEAR(ChainBetweenSprings{}.at(2.0 * kPi * 0.25790528513).energy, 1.820200676, 1e-9);
  EXPECT_NEAR(ChainBetweenSprings{}.at(2.0 * kPi * 0.25790528513).amplitude, 1.00458363, 1e-8);
}

std::map<std::string, Record> run_free_responses() {
  const Suite suite = load_suite("responses");
  const Plan plan = plan_of_suite(
      suite, {.methods = "exact-orbit:fourier-lipschitz[harmonics=10]:hat-lcp", .scenes = {"sdnd12*"}},
      method_catalogue(), shipped_scenes());
  Runner runner({.timeout = 20.0, .repetitions = 1, .reference_timeout = 20.0});
  RecordStore store(test::fresh_folder("free-responses"), false);
  static_cast<void>(run_plan(plan, runner, store));
  std::map<std::string, Record> records;
  for (Record& record : read_records(store.file())) {
    const std::string id = record.case_id;
    records[id] = std::move(record);
  }
  return records;
}

/// The exact response is one curve whose points are the motions of the closed form. Energies, which records
/// do not keep, are those of the same curve.
void expect_closed_form(const Record& truth, const std::function<FreeMotion(double)>& exact) {
  SCOPED_TRACE(truth.scene);
  ASSERT_EQ(truth.status, Status::converged) << truth.message;
  ASSERT_EQ(truth.response->branches.size(), 1U);
  EXPECT_TRUE(truth.response->open_ends.empty());
  const DrawnBranch& branch = truth.response->branches[0];
  const double touched = (1.0 + 1e-5) * branch.frequency.front();  // contact of no length begins
  EXPECT_GT(branch.frequency.size(), 2U);
  for (std::size_t i = 0; i < branch.frequency.size(); ++i) {
    if (branch.frequency[i] <= touched) continue;
    EXPECT_NEAR(branch.amplitude[i], exact(branch.frequency[i]).amplitude, 1e-10) << branch.frequency[i];
  }
  const Scene scene = read_scene(problems_folder() / "published" / "code-aster" / (truth.scene + ".toml"));
  const ResponseQuestion& question = truth.response->question;
  const auto diagram = branches_of(over_frequency(scene.problem, question.from, question.to),
                                   {.entry = &exact_method()}, {.at = branch.frequency});
  int compared = 0;
  for (const SolutionPoint& point : diagram.value().branches.at(0).points) {
    if (point.frequency <= touched) continue;
    EXPECT_NEAR(point.energy.value(), exact(point.frequency).energy, 1e-10) << point.frequency;
    ++compared;
  }
  EXPECT_GT(compared, 20);
}

TEST(FreeResponses, AreMeasuredAgainstTheExactModes) {
  std::map<std::string, Record> records = run_free_responses();
  const BilinearMass mass;
  const ChainBetweenSprings chain;
  expect_closed_form(records["sdnd122/exact response"], [&](double omega) { return mass.at(omega); });
  expect_closed_form(records["sdnd123/exact response"], [&](double omega) { return chain.at(omega); });
  expect_closed_form(records["sdnd123-rigid/exact response"], chain_between_rigid_stops);
  int found = 0, refused = 0;
  for (const auto& [id, record] : records) {
    if (record.response && record.response->question.way == ResponseWay::exact) continue;
    if (record.status == Status::not_applicable) {
      EXPECT_NE(record.message.find("without a periodic load"), std::string::npos) << id << record.message;
      ++refused;
      continue;
    }
    ASSERT_TRUE(record.response && record.response->comparison) << id << record.message;
    EXPECT_GT(record.response->comparison->close.covered, 0.999) << id;
    EXPECT_LT(record.response->comparison->wide.false_share, 1e-3) << id;
    EXPECT_TRUE(record.response->comparison->invented.empty()) << id;
    ++found;
  }
  EXPECT_EQ(found, 3) << "exact-orbit by arc length";
  EXPECT_EQ(refused, 9) << "exact-orbit by steps, the curves of two methods";
}

}  // namespace
}  // namespace signorini::free_responses_test
