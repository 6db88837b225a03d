#include "control/message.h"

#include <gtest/gtest.h>
#include <random>

namespace arbiter::control {
namespace {

std::string nested(int depth) {
  return std::string(std::size_t(depth), '[') + std::string(std::size_t(depth), ']');
}

Result<Request, Fault> requestOf(std::string_view line) {
  Result<Json, Fault> message = parseMessage(line);
  if (!message)
    return message.error();
  Json id;
  return toRequest(std::move(message.value()), id);
}

TEST(Message, HasLimits) {
  EXPECT_TRUE(parseMessage(nested(kMaxDepth)));
  EXPECT_EQ(parseMessage(nested(kMaxDepth + 1)).error().code, kNoRequest);
  EXPECT_EQ(parseMessage(nested(1'000'000)).error().code, kNoRequest);
  EXPECT_TRUE(parseMessage("\"" + nested(100) + "\"")) << "brackets in a text nest nothing";
  EXPECT_EQ(parseMessage(std::string(kMaxLineBytes, ' ')).error().code, kNoRequest);
  std::string many = "[0";
  for (std::size_t i = 0; i < kMaxValues; ++i)
    many += ",0";
  EXPECT_EQ(parseMessage(many + "]").error().code, kNoRequest);
}

TEST(Message, IsARequestOrSaysWhyNot) {
  const auto good = requestOf(R"({"jsonrpc":"2.0","id":"x","method":"ping"})");
  ASSERT_TRUE(good);
  EXPECT_EQ(good.value().method, "ping");
  EXPECT_TRUE(good.value().wantsAnswer);
  EXPECT_TRUE(good.value().params.is_object());
  EXPECT_FALSE(requestOf(R"({"jsonrpc":"2.0","method":"ping"})").value().wantsAnswer);
  EXPECT_EQ(requestOf("{").error().code, kNoJson);
  EXPECT_EQ(requestOf("\xff").error().code, kNoJson);
  EXPECT_EQ(requestOf("").error().code, kNoJson);
  for (const char *wrong :
       {"[]", "1", "null", R"({"method":"ping"})", R"({"jsonrpc":"1.0","method":"ping"})",
        R"({"jsonrpc":"2.0","method":7})", R"({"jsonrpc":"2.0"})",
        R"({"jsonrpc":"2.0","method":"ping","params":[]})",
        R"({"jsonrpc":"2.0","method":"ping","id":{}})"})
    EXPECT_EQ(requestOf(wrong).error().code, kNoRequest) << wrong;
}

TEST(Message, IsOneLineOfUtf8) {
  const std::string line =
      answerLine(1, Answer(Json::object({{"text", "a\nb\xff"}, {"path", "\xc3\xa9"}})));
  EXPECT_EQ(line.find('\n'), line.size() - 1);
  const Json back = Json::parse(line);
  EXPECT_EQ(back["result"]["text"], "a\nb\xef\xbf\xbd");
  EXPECT_EQ(back["result"]["path"], "\xc3\xa9");
}

TEST(Params, NamesWhatIsWrong) {
  const Json object = Json::parse(
      R"({"text":"a","number":1.5,"large":18446744073709551615,"list":[1,2],"far":[1e300,0],
          "holes":[null,3],"yes":true})");
  const auto faultOf = [&](auto read) {
    Params params(object);
    read(params);
    return params.ok() ? std::string() : params.fault().message;
  };
  EXPECT_EQ(faultOf([](Params &p) { (void)p.text("text"); }), "");
  EXPECT_NE(faultOf([](Params &p) { (void)p.text("number"); }).find("\"number\""),
            std::string::npos);
  EXPECT_NE(faultOf([](Params &p) { (void)p.text("none"); }), "");
  EXPECT_NE(faultOf([](Params &p) { (void)p.integer("number", 0, 9); }), "");
  EXPECT_NE(faultOf([](Params &p) { (void)p.integer("large", INT64_MIN, INT64_MAX); }), "");
  EXPECT_NE(faultOf([](Params &p) { (void)p.truth("text"); }), "");
  EXPECT_EQ(faultOf([](Params &p) { (void)p.truth("yes"); }), "");
  float values[2] = {7, 7};
  EXPECT_EQ(faultOf([&](Params &p) { p.floats("list", values, 2); }), "");
  EXPECT_EQ(values[1], 2);
  EXPECT_NE(faultOf([&](Params &p) { p.floats("list", values, 3); }), "");
  EXPECT_NE(faultOf([&](Params &p) { p.floats("far", values, 2); }), "");
  EXPECT_NE(faultOf([&](Params &p) { p.floats("holes", values, 2); }), "");
  EXPECT_EQ(faultOf([&](Params &p) { p.floats("holes", values, 2, true); }), "");
}

/// Any bytes are read as JSON, a request or a fault: nothing throws or crashes.
TEST(Message, SurvivesAnyBytes) {
  std::mt19937 random(1);
  const std::string alphabet = "{}[]\",:0123456789.eE+-\\utfnaslr\x01\xff jsonrpc2.0methodid";
  const std::string seed = R"({"jsonrpc":"2.0","id":1,"method":"program.set","params":{"id":"a"}})";
  for (int i = 0; i < 10000; ++i) {
    std::string text = i % 2 == 0 ? seed : std::string();
    for (std::size_t edits = random() % 12; edits > 0; --edits) {
      const char byte = alphabet[random() % alphabet.size()];
      const std::size_t at = text.empty() ? 0 : random() % text.size();
      if (random() % 2 == 0)
        text.insert(at, 1, byte);
      else if (!text.empty())
        text[at] = byte;
    }
    const auto request = requestOf(text);
    EXPECT_TRUE(request || request.error().code == kNoJson || request.error().code == kNoRequest);
  }
}

} // namespace
} // namespace arbiter::control
