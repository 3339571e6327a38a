#include "harness/records/line_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/records/json_fields.hpp"
#include "tests/problems/temporary_folder.hpp"

namespace signorini::line_file_test {
namespace {

TEST(ReadLines, TakeWholeLinesInOrderAndLeaveOutATornOne) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("lines", "one\n\ntwo\nthr");
  std::vector<std::string> lines;
  const std::uint64_t bytes = read_lines(
      file, [&](const Line& line) { lines.emplace_back(line.text); }, "it comes again");
  EXPECT_EQ(lines, (std::vector<std::string>{"one", "two"}));
  EXPECT_EQ(bytes, std::string("one\n\ntwo\n").size());
}

TEST(ReadLines, TakeLinesThatAreLongerThanABlock) {
  const test::TemporaryFolder folder;
  const std::vector<std::string> written{std::string(700'000, 'a'), "b", std::string(300'000, 'c'), "d"};
  std::string text;
  for (const std::string& line : written) text += line + "\n";
  const auto file = folder.write("lines", text);
  std::vector<std::string> lines;
  std::vector<LinePlace> places;
  const auto take = [&](const Line& line) {
    lines.emplace_back(line.text);
    places.push_back(line.place);
  };
  EXPECT_EQ(read_lines(file, take, "it comes again"), text.size());
  EXPECT_EQ(lines, written);
  const StoredLines stored(file);
  for (std::size_t i = written.size(); i-- > 0;) EXPECT_EQ(stored.at(places[i]), written[i]);
  EXPECT_THROW((void)stored.at({.begin = text.size() - 1, .size = 2}), UsageError);
}

TEST(ReadLines, LeaveOutALineThatNoMemoryShouldHold) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("lines", "one\n" + std::string(kLongestLine + 1, 'x') + "\ntwo\n");
  std::vector<std::string> lines;
  testing::internal::CaptureStderr();
  (void)read_lines(
      file, [&](const Line& line) { lines.emplace_back(line.text); }, "it comes again");
  EXPECT_NE(testing::internal::GetCapturedStderr().find("lines:2: line = 67108865 bytes"), std::string::npos);
  EXPECT_EQ(lines, (std::vector<std::string>{"one", "two"}));
}

TEST(ReadLines, WarnOfALineThatIsRefusedAndGoOn) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("lines", "one\nbad\ntwo\n");
  int taken = 0;
  const auto take = [&](const Line& line) {
    if (line.text == "bad") throw BadRecord("line = bad\x1b (must be good)");
    ++taken;
  };
  testing::internal::CaptureStderr();
  (void)read_lines(file, take, "it comes again");
  const std::string warning = testing::internal::GetCapturedStderr();
  EXPECT_EQ(taken, 2);
  EXPECT_NE(warning.find("lines:2: line = bad"), std::string::npos) << warning;
  EXPECT_NE(warning.find("left out, and it comes again"), std::string::npos) << warning;
  EXPECT_EQ(warning.find('\x1b'), std::string::npos);
}

TEST(AppendLine, AddsWholeLinesToWhatIsThere) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("lines", "one\n");
  {
    const Descriptor descriptor = open_to_append(file);
    append_line(descriptor, "two", file);
    append_line(descriptor, "three", file);
  }
  EXPECT_EQ(read_file(file), "one\ntwo\nthree\n");
  EXPECT_THROW((void)open_to_append("/dev/full"), UsageError);
  const Descriptor full(open("/dev/full", O_WRONLY | O_CLOEXEC));
  EXPECT_THROW(append_line(full, "four", "/dev/full"), UsageError);
}

TEST(LockFolder, KeepsOthersOutAsLongAsItIsOpen) {
  const test::TemporaryFolder folder;
  {
    const Descriptor lock = lock_folder(folder.path());
    EXPECT_TRUE(folder_in_use(folder.path()));
    EXPECT_THROW((void)lock_folder(folder.path()), UsageError);
  }
  EXPECT_FALSE(folder_in_use(folder.path()));
  EXPECT_NO_THROW((void)lock_folder(folder.path()));
}

TEST(OpenToAppend, RefusesALink) {
  const test::TemporaryFolder folder;
  const auto own = folder.write("own", "precious");
  std::filesystem::create_symlink(own, folder.path() / "lines");
  EXPECT_THROW((void)open_to_append(folder.path() / "lines"), UsageError);
}

TEST(MakeFolder, MakesFoldersAndSaysWhyItCannot) {
  const test::TemporaryFolder folder;
  make_folder(folder.path() / "a/b");
  EXPECT_TRUE(std::filesystem::is_directory(folder.path() / "a/b"));
  const auto file = folder.write("file", "");
  EXPECT_THROW(make_folder(file / "c"), UsageError);
}

}  // namespace
}  // namespace signorini::line_file_test
