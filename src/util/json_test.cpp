#include "util/json.h"

#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "util/hash.h"
#include "util/suggest.h"

namespace arbiter {
namespace {

// nlohmann's parser judges the output independently.
TEST(JsonWriter, IsReadBackByAParser) {
  JsonWriter json;
  json.beginObject().key("schema").value(1).key("big").value(std::uint64_t(1) << 63);
  json.key("list").beginArray().value("a\"\\\n\t\x01").value(true).value(-0.5).null().endArray();
  json.key("none").beginObject().endObject().key("empty").beginArray().endArray().endObject();
  const auto read = nlohmann::json::parse(json.take());
  EXPECT_EQ(read["schema"], 1);
  EXPECT_EQ(read["big"], std::uint64_t(1) << 63);
  EXPECT_EQ(read["list"], nlohmann::json::array({"a\"\\\n\t\x01", true, -0.5, nullptr}));
  EXPECT_TRUE(read["none"].is_object());
  EXPECT_TRUE(read["empty"].is_array());
}

TEST(JsonWriter, AnyBytesGiveValidUtf8) {
  for (int first = 0; first < 256; ++first) {
    for (const char *tail : {"", "\x80", "\xC0\x80", "\xA0\x80\x80", "\x90\x80\x80", "z"}) {
      JsonWriter json;
      json.value(std::string(1, char(first)) + tail);
      EXPECT_TRUE(nlohmann::json::accept(json.take())) << first;
    }
  }
}

TEST(JsonWriter, KeepsGoodUtf8AndReplacesBad) {
  JsonWriter json;
  json.beginArray().value("\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80").value("a\xFFz").endArray();
  const auto read = nlohmann::json::parse(json.take());
  EXPECT_EQ(read[0], "\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80");
  EXPECT_EQ(read[1], "a\xEF\xBF\xBDz");
}

TEST(IsUtf8, HoldsToTheTable) {
  for (const char *good : {"", "a.fp", "\xC3\xBC", "\xE2\x96\x88", "\xF0\x9F\x98\x80"})
    EXPECT_TRUE(isUtf8(good)) << good;
  for (const char *bad : {"\xFF", "a\xC3", "\xC0\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80"})
    EXPECT_FALSE(isUtf8(bad)) << bad;
}

TEST(JsonWriter, NumbersThatJsonLacksBecomeNull) {
  JsonWriter json;
  json.beginArray().value(std::numeric_limits<double>::infinity()).value(0.1).endArray();
  const auto read = nlohmann::json::parse(json.take());
  EXPECT_TRUE(read[0].is_null());
  EXPECT_EQ(read[1], 0.1);
}

TEST(Closest, FindsTheNameMeant) {
  const std::string_view names[] = {"r300", "r420", "nv30", "i915", "host", "r300-catalyst-2004"};
  EXPECT_EQ(nearest("r30", names), "r300");
  EXPECT_EQ(nearest("vn30", names), "nv30");
  EXPECT_EQ(nearest("r300-catalist", names), "r300-catalyst-2004");
  EXPECT_EQ(nearest("geforce", names), "");
  EXPECT_EQ(nearest("", names), "");
  EXPECT_EQ(nearest(std::string(100, 'r'), names), "");
}

// The published XXH3-128 value of the empty input. A changed hash would rename every program.
TEST(Hash, IsXxh3) {
  EXPECT_EQ(toHex(hashBytes("")), "99aa06d3014798d86001c324468d497f");
  EXPECT_NE(hashBytes("a"), hashBytes("b"));
}

} // namespace
} // namespace arbiter
