#pragma once
// The same cases at several values of one option.

#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "harness/report/evaluation/case_result.hpp"

namespace signorini {

/// A method with all its settings but one: "fourier-lipschitz[harmonics=40]", and the key of that one.
using Varied = std::pair<std::string, std::string>;

/// Results by the value of the varied option.
struct Variation {
  std::vector<std::string> values = {};  ///< numbers in rising order; words as they ran
  std::map<std::string, std::vector<const CaseResult*>> results = {};
};

/// Every way to single out one setting while another number stands; a number alone is the method's
/// resolution. \param results  outlive what is returned
std::map<Varied, Variation> variations_of(std::span<const CaseResult> results);

/// The number in a value, "1e3" or in units of a scale "1e3x"; nothing in a word.
std::optional<double> number_in(const std::string& value);

}  // namespace signorini
