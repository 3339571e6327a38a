#include "tests/harness/fake_method.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <complex>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <system_error>
#include <vector>

namespace signorini::test {

namespace {

std::complex<double> amplitude_of(const Problem& problem) {
  const double w = problem.frequency;
  const std::complex<double> dynamic(problem.stiffness().coeff(0, 0) - w * w * problem.mass().coeff(0, 0),
                                     w * problem.damping().coeff(0, 0));
  return problem.force.front().cos / dynamic;
}

std::shared_ptr<const Trajectory> scaled_motion(const Problem& problem, double factor, double periods = 1.0,
                                                int contacts = 1) {
  const std::complex<double> a = factor * amplitude_of(problem);
  const double w = problem.frequency;
  return std::make_shared<FormulaMotion>(
      periods * 2.0 * std::numbers::pi / w, [a, w](double t) { return (a * std::polar(1.0, w * t)).real(); },
      [a, w](double t) { return (std::complex<double>(0.0, w) * a * std::polar(1.0, w * t)).real(); },
      [](double) { return 0.0; }, std::vector<Impulse>{}, 1, contacts);
}

// Recursion that no compiler can turn into a loop: every frame is read after the call.
__attribute__((noinline)) int devour_stack(int depth) {
  std::array<volatile char, 4096> frame{};
  frame[static_cast<std::size_t>(depth) % frame.size()] = static_cast<char>(depth);
  if (depth < 0) return 0;
  const int below = devour_stack(depth + 1);
  return below + frame[static_cast<std::size_t>(depth) % frame.size()];
}

[[noreturn]] void spin_forever() {
  for (volatile unsigned i = 0;;) i = i + 1;
}

void allocate_without_end() {
  constexpr std::size_t kBlock = 1U << 24U;
  std::vector<std::vector<char>> leak;
  for (;;) leak.emplace_back(kBlock, 'x');
}

void misbehave(Behaviour behaviour) {
  switch (behaviour) {
    case Behaviour::segfault:
      std::raise(SIGSEGV);
      break;
    case Behaviour::abort_now:
      std::abort();
    case Behaviour::exit_three:
      _exit(3);
    case Behaviour::throw_error:
      throw std::runtime_error("the matrix\nfell over");
    case Behaviour::throw_number:
      throw 42;
    case Behaviour::spin:
      spin_forever();
    case Behaviour::allocate:
      allocate_without_end();
      break;
    case Behaviour::ignore_sigterm:
      std::signal(SIGTERM, SIG_IGN);
      spin_forever();
    case Behaviour::overflow_stack:
      devour_stack(1);
      break;
    case Behaviour::orphan:
      if (fork() == 0) {
        std::signal(SIGTERM, SIG_IGN);
        for (;;) pause();
      }
      break;
    default:
      break;
  }
}

class PreparedFake final : public PreparedMethod {
 public:
  PreparedFake(const Problem& problem, Behaviour behaviour)
      : problem_(&problem), behaviour_(behaviour), set_up_for_(problem.frequency) {}

  Solution solve(const Start& start) override {
    misbehave(behaviour_);
    ++solves_;
    if (behaviour_ == Behaviour::crash_when_repeated && solves_ > 1) std::abort();
    if (behaviour_ == Behaviour::obey_deadline) {
      while (!start.expired()) {
      }
    }
    Solution solution{.verdict = Verdict::converged, .message = "done"};
    if (behaviour_ == Behaviour::carry_on) {
      if (problem_->frequency == kFatalFrequency) std::abort();
      solution.message = "set up for " + std::to_string(set_up_for_);
    }
    if (behaviour_ == Behaviour::give_up || behaviour_ == Behaviour::obey_deadline) {
      solution.verdict = Verdict::not_converged;
      solution.message = "gave up";
    }
    if (behaviour_ != Behaviour::no_trajectory) solution.trajectory = answer();
    if (behaviour_ == Behaviour::hand_back && start.guess) solution.trajectory = start.guess;
    solution.condition = 100.0;
    solution.work.iterations = 7;
    return solution;
  }

  bool take_frequency(const Problem& problem) override {
    if (behaviour_ != Behaviour::carry_on) return false;
    problem_ = &problem;
    return true;
  }

