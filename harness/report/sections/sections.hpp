#pragma once
// The sections of a report: every table, and their order.

#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// Sections of a run; none where the run has nothing to show.
using Sections = std::vector<Section>;

/// Every section of a report that has rows; of a run of one scene none that compares methods over scenes. A
/// new table is a function as those below and one line in this one.
Sections sections_of(const Evaluation& evaluation);

/// What each configuration solves under the scenes' own laws, at which error and in what time; and what under
/// other laws.
Sections summary_sections(const Evaluation& evaluation);

/// What the methods of the run cannot do, of those that this program knows and that say so.
Sections limit_sections(const Evaluation& evaluation);

/// Of scenes drawn from ranges: shares that are solved and rates of false claims, with their intervals. Empty
/// where no scene is drawn.
Sections population_sections(const Evaluation& evaluation);

/// How many runs of each configuration ended how: claims certified, unproven and refuted.
Sections outcome_sections(const Evaluation& evaluation);

/// Pairs of methods that solve the same equations, and how far apart their errors are. Empty where no record
/// knows of any.
Sections identity_sections(const Evaluation& evaluation);

/// Median errors and time of each method at each resolution.
Sections speed_sections(const Evaluation& evaluation);

/// Methods from their plain form to their default, one addition after another. Empty for a run without plain
/// forms.
Sections ablation_sections(const Evaluation& evaluation);

/// Where each method breaks, over families of scenes from easy to impossible: the families, the severest
/// level that each method solves, and condition estimates. Empty for a run without families.
Sections breakdown_sections(const Evaluation& evaluation);

/// Solved cases and errors at several values of one option, the others as stated.
Sections sensitivity_sections(const Evaluation& evaluation);

/// Errors with one option false and true, over all scenes and scene by scene.
Sections switch_sections(const Evaluation& evaluation);

/// How many repeated solves gave the same bits.
Sections repeat_sections(const Evaluation& evaluation);

/// Of methods from plugins the times at equal error, over those of the program's own. Empty where there are
/// none.
Sections rival_sections(const Evaluation& evaluation);

/// Of methods that are commands and tell their own time, what passes beside it. Empty where there is none.
Sections hand_over_sections(const Evaluation& evaluation);

/// Rankings, of each table one section for every group of configurations that are compared: how many scenes
/// each solves to each error and the median time; intervals of confidence of shares and median times at the
/// error of the verdict; shifted geometric means, PAR2 and shares of the joint performance profile; shares of
/// targets, a scene and an error each, reached within times; performance profiles of two at a time; counts of
/// work to each error.
Sections ranking_sections(const Evaluation& evaluation);

/// Time to error, scene by scene, of configurations that represent the law of the scene.
Sections scene_sections(const Evaluation& evaluation);

/// The same of configurations that represent another law than the scene.
Sections other_law_sections(const Evaluation& evaluation);

/// Which method for whole frequency responses, how much of them each one finds, over kinds of scenes and
/// response by response, and where the exact ones are open. Empty for a run without responses.
Sections response_sections(const Evaluation& evaluation);

/// One row per record of a motion.
Sections case_sections(const Evaluation& evaluation);

/// Records that did not converge or are not certified, with the reason.
Sections remark_sections(const Evaluation& evaluation);

}  // namespace signorini
