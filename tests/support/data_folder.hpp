#pragma once
// Where the tests' data files are.

#include <filesystem>

namespace signorini::test {

/// The folder tests/data of the source tree.
std::filesystem::path data_folder();

}  // namespace signorini::test
