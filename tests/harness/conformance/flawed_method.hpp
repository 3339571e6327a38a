#pragma once
// A sound method with one defect, to see that the conformance suite finds that and nothing else.

#include "methods/catalogue.hpp"

namespace signorini::test {

enum class Flaw {
  none,
  accepts_any_option,
  claims_too_high_an_order,
  crashes_when_repeated,
  declares_another_law,
  depends_on_numbering,
  depends_on_the_time_origin,
  depends_on_the_unit_of_force,
  depends_on_the_unit_of_length,
  depends_on_the_unit_of_time,
  drifts,
  gives_up,
  hangs,
  has_a_ladder_that_it_refuses,
  ignores_its_budget,
  passes_through_stops,
  refuses_without_reason,
};

/// fourier-lipschitz with this defect.
MethodEntry flawed_method(Flaw flaw);

}  // namespace signorini::test
