#include <gtest/gtest.h>

#include <fstream>

#include "harness/files.hpp"

namespace signorini::temporary_folder_test {
namespace {

namespace fs = std::filesystem;

TEST(TemporaryFolder, IsForThisUserAloneAndGoneWithWhatIsInIt) {
  fs::path path;
  {
    const TemporaryFolder folder, other;
    path = folder.path();
    EXPECT_NE(path, other.path());
    EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_all);
    fs::create_directory(path / "inside");
    std::ofstream(path / "inside" / "file") << "text\n";
    ASSERT_TRUE(fs::exists(path / "inside" / "file"));
  }
  EXPECT_FALSE(fs::exists(path));
}

}  // namespace
}  // namespace signorini::temporary_folder_test
