#include <csignal>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/tools/debug/drawn_by.h"
#include "apps/tools/debug/draws/client.h"
#include "apps/tools/debug/draws/server.h"
#include "apps/tools/debug/testing/fake_drawer.h"
#include "control/attached.h"
#include "control/server.h"

namespace arbiter::tools::debug {
namespace {

using testing::HasSubstr;

constexpr const char *kText = "!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n";

/// Starts a process that draws with the fake drawer, and returns its client.
std::unique_ptr<DrawClient> started() {
  auto client = DrawClient::start("another", [] {
    return serveDraws(
        0, [](const control::Json &what) -> Result<std::unique_ptr<Drawer>, DebugError> {
          if (!what["text"].is_string())
            return DebugError{"what is no text", true};
          return std::unique_ptr<Drawer>(new FakeDrawer(what["text"].get<std::string>(), 5, 3));
        });
  });
  return std::move(client).value();
}

/// Gives one answer after the other to any requests.
class Nonsense final : public control::Service {
public:
  explicit Nonsense(control::Server &server) : m_server(server) {}
  void connected(control::ClientId, pid_t) override {}
  void disconnected(control::ClientId) override {}
  void received(control::ClientId client, control::Request request) override {
    const std::vector<std::uint8_t> three(3);
    m_server.send(client, control::answerLine(request.id, m_answers[m_at]),
                  m_at == 1 ? control::memoryOf(three) : control::Descriptor());
    ++m_at;
  }

private:
  control::Server &m_server;
  const std::array<control::Json, 4> m_answers = {
      control::Json::array({1}), control::Json::object(), {{"bytes", "x"}}, {{"width", "x"}}};
  std::size_t m_at = 0;
};

TEST(Draws, WhatTheOtherProcessDrawsComesBack) {
  const auto client = started();
  ASSERT_FALSE(client->open({{"text", kText}}));
  EXPECT_EQ(client->size(), (std::array<int, 2>{5, 3}));
  FakeDrawer here(kText, 5, 3);
  const Region region{1, 0, 4, 3};
  const std::string text =
      "!!ARBfp1.0\nOPTION ARB_draw_buffers;\nMOV result.color[0], fragment.color;\n"
      "RCP result.color[1], fragment.texcoord[0].z;\nEND\n";
  const auto there = client->draw(text, 2, region);
  ASSERT_TRUE(there) << there.error().message;
  EXPECT_EQ(there.value(), here.draw(text, 2, region).value());
  EXPECT_EQ(client->picture(region).value(), here.picture(region).value());
  EXPECT_EQ(client->textureSize(0, fp::ir::TexTarget::Tex2D).value(),
            (std::array<int, 3>{64, 32, 1}));
}

TEST(Draws, WrongRequestsAreErrors) {
  const auto client = started();
  EXPECT_THAT(client->draw(kText, 1, {}).error().message, HasSubstr("nothing is open"));
  EXPECT_THAT(client->open({{"text", 7}})->message, HasSubstr("no text"));
  EXPECT_TRUE(client->open({{"text", 7}})->isOfUsage);
  ASSERT_FALSE(client->open({{"text", kText}}));
  for (const Region &region : {Region{5, 0, 1, 1}, {0, 0, 6, 1}, {-1, 0, 1, 1}, {0, 0, 0, 1}})
    EXPECT_THAT(client->draw(kText, 1, region).error().message, HasSubstr("outside the picture"));
  EXPECT_THAT(client->draw(kText, 5, {}).error().message, HasSubstr("targets"));
  EXPECT_THAT(client->draw("!!ARBfp1.0\nMOV result.color, q;\nEND\n", 1, {}).error().message,
              HasSubstr("'q'"));
  EXPECT_TRUE(client->draw(kText, 1, {})) << "it goes on after errors";
}

TEST(Draws, AProcessThatDiesIsNamed) {
  auto client = DrawClient::start("swrast", [] { return ::raise(SIGABRT); });
  ASSERT_TRUE(client);
  const auto error = client.value()->open(control::Json::object());
  ASSERT_TRUE(error);
  EXPECT_THAT(error->message, HasSubstr("swrast"));
  EXPECT_THAT(error->message, HasSubstr("signal 6"));
  EXPECT_THAT(client.value()->draw(kText, 1, {}).error().message, HasSubstr("gone"));
}

TEST(Draws, AnAnswerThatIsNonsenseIsAnError) {
  auto client = DrawClient::start("odd", [] {
    const auto server = control::Server::connected(control::Descriptor(0));
    Nonsense service(*server);
    server->run(service);
    return 0;
  });
  EXPECT_THAT(client.value()->open(control::Json::object())->message, HasSubstr("nonsense"));
  EXPECT_THAT(client.value()->draw(kText, 1, {}).error().message, HasSubstr("number of pixels"));
  EXPECT_THAT(client.value()->draw(kText, 1, {}).error().message, HasSubstr("number of pixels"));
  EXPECT_THAT(client.value()->open(control::Json::object())->message, HasSubstr("no picture"));
}

TEST(DrawnBy, SaysWhatTheRasterizerLeft) {
  EXPECT_EQ(drawnByNote(R"({"draws": {"rasterizer": 5, "host_glsl": 0}})"), "");
  EXPECT_EQ(
      drawnByNote(R"({"draws": {"rasterizer": 2, "host_glsl": 3, "reasons": {"no_program": 1}},
                      "software": {"given_to_host": {"target": 3}}})"),
      "the rasterizer left 3 of 5 draws to the host: target");
  for (const char *text : {"", "[]", "{}", R"({"draws": 7})", R"({"draws": {"host_glsl": "x"}})"})
    EXPECT_EQ(drawnByNote(text), "") << text;
}

} // namespace
} // namespace arbiter::tools::debug
