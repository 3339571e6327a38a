// Where Debian has put a BLAS with threads before the serial one, as it does with numpy or Octave installed.

#include <cblas.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include "harness/isolation/isolation.hpp"
#include "harness/isolation/process_state.hpp"

namespace signorini::one_thread_test {
namespace {

/// The first entry of a product large enough for several threads.
double multiply_large_matrices() {
  constexpr int kSize = 400;
  const std::vector<double> A(static_cast<std::size_t>(kSize) * kSize, 0.5);
  std::vector<double> C(A.size());
  cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, kSize, kSize, kSize, 1.0, A.data(), kSize, A.data(),
              kSize, 0.0, C.data(), kSize);
  return C.front();
}

std::ptrdiff_t count_threads() {
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return std::distance(begin(tasks), end(tasks));
}

TEST(ComputeOnOneThread, LeavesNoThreadThatAChildWouldWaitFor) {
  EXPECT_EQ(multiply_large_matrices(), 100.0);
  const ChildEnd child = run_isolated(
      [](const LineSender& send) {
        send(std::to_string(multiply_large_matrices()));
        send(std::to_string(count_threads()));
      },
      {.stage_seconds = {10.0}, .grace = 0.1});
  EXPECT_EQ(child.kind, ChildEnd::Kind::finished) << describe(child);
  EXPECT_EQ(child.lines, (std::vector<std::string>{"100.000000", "1"}));
}

}  // namespace
}  // namespace signorini::one_thread_test
