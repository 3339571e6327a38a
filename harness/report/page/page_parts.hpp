#pragma once
// The parts of a page, each as HTML. All text of records in them is escaped.

#include <cstddef>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// The sections of these kinds, in their order.
std::vector<const Section*> of_kinds(std::span<const Section> sections,
                                     std::initializer_list<SectionKind> kinds);

/// The place in Evaluation::groups whose profiles a section shows.
std::optional<std::size_t> group_of(const Section& section);

/// Links to all parts of the page.
std::string navigation(const Evaluation& evaluation, std::span<const Section> sections);

/// The verdict of `report --format screen`, with all methods of each group.
std::string verdict_of(const Evaluation& evaluation);

/// Small figures of all scenes on the same axes.
std::string side_by_side(const Evaluation& evaluation);

/// A section with its words, its table, and performance profiles if it has any.
std::string section_of(const Section& section, const char* heading = "h2");

/// One scene: its law and orbit, its figures, and its rows of the sections of scenes.
/// \param data  of its figures: {"work": work_precision_data, "motion": motion_data, "schematic":
/// schematic_data}
std::string scene_of(const std::string& scene, const Evaluation& evaluation,
                     std::span<const Section> sections, const nlohmann::ordered_json& data);

}  // namespace signorini
