#include "apps/builder/testing/fake_application.h"

#include <chrono>
#include <unistd.h>

#include "control/address.h"
#include "control/base64.h"

namespace arbiter::builder::testing {

using control::Json;

FakeApplication::FakeApplication() : m_before(qgetenv("XDG_RUNTIME_DIR")) {
  qputenv("XDG_RUNTIME_DIR", m_folder.path().toLocal8Bit());
  const auto folder = control::socketFolder();
  const std::string path =
      folder.value() + "/" + control::socketName(::getpid(), control::Kind::Layer);
  auto listening = control::listenAt(path);
  m_server = control::Server::listening(std::move(listening.value()), path);
  m_ring = control::FrameRing::make(kWidth, kHeight);
  m_thread = std::thread([this] { m_server->run(*this); });
}

FakeApplication::~FakeApplication() {
  end();
  qputenv("XDG_RUNTIME_DIR", m_before);
}

void FakeApplication::end() {
  if (!m_thread.joinable())
    return;
  m_server->stop();
  m_thread.join();
  m_server.reset();
}

std::string FakeApplication::edit() {
  const std::lock_guard lock(m_mutex);
  return m_edit;
}

double FakeApplication::value() {
  const std::lock_guard lock(m_mutex);
  return m_value;
}

int FakeApplication::count(const std::string &method) {
  const std::lock_guard lock(m_mutex);
  return int(m_methods.count(QString::fromStdString(method)));
}

void FakeApplication::connected(control::ClientId, pid_t) { ++m_clients; }

void FakeApplication::disconnected(control::ClientId) {
  --m_clients;
  const std::lock_guard lock(m_mutex);
  m_edit.clear();
  m_value = 0.25;
  m_held = false;
}

/// Lends a frame of one color.
void FakeApplication::lend(control::ClientId client) {
  const int slot = m_ring->take();
  if (slot < 0)
    return;
  const bool red = m_edit.find("red") != std::string::npos;
  for (int i = 0; i < kWidth * kHeight; ++i) {
    std::uint8_t *const pixel = m_ring->pixels(slot) + 4 * i;
    pixel[0] = red ? 255 : 0;
    pixel[1] = red ? 0 : 255;
    pixel[2] = pixel[3] = 0; // a window's alpha may have any value
  }
  m_server->send(client,
                 control::eventLine("frame", {{"serial", 1}, {"slot", slot}, {"number", 1}}));
}

control::Answer FakeApplication::setText(control::Params &params) {
  const std::string text = params.text("text");
  const bool wrong = text.find("wrong") != std::string::npos;
  if (!wrong)
    m_edit = text;
  Json diagnostics = Json::array();
  if (wrong)
    diagnostics.push_back({{"severity", "error"},
                           {"message", "it is wrong"},
                           {"hint", "mend it"},
                           {"begin", text.find("wrong")},
                           {"end", text.find("wrong") + 5},
                           {"line", 2},
                           {"column", 1}});
  return Json{{"ok", !wrong}, {"revision", 1}, {"diagnostics", diagnostics}};
}

control::Answer FakeApplication::answer(control::ClientId client, const control::Request &request) {
  control::Params params(request.params);
  const std::string &method = request.method;
  if (method == "frame.want") {
    m_server->send(client, control::bufferLine(m_ring->layout(), 1), m_ring->share());
    lend(client);
    return Json::object();
  }
  if (method == "frame.release")
    return Json(m_ring->giveBack(int(params.integer("slot", 0, 2))));
  if (method == "program.list") {
    lend(client); // as if a frame had ended
    return Json{{"programs",
                 {{{"id", kProgram},
                   {"target", "fragment"},
                   {"effective", true},
                   {"edited", !m_edit.empty()},
                   {"draws", 10},
                   {"rasterizer_draws", 4},
                   {"milliseconds", 2.5}},
                  {{"id", "../../evil"}, {"target", "vertex"}, {"draws", 0}}}}};
  }
  if (method == "program.get")
    return Json{{"id", kProgram},
                {"text", kText},
                {"revision", 7},
                {"edit", m_edit.empty() ? Json() : Json(m_edit)}};
  if (method == "program.set")
    return setText(params);
  if (method == "program.reset") {
    m_edit.clear();
    return Json{{"count", 1}};
  }
  if (method == "param.list")
    return Json{{"parameters",
                 {{{"id", kProgram},
                   {"name", "program.local[0]"},
                   {"kind", "local"},
                   {"value", {m_value, 0, 0, 1}},
                   {"held", m_held}},
                  {{"id", kProgram},
                   {"name", "state.fog.color"},
                   {"kind", "state"},
                   {"value", {0, 0, 0, 0}},
                   {"held", false}}}}};
  if (method == "param.set") {
    float value[4] = {};
    params.floats("value", value, 4);
    m_value = double(value[0]);
    m_held = true;
    return Json::object();
  }
  if (method == "param.reset") {
    m_value = 0.25;
    m_held = false;
    return Json{{"count", 1}};
  }
  if (method == "texture.list")
    return Json{{"textures",
                 {{{"name", 5},
                   {"unit", 0},
                   {"target", "2D"},
                   {"width", 16},
                   {"height", 16},
                   {"depth", 1},
                   {"format", "RGBA8"}}}}};
  if (method == "texture.get") {
    const std::vector<std::uint8_t> bytes = {255, 0, 0, 255, 0, 0, 255, 255}; // bottom row first
    return Json{{"name", 5},
                {"image", {{"width", 1}, {"height", 2}, {"rgba", control::toBase64(bytes)}}}};
  }
  if (method == "frame.measure")
    return Json{{"programs", {{kProgram, {{"draws", 1}, {"pixels", 8}, {"milliseconds", 0.5}}}}}};
  return Json::object();
}

void FakeApplication::received(control::ClientId client, control::Request request) {
  if (request.method == "program.set" && m_delay != 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(m_delay.load()));
  const std::lock_guard lock(m_mutex);
  m_methods << QString::fromStdString(request.method);
  const control::Answer answered = answer(client, request);
  if (request.wantsAnswer)
    m_server->send(client, control::answerLine(request.id, answered));
}

} // namespace arbiter::builder::testing
