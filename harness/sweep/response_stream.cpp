#include "harness/sweep/response_stream.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "harness/sweep/branch_json.hpp"
#include "harness/text/json.hpp"

namespace signorini {

ResponseStream::ResponseStream(std::string format, MethodResponse shape)
    : format_(std::move(format)), shape_(std::move(shape)) {}

void ResponseStream::branch(const MethodResponse& of, const Branch& branch) {
  if (of.method != method_) branches_ = 0;
  method_ = of.method;
  if (format_ == "jsonl") print(json_line(to_json(branch, of.method, of.other_law)) + "\n");
  if (format_ == "csv") rows(of, {.branches = {branch}}, {});
  ++branches_;
}

void ResponseStream::step(const MethodResponse& of, const SweepPoint& step) {
  if (format_ == "jsonl") print(json_line(to_json(step, of.method, of.other_law)) + "\n");
  if (format_ == "csv") rows(of, {}, {step});
}

void ResponseStream::end() {
  if (format_ == "csv" && !begun_) rows({}, {}, {});
}

void ResponseStream::rows(const MethodResponse& of, BranchDiagram diagram, std::vector<SweepPoint> steps) {
  MethodResponse response = shape_;
  response.method = of.method;
  response.other_law = of.other_law;
  response.diagram = std::move(diagram);
  response.steps = std::move(steps);
  const std::string text = to_csv(branch_table({response}, branches_));
  print(begun_ ? text.substr(text.find('\n') + 1) : text);
  begun_ = true;
}

void ResponseStream::print(const std::string& text) {
  fmt::print("{}", text);
  (void)std::fflush(stdout);
}

}  // namespace signorini
