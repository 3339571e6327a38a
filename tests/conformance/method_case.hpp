#pragma once
// Every method of the catalogue on every scene of the catalogue, at a cheap resolution.

#include <iosfwd>
#include <string>
#include <vector>

#include "harness/conformance/checks.hpp"

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

/// Terms of a method in this suite, tighter than those that it gets from what it says of itself; a method
/// that the suite has not met yet has those.
Terms terms_of(const std::string& method);

/// A pair ready to be checked, made once per process, as is its answer.
const Subject& subject_of(const MethodCase& pair);

}  // namespace signorini::test
