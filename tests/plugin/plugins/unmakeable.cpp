// A method that cannot be made with its own defaults.
#include "tiny.hpp"

namespace tiny {

struct Refusal {};

struct Unmakeable final : Method<StandStill> {
  static constexpr std::string_view kName = "tiny-unmakeable";
  explicit Unmakeable(const Options& options) : Method(options) { throw Refusal{}; }
};

}  // namespace tiny

SIGNORINI_PLUGIN(tiny::Unmakeable)
