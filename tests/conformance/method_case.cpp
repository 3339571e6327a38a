#include "tests/conformance/method_case.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <ostream>

#include "problems/scene/scene_file.hpp"

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

// Structures are left out: their solves take seconds, and every pair is solved many times. So are loose
// parts, of which some methods find motions without contact, one of a family each.
std::vector<MethodCase> all_cases() {
  std::vector<MethodCase> pairs;
  for (const MethodEntry& entry : method_catalogue()) {
    for (const auto& path : shipped_files("catalogue")) {
      const SceneHeader header = load_header(path);
      if (!header.carries("structure") && !header.carries("clearance"))
        pairs.push_back({std::string(entry.name), path.stem().string()});
    }
  }
  return pairs;
}

CheckSettings check_settings(const std::string& method) {
  // A hang becomes a failure; nothing here takes as long.
  constexpr double kTimeout = 300.0, kPatience = 60.0;
  const auto settings = [](std::vector<OptionSetting> resolution, int grid) {
    return CheckSettings{
        .resolution = std::move(resolution), .grid = grid, .timeout = kTimeout, .patience = kPatience};
  };
  const std::vector<OptionSetting> fourier{{"harmonics", "8"}, {"samples", "128"}};
  if (method == "hat-lcp") return settings({{"samples", "64"}}, 64);
  if (method == "fourier-lipschitz" || method == "penalty-hbm") return settings(fourier, 128);
  if (method == "aft-hbm") {
    // Each switch on the path of its homotopy costs a linear solve: long paths are cut short.
    return settings({fourier[0], fourier[1], {"max_iterations", "1500"}}, 128);
  }
  if (method == "exact-orbit") return settings({}, 64);
  if (method == "event-driven") {
    // Equivalent problems are integrated with different steps: they agree to the tolerance of the
    // integration, amplified by the slowest decay of the scenes (1 / (1 - 0.96) periods).
    CheckSettings integrated = settings({{"tolerance", "1e-7"}}, 64);
    integrated.agreement = 2e-4;
    return integrated;
  }
  CheckSettings declared = check_settings_of(find_method(method));
  declared.timeout = kTimeout;
  declared.patience = kPatience;
  return declared;
}

const CheckedMethod& checked_method(const MethodCase& pair) {
  static std::map<std::string, CheckedMethod> made;
  const auto found = made.find(pair.name());
  if (found != made.end()) return found->second;
  return made
      .try_emplace(pair.name(), find_method(pair.method), load_scene(find_scene(pair.scene)),
                   check_settings(pair.method))
      .first->second;
}

}  // namespace signorini::test
