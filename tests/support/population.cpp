#include "tests/support/population.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <random>
#include <utility>

#include "problems/assembly/beam.hpp"
#include "problems/assembly/chain.hpp"
#include "problems/assembly/damping.hpp"

namespace signorini::test {

namespace {

constexpr double kRestitutions[] = {0.0, 0.3, 0.5, 0.8, 1.0};

// Uniform numbers without the library's distributions, whose results vary between machines.
class Random {
 public:
  explicit Random(unsigned long seed) : engine_(seed) {}
  double uniform(double low, double high) {
    constexpr double kRange = 18446744073709551616.0;  // 2^64
    return low + (high - low) * (static_cast<double>(engine_()) / kRange);
  }
  int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned long>(count)); }

 private:
  std::mt19937_64 engine_;
};

// |u| of the contact-free response, Nd.
Eigen::VectorXd free_amplitudes(const Problem& problem) {
  const std::complex<double> iw(0.0, problem.frequency);
  const Eigen::MatrixXcd Z =
      Eigen::MatrixXcd((problem.stiffness() - problem.frequency * problem.frequency * problem.mass())
                           .cast<std::complex<double>>() +
                       (iw * problem.damping().cast<std::complex<double>>()));
  return Z.fullPivLu().solve(load_harmonic(problem, 1)).cwiseAbs();
}

// A structure of 1 to 4 masses, its load and its frequency.
Problem mixed_structure(Random& random, int masses) {
  Chain chain;
  for (int i = 0; i < masses; ++i) {
    chain.masses.push_back(masses == 1 ? 1.0 : random.uniform(0.5, 2.0));
    chain.springs.push_back(masses == 1 ? 1.0 : random.uniform(0.5, 2.0));
    chain.dampers.push_back(0.0);
  }
  Structure structure = assemble(chain);
  const double ratio = std::pow(10.0, random.uniform(-3.0, std::log10(0.2)));
  structure.damping = damping_matrix(ModalDamping{{ratio}}, structure.mass, structure.stiffness);
  Problem problem;
  problem.name = masses == 1 ? "random-mass" : "random-chain";
  problem.kind = "chain";
  problem.structure = std::make_shared<const Structure>(std::move(structure));
  problem.frequency = random.uniform(0.4, 3.0);
  problem.force = {{.dof = random.below(masses), .harmonic = 1, .cos = 1.0, .sin = 0.0}};
  return problem;
}

// One to three stops on distinct masses, one at most per mass. True if the contact-free motion reaches one.
bool add_stops(Random& random, Problem& problem) {
  const Eigen::VectorXd deflection =
      Eigen::MatrixXd(problem.stiffness()).ldlt().solve(load_harmonic(problem, 1).real()).cwiseAbs();
  const Eigen::VectorXd amplitude = free_amplitudes(problem);
  const int masses = problem.size(), stops = 1 + random.below(std::min(3, masses));
  const int first = random.below(masses);
  bool reached = false;
  for (int j = 0; j < stops; ++j) {
    const int dof = (first + j) % masses;
    const double facing = random.below(2) == 0 ? 1.0 : -1.0;
    const double gap = random.uniform(-0.5, 1.0) * deflection[dof];
    problem.contacts.push_back({.normal = {{dof, facing}}, .gap = gap});
    reached = reached || amplitude[dof] > gap;
  }
  return reached;
}

}  // namespace

std::vector<ImpactOscillator> hard_population(int count) {
  const double least = std::log10(2e-4);  // damping is twice the ratio where m = k = 1
  std::vector<ImpactOscillator> oscillators = contact_population(count, 20260105, least);
  for (std::size_t i = 0; i < oscillators.size(); ++i)
    oscillators[i].restitution = kRestitutions[i % std::size(kRestitutions)];
  return oscillators;
}

std::vector<Problem> restitution_population(int count, unsigned long seed) {
  std::vector<Problem> scenes;
  for (ImpactOscillator& oscillator : contact_population(count, seed)) {
    oscillator.restitution = kRestitutions[scenes.size() % std::size(kRestitutions)];
    scenes.push_back(to_problem(oscillator));
  }
  return scenes;
}

