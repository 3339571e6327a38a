#include "harness/terminal/run_output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "harness/report/formats/formats.hpp"
#include "harness/report/formats/screen.hpp"
#include "harness/report/sections/sections.hpp"
#include "harness/terminal/terminal.hpp"

namespace signorini {

SceneLines::SceneLines(std::size_t scenes)
    : together_(is_terminal(STDOUT_FILENO) ? 1 : std::max<std::size_t>(1, (scenes + kMost - 1) / kMost)) {}

SceneLines::~SceneLines() { print(); }

void SceneLines::add(const std::vector<Record>& records) {
  scenes_.push_back(records.front().scene);
  for (const Record& record : records) counts_.add(outcome_of(record));
  if (scenes_.size() == together_) print();
}

void SceneLines::print() {
  if (scenes_.empty()) return;
  const std::string names = scenes_.size() == 1 ? scenes_.front() : scenes_.front() + " to " + scenes_.back();
  fmt::print("{}\n", scene_line(names, counts_));
  std::fflush(stdout);
  scenes_.clear();
  counts_ = {};
}

void print_scene(const std::vector<Record>& records) {
  const Evaluation evaluation(records);
  std::vector<Section> rows;
  for (const Section& section : sections_of(evaluation)) {
    if (section.kind != SectionKind::cases && section.id != "response-cases") continue;
    rows.push_back(section);
    rows.back().title = records.front().scene;  // a scene is done with the case that was its last
    rows.back().note.clear();                   // the whole report has it
  }
  fmt::print("{}\n", markdown_report(rows));
  std::fflush(stdout);
}

std::vector<Section> closing_sections(const Evaluation& evaluation, bool rows_printed) {
  std::vector<Section> sections = sections_of(evaluation);
  if (!rows_printed) return sections;
  for (Section& section : sections) {
    if (section.kind != SectionKind::cases) continue;
    section.title = "How to read the cases";
    section.text = std::exchange(section.note, {});
    section.table = {};
  }
  return sections;
}

}  // namespace signorini
