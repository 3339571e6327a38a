#pragma once
// The figures of a report: work and precision, convergence, motions, performance profiles. In a single column
// of a journal panels stand below each other and names of curves below the panel; letters keep their size.

#include <cstddef>
#include <string>
#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/report/evaluation/evaluation.hpp"
#include "harness/report/figures/column.hpp"

namespace signorini {

/// Error against time on one scene, one curve per configuration with its name at its end and
/// the resolution at each mark; hollow marks: below ten error bars. A second
/// figure shows configurations that represent another law, each against its own. Empty if no run has both
/// error and time.
std::vector<Figure> work_precision_figures(const Evaluation& evaluation, const std::string& scene,
                                           Column column = Column::own);

/// Error against the number of harmonics or samples, of configurations with several of them, with the slopes
/// of orders 1 and 2. Without data if there is none.
Figure convergence_figure(const Evaluation& evaluation, const std::string& scene,
                          Column column = Column::own);

/// Error against a constant that was given in units of its scale, "penalty=10x|100x|1e3x": one figure for
/// each such option with three values, one curve for each resolution.
std::vector<Figure> option_figures(const Evaluation& evaluation, const std::string& scene,
                                   Column column = Column::own);

/// x, velocity, force and impulse over a period at one contact, and the phase portrait: the coarsest answer
/// of each configuration that has one, on the certified orbit. Empty where the records keep no motions.
std::vector<Figure> motion_figures(const Evaluation& evaluation, const std::string& scene,
                                   Column column = Column::own);

/// Amplitude over frequency of every response: the exact branches, stable and unstable, under those of the
/// methods, a panel each, which names the law where that is not the scene's.
std::vector<Figure> response_figures(const Evaluation& evaluation, Column column = Column::own);

/// Joint performance profiles [dolan2002] of the group at this place of Evaluation::groups, at three errors.
Figure profile_figure(const Evaluation& evaluation, std::size_t group, Column column = Column::own);

/// The empirical distribution function of the time to a target [hansen2021], of the group at this place.
Figure distribution_figure(const Evaluation& evaluation, std::size_t group, Column column = Column::own);

}  // namespace signorini
