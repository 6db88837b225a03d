#include "control/base64.h"

#include <gtest/gtest.h>

namespace arbiter::control {
namespace {

std::vector<std::uint8_t> bytesOf(std::string_view text) { return {text.begin(), text.end()}; }

// The values are from RFC 4648, section 10.
TEST(Base64, IsTheStandards) {
  EXPECT_EQ(toBase64(bytesOf("")), "");
  EXPECT_EQ(toBase64(bytesOf("f")), "Zg==");
  EXPECT_EQ(toBase64(bytesOf("fo")), "Zm8=");
  EXPECT_EQ(toBase64(bytesOf("foo")), "Zm9v");
  EXPECT_EQ(toBase64(bytesOf("foobar")), "Zm9vYmFy");
}

TEST(Base64, ComesBack) {
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(fromBase64(toBase64(bytes)), bytes);
    bytes.push_back(std::uint8_t(i * 37));
  }
}

TEST(Base64, RefusesWhatNoEncoderMakes) {
  for (const char *text : {"Z", "Zg=", "Zg", "Z===", "====", "Zg==Zg==", "Zm9v\n", "Zm9-",
                           "Zh==", "Zm9=", "=m9v", "Zm=v"})
    EXPECT_FALSE(fromBase64(text)) << text;
}

} // namespace
} // namespace arbiter::control
