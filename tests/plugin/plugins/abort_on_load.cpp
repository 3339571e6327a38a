#include <cstdio>
#include <cstdlib>

namespace {
const bool kNever = [] {
  std::fputs("this cannot go well\n", stderr);
  std::abort();
  return true;
}();
}  // namespace
