#pragma once
// Hat functions in time with a contact condition at the nodes: the problem behind hat-lcp, and the coarse
// solve that exact-orbit starts from.

#include <memory>
#include <optional>

#include "methods/hat_functions/hat_settings.hpp"
#include "methods/method.hpp"

namespace signorini {

/// The scene on N nodes as one linear complementarity problem, ready to be solved. Without `restitution` the
/// condition holds on the nodal gaps; with it on g - (x_{k+1} + e x_{k-1}) / (1 + e), the periodic form of
/// the Paoli-Schatzman scheme [paoli2002]. A spring stop adds its compliance. `problem` must outlive the
/// result. \throws std::runtime_error if the structure cannot be factorised
std::unique_ptr<PreparedMethod> hat_contact(const Problem& problem, const HatSettings& settings,
                                            std::optional<double> restitution);

}  // namespace signorini