 private:
  [[nodiscard]] std::shared_ptr<const Trajectory> answer() const {
    switch (behaviour_) {
      case Behaviour::not_a_number:
        return scaled_motion(*problem_, std::nan(""));
      case Behaviour::lie:
        return scaled_motion(*problem_, 3.0);
      case Behaviour::wrong_size:
        return scaled_motion(*problem_, 1.0, 1.0, 2);
      case Behaviour::wrong_period:
        return scaled_motion(*problem_, 1.0, 1.5);
      case Behaviour::waver:
        return scaled_motion(*problem_, 1.0 + 1e-12 * solves_);
      default:
        return scaled_motion(*problem_, 1.0);
    }
  }

  const Problem* problem_;
  Behaviour behaviour_;
  double set_up_for_;
  int solves_ = 0;
};

SparseMatrix scalar(double value) {
  SparseMatrix matrix(1, 1);
  matrix.insert(0, 0) = value;
  matrix.makeCompressed();
  return matrix;
}

}  // namespace

Samples FormulaMotion::sample(int count) const {
  Samples samples{Eigen::MatrixXd(count, contacts_), Eigen::MatrixXd(count, contacts_),
                  Eigen::MatrixXd(count, contacts_)};
  if (contacts_ == 0) return samples;
  for (int i = 0; i < count; ++i) {
    const double t = i * period_ / count;
    samples.x.row(i).setConstant(x_(t));
    samples.velocity.row(i).setConstant(velocity_(t));
    samples.force.row(i).setConstant(force_(t));
  }
  return samples;
}

Support FakeMethod::supports(const Problem& problem) const {
  static_cast<void>(problem);
  if (options_.behaviour == Behaviour::crash_when_asked) std::abort();
  if (options_.behaviour == Behaviour::unsupported) return {.ok = false, .reason = "it is Tuesday"};
  return {};
}

RepresentedLaw FakeMethod::law(const Problem& problem) const {
  return std::visit([](const auto& law) -> RepresentedLaw { return law; }, problem.law());
}

std::unique_ptr<PreparedMethod> FakeMethod::prepare(const Problem& problem) const {
  if (options_.behaviour == Behaviour::singular) throw std::runtime_error("the structure is singular");
  return std::make_unique<PreparedFake>(problem, options_.behaviour);
}

Problem one_mass(double gap, double e) {
  Problem problem;
  problem.name = "one-mass";
  problem.kind = "sdof";
  problem.edit_structure([&](Structure& s) {
    s.mass = scalar(1.0);
    s.damping = scalar(0.1);
    s.stiffness = scalar(1.0);
  });
  problem.frequency = 2.0;
  problem.force = {{.dof = 0, .harmonic = 1, .cos = 1.0, .sin = 0.0}};
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = gap}};
  problem.set_law(Restitution{e});
  return problem;
}

Scene one_mass_scene(double gap, double e) { return {one_mass(gap, e), "0123abcd"}; }

std::shared_ptr<const Trajectory> free_motion(const Problem& problem) { return scaled_motion(problem, 1.0); }

OrbitSolver free_orbits() {
  return [](const Problem& problem, const PeriodicMotionOptions&, const Start&) {
    return Solution{
        .verdict = Verdict::converged, .message = {}, .trajectory = free_motion(problem), .residual = 1e-14};
  };
}

std::span<const MethodEntry> fake_catalogue() {
  static const std::array entries{method_entry<FakeMethod>()};
  return entries;
}

Case fake_case(const Scene& scene, const std::string& behaviour) {
  return make_case(scene, 0, {&fake_catalogue().front(), {{"behaviour", behaviour}}});
}

std::filesystem::path fresh_folder(const std::string& name) {
  // Removed when the test program ends; its forked children leave them alone.
  struct Folders {
    std::vector<std::filesystem::path> paths = {};
    pid_t owner = getpid();
    ~Folders() {
      if (getpid() != owner) return;
      std::error_code ignored;
      for (const auto& path : paths) std::filesystem::remove_all(path, ignored);
    }
  };
  static Folders folders;
  std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / ("signorini-" + name + "-" + std::to_string(getpid()));
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  folders.paths.push_back(folder);
  return folder;
}

}  // namespace signorini::test
