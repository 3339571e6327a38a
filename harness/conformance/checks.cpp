#include "harness/conformance/checks.hpp"

#include <array>

namespace signorini {

std::span<const MethodCheck> method_checks() {
  static const std::array checks{
      MethodCheck{"declaration", "declares its name, laws, ladder and options", check_declaration},
      MethodCheck{"echo", "echoes its options as they were set", check_echo},
      MethodCheck{"refusals", "refuses bad options in one line", check_refusals},
  };
  return checks;
}

std::span<const SceneCheck> scene_checks() {
  static const std::array checks{
      SceneCheck{"applicability", "refuses a scene only with a reason, and declares a law that fits",
                 check_applicability},
      SceneCheck{"trajectory", "answers with a sound trajectory", check_trajectory},
      SceneCheck{"determinism", "gives the same bits again", check_determinism},
      SceneCheck{"time-budget", "ends soon after its time is up", check_time_budget},
      SceneCheck{"load-scaling", "scales with load and gap", check_load_scaling},
      SceneCheck{"structure-scaling", "scales its forces with the structure", check_structure_scaling},
      SceneCheck{"time-scaling", "does not depend on the unit of time", check_time_scaling},
      SceneCheck{"numbering", "does not depend on the numbering of coordinates", check_numbering},
      SceneCheck{"time-shift", "comes later with the load", check_time_shift},
      SceneCheck{"contact-free", "is the linear response where no stop is in reach", check_contact_free},
  };
  return checks;
}

}  // namespace signorini
