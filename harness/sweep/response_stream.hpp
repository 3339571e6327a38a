#pragma once
// A response printed as it comes.

#include <string>

#include "harness/sweep/branch_response.hpp"

namespace signorini {

/// Prints each branch and each step on standard output as soon as it is known, in a format whose rows need
/// not wait for others: csv, with the header before the first row, or jsonl, an object per line: a branch
/// with its method, or a step with its method.
class ResponseStream {
 public:
  /// \param format  any; others than csv and jsonl print nothing
  /// \param shape   what all rows have in common: its parameter and whether points are at values
  ResponseStream(std::string format, MethodResponse shape);

  [[nodiscard]] bool prints() const { return format_ == "csv" || format_ == "jsonl"; }
  void branch(const MethodResponse& of, const Branch& branch);
  void step(const MethodResponse& of, const SweepPoint& step);
  /// After the last one: of csv without any row the header.
  void end();

 private:
  void rows(const MethodResponse& of, BranchDiagram diagram, std::vector<SweepPoint> steps);
  static void print(const std::string& text);

  std::string format_;
  MethodResponse shape_;
  std::string method_;        // of the last branch
  std::size_t branches_ = 0;  // of it so far
  bool begun_ = false;
};

}  // namespace signorini
