#include "harness/run/applicability.hpp"

#include <nlohmann/json.hpp>

#include "harness/interrupt.hpp"
#include "harness/records/record_json.hpp"
#include "harness/text/json.hpp"
#include "methods/curve.hpp"

namespace signorini {

/// What the child sends of a method; its own failure is the parent's to see.
void visit_fields(Either<Applicability> auto& answer, auto&& field) {
  field(required("applies"), answer.applies);
  field(Field{"reason"}, answer.reason);
  field(Field{"law"}, answer.law);
}

namespace {

// A question takes some passes over the matrices: half a minute for a million coordinates on a busy machine.
double seconds_per_method(const Problem& problem) {
  constexpr double kLeast = 10.0, kPerCoordinate = 1e-4;
  return kLeast + kPerCoordinate * problem.size();
}

/// Whether the method answers what the case asks: a solve, or a curve of its own.
Support support_of(const Method& method, const Problem& problem,
                   const std::optional<ResponseQuestion>& response) {
  if (response && response->way == ResponseWay::steps && highest_load_harmonic(problem) == 0)
    return {false,
            "without a periodic load a solve at a frequency has the state of rest, and no free motion"};
  const CurveMethod* const curve =
      response && response->way == ResponseWay::arc_length ? method.curve() : nullptr;
  return curve == nullptr ? method.supports(problem)
                          : curve->follows(over_frequency(problem, response->from, response->to));
}

void send_answer(const Scene& scene, const Case& planned_case, const LineSender& send) {
  const std::unique_ptr<Method> method = planned_case.choice.make();
  const Support support = support_of(*method, scene.problem, planned_case.response);
  Applicability answer{.applies = support.ok, .reason = support.reason};
  if (support.ok) answer.law = method->law(scene.problem);
  send(json_line(write_fields(answer)));
}

}  // namespace

std::vector<Applicability> ask_applicability(const Scene& scene, std::span<const Case* const> cases,
                                             int memory_mb) {
  std::vector<Applicability> answers;
  while (answers.size() < cases.size() && !interrupted()) {
    const auto rest = cases.subspan(answers.size());
    const ChildEnd end = run_isolated(
        [&](const LineSender& send) {
          for (const Case* planned_case : rest) send_answer(scene, *planned_case, send);
        },
        {.stage_seconds = {seconds_per_method(scene.problem)}, .memory_mb = memory_mb});
    for (const std::string& line : end.lines) read_fields(parse_json(line), answers.emplace_back());
    // The method that ended the child gets its ending; those after it are asked in another child.
    if (end.kind != ChildEnd::Kind::finished && answers.size() < cases.size())
      answers.push_back({.failure = end});
  }
  return answers;
}

}  // namespace signorini
