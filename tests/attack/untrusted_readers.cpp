#include "tests/attack/untrusted_readers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/extend/plugins/command_method.hpp"
#include "harness/judge/measures/measures.hpp"
#include "harness/records/line_file.hpp"
#include "harness/records/record_json.hpp"
#include "harness/records/sampled_trajectory.hpp"
#include "harness/report/formats/formats.hpp"
#include "harness/report/page/page.hpp"
#include "harness/report/sections/sections.hpp"
#include "harness/run/trial.hpp"
#include "harness/run_folder/record_store.hpp"
#include "harness/sweep/branch_json.hpp"
#include "harness/sweep/branch_response.hpp"
#include "problems/assembly/solid.hpp"
#include "problems/files/gmsh_mesh.hpp"
#include "problems/files/matrices/matrix_file.hpp"
#include "problems/files/toml_tree.hpp"
#include "problems/scene/scene_family.hpp"
#include "problems/scene/scene_file.hpp"
#include "problems/validation.hpp"
#include "tests/attack/untrusted_checks.hpp"
#include "tests/harness/stored_records.hpp"

namespace signorini::test {

void require(bool kept, const std::string& promise) {
  if (!kept) throw Violation(promise);
}

void require_one_line(const std::string& message) {
  constexpr std::size_t kLongest = 2000;
  require(!message.empty(), "a refusal has a text");
  require(!has_control_characters(message), "a refusal is one line: " + one_line(message));
  require(message.size() <= kLongest, "a refusal is short: " + one_line(message));
  require(one_line(message, message.size() + 1) == message, "a refusal is UTF-8: " + one_line(message));
}

const Problem& answered_problem() {
  static const Problem problem = parse_scene(
      "schema = 1\nname = \"attack\"\n[system]\nkind = \"sdof\"\nmass = 1\ndamping = 0.1\nstiffness = 1\n"
      "[forcing]\nfrequency = 2.2\n[[forcing.term]]\ndof = 0\ncos = 1\n[[contact]]\ndof = 0\ngap = 0.2\n"
      "[law]\nrestitution = 0.8\n",
      "attack.toml");
  return problem;
}

namespace {

void require_finite(const SparseMatrix& matrix) {
  const Eigen::Map<const Eigen::VectorXd> values(matrix.valuePtr(), matrix.nonZeros());
  require(values.allFinite(), "entries are finite");
}

/// A number of a table, or the product of those in a list; 0 where there is none.
double number_at(const TomlNode& table, std::string_view key) {
  const TomlNode* node = table.find(key);
  if (node == nullptr) return 0.0;
  if (const auto* whole = std::get_if<std::int64_t>(&node->value)) return static_cast<double>(*whole);
  const auto* list = std::get_if<TomlArray>(&node->value);
  double product = list == nullptr ? 0.0 : 1.0;
  for (const TomlNode& item : list == nullptr ? TomlArray{} : *list) {
    if (const auto* whole = std::get_if<std::int64_t>(&item.value)) product *= static_cast<double>(*whole);
  }
  return product;
}

/// Whether what a scene asks for is assembled in a moment even with sanitizers. Large scenes are attacked in
/// processes of limited time and memory.
bool is_small(const TomlNode& document) {
  constexpr double kMostElements = 200.0, kMostFacets = 100.0;
  const TomlNode* system = document.find("system");
  if (system != nullptr &&
      number_at(*system, "elements") * std::max(1.0, number_at(*system, "count")) > kMostElements)
    return false;
  const TomlNode* contacts = document.find("contact");
  const auto* tables = contacts == nullptr ? nullptr : std::get_if<TomlArray>(&contacts->value);
  return tables == nullptr || std::ranges::all_of(*tables, [](const TomlNode& table) {
           return number_at(table, "facets") <= kMostFacets;
         });
}

bool attack_scene(std::string_view text) {
  constexpr int kSmall = 300;  // coordinates of a matrix that is factorised at once
  try {
    TomlNode document = parse_toml(text, "attack.toml");
    const std::vector<std::string> levels = family_labels(document, "attack.toml");
    const std::string level = levels.empty() ? "" : levels.back();
    static_cast<void>(choose_variant(document, "attack.toml", level));
    if (!is_small(document)) return false;
    const Problem problem = parse_scene(text, "attack.toml", level);
    // What finite elements are by construction is looked at here.
    if (problem.size() <= kSmall) validate(problem);
    for (const SparseMatrix* matrix : {&problem.mass(), &problem.damping(), &problem.stiffness()}) {
      require(matrix->rows() == problem.size() && matrix->cols() == problem.size(), "matrices are square");
      require_finite(*matrix);
    }
    require(std::isfinite(problem.period()) && problem.period() > 0.0, "the period is positive");
    return true;
  } catch (const SceneError& refusal) {
    require_one_line(refusal.what());
    return false;
  }
}

/// The matrix as a file with every entry listed, of 17 digits: enough for each double to come back.
std::string market_file(const SparseMatrix& matrix) {
  std::string text = "%%MatrixMarket matrix coordinate real general\n" + std::to_string(matrix.rows()) + " " +
                     std::to_string(matrix.cols()) + " " + std::to_string(matrix.nonZeros()) + "\n";
  for (Eigen::Index column = 0; column < matrix.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry) {
      std::array<char, 64> line{};
      std::snprintf(line.data(), line.size(), "%ld %ld %.17g\n", static_cast<long>(entry.row()) + 1,
                    static_cast<long>(entry.col()) + 1, entry.value());
      text += line.data();
    }
  }
  return text;
}

bool attack_matrix(std::string_view text) {
  constexpr Eigen::Index kMany = 100000;  // rows, of which a short file may promise millions
  try {
    const SparseMatrix matrix = read_matrix_file(text, "attack.mtx").matrix;
    require(matrix.rows() == matrix.cols() && matrix.rows() >= 1, "the matrix is square");
    require_finite(matrix);
    if (matrix.rows() > kMany) return true;
    const SparseMatrix again = read_matrix_file(market_file(matrix), "again.mtx").matrix;
    require(again.rows() == matrix.rows() && again.nonZeros() == matrix.nonZeros() &&
                SparseMatrix(again - matrix).norm() == 0.0,
            "a matrix that is written reads the same");
    return true;
  } catch (const SceneError& refusal) {
    require_one_line(refusal.what());
    return false;
  }
}

void require_nodes(const ElementList& elements, const SolidMesh& mesh) {
  require(elements.shape != nullptr && std::ssize(elements.nodes) == elements.count() * elements.shape->nodes,
          "elements have all their nodes");
  require(std::ranges::all_of(elements.nodes,
                              [&](int node) { return node >= 0 && node < std::ssize(mesh.nodes); }),
          "nodes of elements are nodes of the mesh");
}

bool attack_mesh(std::string_view text) {
  constexpr int kFew = 20;  // elements that are assembled in a moment
  try {
    const SolidMesh mesh = read_gmsh_mesh(text, "attack.msh");
    require(!mesh.solids.empty() && mesh.size() > 0, "a mesh has a solid");
    require(std::ranges::all_of(mesh.nodes, [](const auto& place) { return place.allFinite(); }),
            "places are finite");
    int elements = 0;
    for (const ElementList& list : mesh.solids) {
      require_nodes(list, mesh);
      elements += list.count();
    }
    for (const auto& [name, group] : mesh.groups) {
      for (const ElementList& list : group) require_nodes(list, mesh);
      if (elements <= kFew) static_cast<void>(load_on_group(mesh, group, 0));
    }
    if (elements <= kFew) static_cast<void>(assemble(Solid{.mesh = std::make_shared<const SolidMesh>(mesh)}));
    return true;
  } catch (const InvalidProblem& refusal) {
    require_one_line(refusal.what());  // an element without volume
    return false;
  } catch (const SceneError& refusal) {
    require_one_line(refusal.what());
    return false;
  }
}

std::string lines_of(const std::vector<Record>& records) {
  std::string lines;
  for (const Record& record : records) lines += json_line(to_json(record)) + "\n";
  return lines;
}

/// A product of the report, for people or for programs, that must hold no bytes that act on a terminal.
void require_harmless(const std::string& product) {
  std::string text = product;
  std::erase(text, '\n');
  require(!has_control_characters(text), "a product holds no control characters");
}

bool attack_records(std::string_view text) {
  const std::vector<Record> records = read_records(MemoryFile(text).path());
  const std::string lines = lines_of(records);
  require(lines_of(read_records(MemoryFile(lines).path())) == lines,
          "records that are written read the same");
  const Evaluation evaluation(records);
  const std::vector<Section> sections = sections_of(evaluation);
  require_harmless(markdown_report(sections));
  for (const auto write : {csv_report, measures_csv})
    write(evaluation, [](std::string_view row) { require_harmless(std::string(row)); });
  // Pages are long: of one input in eight, which a fuzzer can change by a byte.
  if (text.size() % 8 != 0) return !records.empty();
  for (const Section& section : sections) require_harmless(to_latex(section));
  static_cast<void>(html_page("attack", nullptr, evaluation, sections));
  return !records.empty();
}

/// What the harness makes of a motion before it says anything about it.
void judge(const Problem& problem, const Trajectory& trajectory) {
  const SampledAnswer answer = sample_answer(problem, trajectory);
  if (!answer.defect.empty()) return require_one_line(answer.defect);
  const Samples& samples = answer.motion.samples;
  require(samples.x.allFinite() && samples.velocity.allFinite() && samples.force.allFinite(),
          "a motion that is judged is finite");
  static_cast<void>(answer_digest(trajectory));
  const Physics physics = measure_physics(problem, as_represented(problem.law()), answer.motion);
  for (const Measure& measure : {physics.penetration, physics.complementarity, physics.energy_defect})
    require(!measure || *measure >= 0.0, "measures are no less than zero");
}

bool attack_answer(std::string_view text) {
  const Problem& problem = answered_problem();
  try {
    const Solution solution = read_command_answer(std::string(text), problem.period()).solution;
    require_one_line(solution.message);
    if (solution.trajectory) judge(problem, *solution.trajectory);
    return true;
  } catch (const SolveFailure& refusal) {
    require(refusal.status == Status::invalid_output, "an answer that is none is invalid output");
    require_one_line(refusal.what());
    return false;
  }
}

/// A line that is accepted, as it is written again.
std::string rewritten(const nlohmann::ordered_json& json) {
  if (json.contains("points")) {
    MethodResponse response{.method = "m"};
    response.diagram.branches = {branch_from_json(json)};
    require_harmless(to_csv(branch_table({response})));
    require_harmless(to_markdown(branch_table({response})));
    return json_line(to_json(response.diagram.branches.front(), "m"));
  }
  return json_line(to_json(step_from_json(json), "m"));
}

bool attack_branches(std::string_view text) {
  bool accepted = false;
  const auto take = [&](const Line& line) {
    const auto json = nlohmann::ordered_json::parse(line.text, nullptr, false);
    if (!json.is_object()) throw BadRecord("line = unreadable");
    const std::string again = rewritten(json);
    require(rewritten(nlohmann::ordered_json::parse(again)) == again,
            "a line that is written reads the same");
    accepted = true;
  };
  static_cast<void>(read_lines(MemoryFile(text).path(), take, "its method is asked again"));
  return accepted;
}

constexpr std::array kReaders{UntrustedReader{.name = "scene", .attack = attack_scene},
                              UntrustedReader{.name = "matrix", .attack = attack_matrix},
                              UntrustedReader{.name = "mesh", .attack = attack_mesh},
                              UntrustedReader{.name = "records", .attack = attack_records},
                              UntrustedReader{.name = "branches", .attack = attack_branches},
                              UntrustedReader{.name = "answer", .attack = attack_answer},
                              UntrustedReader{.name = "archive", .attack = attack_archive},
                              UntrustedReader{.name = "pack", .attack = attack_pack},
                              UntrustedReader{.name = "options", .attack = attack_options},
                              UntrustedReader{.name = "curves", .attack = attack_curves},
                              UntrustedReader{.name = "suite", .attack = attack_suite}};

}  // namespace

std::span<const UntrustedReader> untrusted_readers() { return kReaders; }

const UntrustedReader& untrusted_reader(std::string_view name) {
  const auto* found = std::ranges::find(kReaders, name, &UntrustedReader::name);
  if (found == kReaders.end()) throw std::out_of_range("no such reader: " + std::string(name));
  return *found;
}

}  // namespace signorini::test
