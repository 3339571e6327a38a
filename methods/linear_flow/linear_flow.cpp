#include "methods/linear_flow/linear_flow.hpp"

namespace signorini {

double fastest_left(const std::vector<FadingRate>& terms, double time) {
  for (const FadingRate& term : terms) {
    if (term.until > time) return term.rate;
  }
  return 0.0;
}

}  // namespace signorini
