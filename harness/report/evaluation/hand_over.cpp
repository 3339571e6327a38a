#include "harness/report/evaluation/hand_over.hpp"

#include <utility>

#include "harness/statistics.hpp"

namespace signorini {

std::vector<HandOver> hand_overs(const Evaluation& evaluation) {
  std::vector<std::pair<std::vector<double>, std::vector<double>>> times(evaluation.configurations().size());
  for (const CaseResult& result : evaluation.results()) {
    if (!result.seconds || !result.exchange) continue;
    auto& [own, beside] = times[evaluation.place_of(result.choice->configuration)];
    own.push_back(*result.seconds);
    beside.push_back(*result.exchange);
  }
  std::vector<HandOver> found;
  for (std::size_t place = 0; place < times.size(); ++place) {
    const auto& [own, beside] = times[place];
    if (own.empty()) continue;
    found.push_back({.configuration = evaluation.configurations()[place],
                     .cases = static_cast<int>(own.size()),
                     .own = median(own),
                     .beside = median(beside)});
  }
  return found;
}

}  // namespace signorini
