#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "harness/report/page/page_shell.hpp"

namespace signorini::packed_test {
namespace {

TEST(Base64, IsThatOfTheStandard) {
  // RFC 4648, section 10.
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Packed, IsTheStreamOfZlibWithoutAByteOfTheText) {
  // Written by Python: base64.b64encode(zlib.compress(b"</script>" * 3, 9)).
  EXPECT_EQ(packed("</script></script></script>"), "eNqz0S9OLsosKLGzwWAAAIXCCbs=");
}

TEST(Packed, MakesTextThatRepeatsItselfShort) {
  const std::string text(100000, 'a');
  EXPECT_LT(packed(text).size(), text.size() / 100);
}

TEST(ScriptSource, NamesAScriptByItsDigest) {
  // openssl dgst -sha256 -binary | base64 of the same text.
  EXPECT_EQ(script_source("alert('Hello, world.');"),
            "'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng='");
}

}  // namespace
}  // namespace signorini::packed_test
