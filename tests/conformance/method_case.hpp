#pragma once
// Every method of the catalogue on every scene of the catalogue, at a cheap resolution.

#include <iosfwd>
#include <string>
#include <vector>

#include "harness/conformance/checked_method.hpp"

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

/// How a method is checked in this suite: stricter than by check_settings_of for the methods that the suite
/// knows.
CheckSettings check_settings(const std::string& method);

/// The method of a pair on its scene; made once per process, and so is its answer.
const CheckedMethod& checked_method(const MethodCase& pair);

}  // namespace signorini::test
