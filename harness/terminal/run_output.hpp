#pragma once
// What `run` prints of scenes while it runs, and of tables at its end.

#include <cstddef>
#include <string>
#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/report/evaluation/case_result.hpp"
#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// A line per scene on stdout; per few scenes where that is no terminal, so that there are at most kMost.
class SceneLines {
 public:
  static constexpr std::size_t kMost = 70;

  /// \param scenes  of the whole run
  explicit SceneLines(std::size_t scenes);
  ~SceneLines();  ///< prints what is left
  SceneLines(const SceneLines&) = delete;
  SceneLines& operator=(const SceneLines&) = delete;

  /// Takes the records of a scene that is done, at least one.
  void add(const std::vector<Record>& records);

 private:
  void print();

  std::size_t together_;
  std::vector<std::string> scenes_;
  OutcomeCounts counts_;
};

/// Prints the rows of a scene.
void print_scene(const std::vector<Record>& records);

/// All sections; of the rows, if they were all printed scene by scene, only how to read them.
std::vector<Section> closing_sections(const Evaluation& evaluation, bool rows_printed);

}  // namespace signorini
