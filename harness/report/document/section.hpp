#pragma once
// A report is a list of sections; every format prints the same ones.

#include <string>
#include <string_view>
#include <vector>

#include "harness/report/document/figure.hpp"
#include "harness/report/evaluation/evaluation.hpp"
#include "harness/table.hpp"

namespace signorini {

/// One table with its words and figures. Text is plain, `code` between backquotes.
struct Section {
  std::string id = {};     ///< lower-kebab-case: names of files, anchors, markers in other documents
  std::string title = {};  ///< without a full stop
  std::string text = {};   ///< above the table
  Table table = {};
  std::string note = {};  ///< below it
  std::vector<Figure> figures = {};
};

/// Makes sections from a run; none where the run has nothing to say on the matter.
using SectionMaker = std::vector<Section> (*)(const Evaluation& evaluation);

/// Every section of a report, in its order. A new table is a SectionMaker and one line in this function.
std::vector<Section> sections_of(const Evaluation& evaluation);

// The makers, by file.

// summary_sections.cpp
std::vector<Section> summary_sections(const Evaluation& evaluation);  ///< statuses per method
std::vector<Section> speed_sections(const Evaluation& evaluation);    ///< medians per resolution

// breakdown_sections.cpp: of runs with families
std::vector<Section> breakdown_sections(
    const Evaluation& evaluation);  ///< severest levels, false convergence

// sensitivity_sections.cpp
std::vector<Section> sensitivity_sections(const Evaluation& evaluation);  ///< to one option at a time
std::vector<Section> switch_sections(const Evaluation& evaluation);       ///< errors without and with it
std::vector<Section> repeat_sections(const Evaluation& evaluation);       ///< the same bits again?

// contest_sections.cpp: one section per contest
std::vector<Section> time_to_error_sections(const Evaluation& evaluation);
std::vector<Section> mean_sections(const Evaluation& evaluation);  ///< with the joint performance profile
std::vector<Section> pairwise_sections(const Evaluation& evaluation);
std::vector<Section> work_sections(const Evaluation& evaluation);

// ladder_sections.cpp
std::vector<Section> scene_sections(const Evaluation& evaluation);      ///< time to error, scene by scene
std::vector<Section> other_law_sections(const Evaluation& evaluation);  ///< of methods that solve another law

// case_sections.cpp
inline constexpr std::string_view kCasesId = "cases";
std::vector<Section> case_sections(const Evaluation& evaluation);    ///< one row per record
std::vector<Section> remark_sections(const Evaluation& evaluation);  ///< what went otherwise

}  // namespace signorini
