#include "tests/support/data_folder.hpp"

namespace signorini::test {

std::filesystem::path data_folder() { return SIGNORINI_TEST_DATA; }

}  // namespace signorini::test
