// The readers of untrusted text on the corpora that the fuzzers found, and on damaged copies of them: the
// fuzzers' first seconds, without a fuzzer.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "harness/files.hpp"
#include "methods/deadline.hpp"
#include "tests/attack/untrusted_readers.hpp"

namespace signorini::test::corpus_test {

void PrintTo(const UntrustedReader& reader, std::ostream* stream) { *stream << reader.name; }

namespace {

constexpr int kDamagedCopies = 2000;         // per reader, at least
constexpr std::size_t kLongestInput = 4096;  // of what is damaged [bytes]

std::vector<std::string> corpus_of(const UntrustedReader& reader) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(SIGNORINI_CORPUS) / reader.name))
    files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<std::string> texts;
  for (const std::filesystem::path& file : files) texts.push_back(read_file(file));
  return texts;
}

/// Of the damaged copies: as $SIGNORINI_FUZZ_SEED asks, or always the same.
unsigned long seed() {
  const char* const asked = std::getenv("SIGNORINI_FUZZ_SEED");
  return asked == nullptr ? 20261123UL : std::strtoul(asked, nullptr, 10);
}

/// What transmission, editors and people do to a file: bits flip, bytes go or come twice, the end is missing,
/// a part of another file stands in the middle, a number is another one.
class Damage {
 public:
  explicit Damage(std::vector<std::string> texts) : texts_(std::move(texts)) {
    std::erase_if(texts_,
                  [](const std::string& text) { return text.empty() || text.size() > kLongestInput; });
  }

  std::string next() {
    std::string text = texts_[below(texts_.size())];
    for (std::size_t times = 1 + below(4); times > 0 && !text.empty(); --times) damage(text);
    return text;
  }

 private:
  std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }

  void damage(std::string& text) {
    static const std::vector<std::string> kNumbers{
        "0", "-1", "1e999", "-0.0", "nan", "1e-320", "9223372036854775808"};
    const std::size_t at = below(text.size()),
                      length = 1 + below(std::min<std::size_t>(40, text.size() - at));
    switch (below(8)) {
      case 0:
        text[at] = static_cast<char>(text[at] ^ static_cast<char>(1U << below(8)));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(at, length));
        break;
      case 3:
        text.resize(at);
        break;
      case 4: {
        const std::string& other = texts_[below(texts_.size())];
        text.insert(at, other.substr(below(other.size()), length));
        break;
      }
      case 5:
        replace_token(text, at, kNumbers[below(kNumbers.size())]);
        break;
      default: {  // what a reader calls a word or a number, by another one: the text stays well formed
        const std::string& other = texts_[below(texts_.size())];
        const auto [begin, end] = token_from(other, below(other.size()));
        replace_token(text, at, other.substr(begin, end - begin));
      }
    }
  }

  /// The first word or number at or behind a place; empty where there is none.
  static std::pair<std::size_t, std::size_t> token_from(const std::string& text, std::size_t at) {
    constexpr const char* kToken = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.+-";
    const std::size_t begin = std::min(text.find_first_of(kToken, at), text.size());
    return {begin, std::min(text.find_first_not_of(kToken, begin), text.size())};
  }

  static void replace_token(std::string& text, std::size_t at, const std::string& by) {
    const auto [begin, end] = token_from(text, at);
    text.replace(begin, end - begin, by);
  }

  std::vector<std::string> texts_;
  std::mt19937_64 random_{seed()};
};

class Corpus : public testing::TestWithParam<UntrustedReader> {};

TEST_P(Corpus, IsReadAsPromised) {
  std::size_t accepted = 0, refused = 0;
  for (const std::string& text : corpus_of(GetParam())) {
    SCOPED_TRACE(text.substr(0, 400));
    EXPECT_NO_THROW(++(GetParam().attack(text) ? accepted : refused));
  }
  // What is all refused, or all taken, has stopped testing half of the reader.
  EXPECT_GT(accepted, 0U);
  EXPECT_GT(refused, 0U);
}

/// For so many seconds of the processor, as $SIGNORINI_FUZZ_SECONDS asks.
Deadline end_of_damage() {
  const char* const seconds = std::getenv("SIGNORINI_FUZZ_SECONDS");
  return Deadline::after(seconds == nullptr ? 0.0 : std::strtod(seconds, nullptr));
}

TEST_P(Corpus, DamagedIsReadAsPromised) {
  Damage damage(corpus_of(GetParam()));
  const Deadline end = end_of_damage();
  int copies = 0;
  for (; copies < kDamagedCopies || !end.passed(); ++copies) {
    const std::string text = damage.next();
    ASSERT_NO_THROW(GetParam().attack(text)) << "seed " << seed() << ", copy " << copies << ":\n" << text;
  }
  std::cout << GetParam().name << ": " << copies << " damaged copies, seed " << seed() << "\n";
}

INSTANTIATE_TEST_SUITE_P(Each, Corpus,
                         testing::ValuesIn(untrusted_readers().begin(), untrusted_readers().end()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace signorini::test::corpus_test
