// Siconos' solvers as methods of signorini.

#include "methods/plugin/plugin.hpp"

#include "event_driven.hpp"
#include "hat_lcp.hpp"
#include "moreau_jean.hpp"

SIGNORINI_PLUGIN(siconos_rivals::MoreauJean, siconos_rivals::EventDriven, siconos_rivals::HatLemke)
