#pragma once
// Every method of the catalogue on every scene of the catalogue, at a cheap resolution.

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "methods/catalogue.hpp"
#include "methods/method.hpp"
#include "problems/problem.hpp"

namespace signorini::test {

/// One pair of the product; prints as `HatLcp_sdof_stop`.
struct MethodCase {
  std::string method;  ///< name in the catalogue of methods
  std::string scene;   ///< name in the catalogue of scenes

  [[nodiscard]] std::string name() const;
};

void PrintTo(const MethodCase& pair, std::ostream* out);

/// All pairs, methods in catalogue order, scenes sorted.
std::vector<MethodCase> all_cases();

/// Names for INSTANTIATE_TEST_SUITE_P.
struct CaseName {
  template <class Info>
  std::string operator()(const Info& info) const {
    return info.param.name();
  }
};

/// What the suite knows of a method beyond its interface.
struct MethodTraits {
  std::vector<OptionSetting> settings;  ///< cheap resolution
  int samples = 64;         ///< grid on which answers are compared: the method's own where it has one
  double agreement = 1e-8;  ///< of two answers to equivalent problems, relative to the largest x and force
  double identity = 1e-9;   ///< of one trajectory with itself at common instants, relative
};

/// Traits of a method; a method that the suite has not met yet runs at its defaults.
MethodTraits traits_of(const std::string& method);

Problem scene_of(const MethodCase& pair);
std::unique_ptr<Method> method_of(const MethodCase& pair);

/// One solve, with a deadline far beyond what any of these takes: a hang becomes a failure.
Solution solve(const Method& method, const Problem& problem,
               std::shared_ptr<const Trajectory> guess = nullptr);

/// The answer to the scene itself, computed once per pair and process.
const Solution& base_answer(const MethodCase& pair);

/// Largest |x - gap| and |x|, at least the smallest normal number: the scale of displacements [m].
double displacement_scale(const Problem& problem, const Samples& samples);

}  // namespace signorini::test
