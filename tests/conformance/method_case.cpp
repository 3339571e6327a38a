#include "tests/conformance/method_case.hpp"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <limits>
#include <map>
#include <ostream>

#include "problems/scene_file.hpp"

namespace signorini::test {

std::string MethodCase::name() const {
  std::string text;
  bool capital = true;
  for (const char letter : method) {
    if (letter == '-') {
      capital = true;
      continue;
    }
    text += capital ? static_cast<char>(std::toupper(static_cast<unsigned char>(letter))) : letter;
    capital = false;
  }
  text += '_';
  for (const char letter : scene) text += letter == '-' ? '_' : letter;
  return text;
}

void PrintTo(const MethodCase& pair, std::ostream* out) { *out << pair.name(); }

// Structures are left out: their solves take seconds, and every pair is solved many times.
std::vector<MethodCase> all_cases() {
  std::vector<MethodCase> pairs;
  for (const MethodEntry& entry : method_catalogue()) {
    for (const auto& path : catalogue_scenes()) {
      if (!load_header(path).carries("structure"))
        pairs.push_back({std::string(entry.name), path.stem().string()});
    }
  }
  return pairs;
}

MethodTraits traits_of(const std::string& method) {
  const std::vector<OptionSetting> fourier{{"harmonics", "8"}, {"samples", "128"}};
  if (method == "hat-lcp") return {.settings = {{"samples", "64"}}, .samples = 64};
  if (method == "fourier-lipschitz" || method == "penalty-hbm") return {.settings = fourier, .samples = 128};
  if (method == "aft-hbm") {
    // A path of its homotopy that wanders costs a linear solve per switch: cut short.
    return {.settings = {fourier[0], fourier[1], {"max_iterations", "1500"}}, .samples = 128};
  }
  if (method == "event-driven") {
    // Equivalent problems are integrated with different steps: they agree to the tolerance of the
    // integration, amplified by the slowest decay of the scenes (1 / (1 - 0.96) periods).
    return {.settings = {{"tolerance", "1e-7"}}, .samples = 64, .agreement = 2e-4, .identity = 1e-9};
  }
  return {.settings = {}};
}

Problem scene_of(const MethodCase& pair) { return load_scene(find_scene(pair.scene)); }

std::unique_ptr<Method> method_of(const MethodCase& pair) {
  return find_method(pair.method).make(traits_of(pair.method).settings);
}

Solution solve(const Method& method, const Problem& problem, std::shared_ptr<const Trajectory> guess) {
  Start start{.guess = std::move(guess)};
  start.deadline = std::chrono::steady_clock::now() + std::chrono::minutes(5);
  return method.prepare(problem)->solve(start);
}

const Solution& base_answer(const MethodCase& pair) {
  static std::map<std::string, Solution> answers;
  const auto found = answers.find(pair.name());
  if (found != answers.end()) return found->second;
  return answers.emplace(pair.name(), solve(*method_of(pair), scene_of(pair))).first->second;
}

double displacement_scale(const Problem& problem, const Samples& samples) {
  double scale = std::numeric_limits<double>::min();
  if (samples.x.size() > 0) scale = std::max(scale, samples.x.cwiseAbs().maxCoeff());
  for (const Contact& contact : problem.contacts) scale = std::max(scale, std::abs(contact.gap));
  return scale;
}

}  // namespace signorini::test
