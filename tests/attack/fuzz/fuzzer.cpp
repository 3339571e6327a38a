// What libFuzzer calls for every input that it makes: one reader, FUZZED_READER, per program.

#include <cstddef>
#include <cstdint>

#include "tests/attack/untrusted_readers.hpp"

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto attack = signorini::test::untrusted_reader(FUZZED_READER).attack;
  attack({reinterpret_cast<const char*>(data), size});
  return 0;
}
