#include "harness/sweep/response_stream.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "harness/sweep/branch_json.hpp"
#include "harness/text/json.hpp"

namespace signorini {

namespace {

void print_line(const std::string& line) {
  fmt::print("{}\n", line);
  (void)std::fflush(stdout);
}

}  // namespace

ResponseStream::ResponseStream(std::string format, MethodResponse shape)
    : format_(std::move(format)), shape_(std::move(shape)) {}

void ResponseStream::branch(const MethodResponse& of, const Branch& branch) {
  if (of.method != method_) branches_ = 0;
  method_ = of.method;
  if (format_ == "jsonl") {
    print_line(json_line(to_json(branch, of.method, of.other_law)));
  } else if (prints()) {
    MethodResponse response = shape_;
    response.method = of.method;
    response.other_law = of.other_law;
    response.diagram.branches = {branch};
    rows(response);
  }
  ++branches_;
}

void ResponseStream::step(const MethodResponse& of, const SweepPoint& step) {
  if (format_ == "jsonl") {
    print_line(json_line(to_json(step, of.method, of.other_law)));
  } else if (prints()) {
    MethodResponse response = shape_;
    response.method = of.method;
    response.other_law = of.other_law;
    response.steps = {step};
    rows(response);
  }
}

void ResponseStream::end() {
  if (format_ == "csv" && !begun_) rows(shape_);
}

void ResponseStream::rows(const MethodResponse& response) {
  std::string text = to_csv(branch_table({response}, branches_));
  if (begun_) text.erase(0, text.find('\n') + 1);
  begun_ = true;
  fmt::print("{}", text);
  (void)std::fflush(stdout);
}

}  // namespace signorini