std::vector<Problem> chain_population(int count, unsigned long seed) {
  Random random(seed);
  std::vector<Problem> scenes;
  for (int scene = 0; scene < count; ++scene) {
    const int masses = 2 + random.below(4);
    Chain chain;
    const double damping = std::pow(10.0, random.uniform(-2.0, -0.5));
    for (int i = 0; i < masses; ++i) {
      chain.masses.push_back(random.uniform(0.5, 2.0));
      chain.springs.push_back(random.uniform(0.5, 2.0));
      chain.dampers.push_back(damping * chain.springs.back());
    }
    const Structure structure = assemble(chain);
    Problem problem;
    problem.name = "random-chain";
    problem.kind = "chain";
    problem.structure = std::make_shared<const Structure>(structure);
    problem.frequency = random.uniform(0.3, 2.5);
    problem.force = {{.dof = random.below(masses), .harmonic = 1, .cos = 1.0, .sin = 0.0}};
    const Eigen::VectorXd amplitude = free_amplitudes(problem);
    for (int j = 0; j < 1 + scene % 2; ++j) {
      const int dof = j == 0 ? masses - 1 : random.below(masses - 1);
      problem.contacts.push_back({.normal = {{dof, 1.0}}, .gap = random.uniform(-0.1, 0.9) * amplitude[dof]});
    }
    problem.set_law(Restitution{kRestitutions[static_cast<std::size_t>(scene) % std::size(kRestitutions)]});
    scenes.push_back(std::move(problem));
  }
  return scenes;
}

std::vector<Problem> mixed_population(int count, unsigned long seed) {
  Random random(seed);
  std::vector<Problem> scenes;
  while (static_cast<int>(scenes.size()) < count) {
    Problem problem = mixed_structure(random, scenes.size() % 2 == 0 ? 1 : 2 + random.below(3));
    if (!add_stops(random, problem)) continue;
    problem.set_law(Restitution{kRestitutions[scenes.size() / 2 % std::size(kRestitutions)]});
    scenes.push_back(std::move(problem));
  }
  return scenes;
}

std::vector<Problem> beam_population(int count, unsigned long seed) {
  constexpr int kElements = 20;
  constexpr int kOuterNodes = 15;
  constexpr double kFirstFrequency = 3.516;  // of a cantilever, in units of sqrt(E I / (rho A L^4))
  Random random(seed);
  std::vector<Problem> scenes;
  for (int scene = 0; scene < count; ++scene) {
    const Structure structure = assemble(Beam{.elements = kElements});
    const double ratio = std::pow(10.0, random.uniform(std::log10(0.005), std::log10(0.1)));
    Problem problem;
    problem.name = "random-beam";
    problem.kind = "beam";
    problem.edit_structure([&](Structure& s) {
      s.mass = structure.mass;
      s.damping = damping_matrix(ModalDamping{{ratio}}, structure.mass, structure.stiffness);
      s.stiffness = structure.stiffness;
    });
    problem.frequency = kFirstFrequency * random.uniform(0.4, 7.0);
    problem.force = {{.dof = 2 * kElements - 2, .harmonic = 1, .cos = 1.0, .sin = 0.0}};
    const Eigen::VectorXd amplitude = free_amplitudes(problem);
    std::vector<int> stopped;
    while (static_cast<int>(stopped.size()) < 1 + scene % 10) {
      const int dof = 2 * (kElements - 1 - random.below(kOuterNodes));
      if (std::find(stopped.begin(), stopped.end(), dof) != stopped.end()) continue;
      stopped.push_back(dof);
      problem.contacts.push_back({.normal = {{dof, 1.0}}, .gap = random.uniform(0.0, 0.8) * amplitude[dof]});
    }
    problem.set_law(Restitution{kRestitutions[static_cast<std::size_t>(scene) % std::size(kRestitutions)]});
    scenes.push_back(std::move(problem));
  }
  return scenes;
}

std::vector<ImpactOscillator> contact_population(int count, unsigned long seed, double least_damping) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    constexpr double kRange = 18446744073709551616.0;  // 2^64
    return low + (high - low) * (static_cast<double>(random()) / kRange);
  };
  std::vector<ImpactOscillator> population;
  while (static_cast<int>(population.size()) < count) {
    const double damping = std::pow(10.0, uniform(least_damping, -0.5));
    const double gap = uniform(-0.5, 1.0);
    const double frequency = uniform(0.4, 3.0);
    const double amplitude = 1.0 / std::hypot(1.0 - frequency * frequency, damping * frequency);
    if (amplitude > gap) population.push_back({.damping = damping, .frequency = frequency, .gap = gap});
  }
  return population;
}

}  // namespace signorini::test
