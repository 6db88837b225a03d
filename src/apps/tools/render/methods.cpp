#include "apps/tools/render/methods.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace arbiter::tools {

namespace {

using control::Fault;
using control::Json;
using control::Params;

constexpr int kMaxSide = 4096;

Fault noScene() { return {control::kNotPossible, "there is no document yet", {}}; }

} // namespace

std::span<const RenderLoop::Row> RenderLoop::rows() {
  static constexpr Row kRows[] = {
      {"scene.set", &RenderLoop::set},     {"scene.param", &RenderLoop::param},
      {"scene.pause", &RenderLoop::pause}, {"scene.step", &RenderLoop::step},
      {"scene.time", &RenderLoop::time},   {"scene.frame", &RenderLoop::frame},
      {"scene.size", &RenderLoop::size},   {"scene.camera", &RenderLoop::camera},
      {"scene.bench", &RenderLoop::bench}, {"scene.steps", &RenderLoop::steps},
      {"frame.want", &RenderLoop::want},
  };
  return kRows;
}

std::span<const char *const> renderMethods() {
  static const std::vector<const char *> s_names = [] {
    std::vector<const char *> names;
    for (const auto &row : RenderLoop::rows())
      names.push_back(row.name);
    return names;
  }();
  return s_names;
}

control::Answer RenderLoop::answerTo(const RenderService::Waiting &waiting) {
  Params params(waiting.request.params);
  for (const Row &row : rows())
    if (waiting.request.method == row.name)
      return (this->*row.answer)(waiting, params);
  return Fault{control::kNoMethod, "there is no such method", {}};
}

void RenderLoop::run() {
  while (!m_service.isOver()) {
    std::optional<Clock::time_point> until;
    if (m_changed)
      until = Clock::now();
    else if (plays())
      until = m_next;
    if (const auto waiting = m_service.next(until)) {
      m_service.answer(*waiting, answerTo(*waiting));
      continue; // answer all waiting requests before drawing a frame
    }
    if (m_service.isOver() || !m_player.hasScene())
      m_changed = false;
    else if (m_changed || (plays() && Clock::now() >= m_next))
      drawFrame();
  }
}

void RenderLoop::drawFrame() {
  const bool moves = plays() && !m_changed;
  m_next = Clock::now() +
           std::chrono::microseconds(std::int64_t(1e6 / std::max(m_player.framesPerSecond(), 1.0)));
  // An animation without viewers does not advance.
  if (moves && !m_service.wantsFrame(m_player.width(), m_player.height()))
    return;
  if (moves)
    m_player.advance(1);
  m_changed = false;
  m_service.setAtWork(m_player.revision());
  std::uint8_t *const pixels = m_service.beginFrame(m_player.width(), m_player.height());
  m_milliseconds = m_player.draw(pixels);
  m_service.setIdle();
  ++m_number;
  m_service.noteFrame(m_number, m_player.revision());
  Json frame = Json::object({{"number", m_number},
                             {"revision", m_player.revision()},
                             {"time", m_player.seconds()},
                             {"milliseconds", m_milliseconds}});
  if (m_player.hasFeedback())
    frame["steps"] = m_player.steps();
  m_service.lend(std::move(frame));
}

control::Answer RenderLoop::set(const RenderService::Waiting &, Params &params) {
  Player::Text text;
  text.text = params.text("text");
  text.name = params.text("name", "document.fp");
  text.revision = params.integer("revision", 0, INT64_MAX);
  if (const Json *const files = params.object("files"))
    for (const auto &[name, content] : files->items()) {
      if (!content.is_string())
        params.refuse("files", "has texts by name");
      else
        text.files[name] = content.get<std::string>();
    }
  if (text.name.empty() || text.name.find('/') != std::string::npos)
    params.refuse("name", "is a file's name, without a folder");
  if (!params.ok())
    return params.fault();
  m_service.setAtWork(text.revision);
  Json answer = m_player.set(text);
  m_service.setIdle();
  if (answer["ok"] == true) {
    drawFrame();
    answer["frame_milliseconds"] = m_milliseconds;
  }
  return answer;
}

control::Answer RenderLoop::param(const RenderService::Waiting &, Params &params) {
  constexpr std::size_t kMaxPass = 16;
  Player::ParameterValue value;
  const std::string stage = params.text("stage"), kind = params.text("kind");
  value.vertex = stage == "vertex";
  if (!value.vertex && stage != "fragment")
    params.refuse("stage", "is fragment or vertex");
  value.space = kind == "env"      ? scene::Setting::Env
                : kind == "attrib" ? scene::Setting::Attrib
                                   : scene::Setting::Local;
  if (kind != "local" && kind != "env" && kind != "attrib")
    params.refuse("kind", "is local, env or attrib");
  value.index = unsigned(params.integer("index", 0, scene::kMaxParameters - 1));
  value.pass = std::size_t(params.integer("pass", 0, kMaxPass, 0));
  std::array<float, 4> numbers;
  numbers.fill(std::nanf("")); // marks missing numbers
  params.floats("value", numbers.data(), numbers.size(), true);
  if (!params.ok())
    return params.fault();
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!std::isnan(numbers[i]))
      value.value[i] = numbers[i];
  if (!m_player.setParameter(value))
    return Fault{control::kUnknownName, "the document has no such program", {}};
  m_changed = true;
  return Json::object();
}

control::Answer RenderLoop::pause(const RenderService::Waiting &, Params &params) {
  const bool paused = params.truth("paused");
  if (!params.ok())
    return params.fault();
  m_paused = paused;
  m_next = Clock::now();
  return Json::object({{"paused", m_paused}});
}

control::Answer RenderLoop::step(const RenderService::Waiting &, Params &params) {
  constexpr double kMax = 3600;
  const double seconds = params.number("seconds", 0);
  if (!params.ok() || seconds < 0 || seconds > kMax) {
    params.refuse("seconds", "is a number from 0 to 3600");
    return params.fault();
  }
  if (!m_player.hasScene())
    return noScene();
  // Feedback needs every frame in between.
  const int frames = std::max(1, int(std::lround(seconds * m_player.framesPerSecond())));
  for (int i = 1; i < frames && m_player.isAnimated(); ++i) {
    m_player.advance(1);
    (void)m_player.draw(nullptr);
  }
  m_player.advance(1);
  m_changed = true;
  drawFrame();
  return Json::object({{"number", m_number}, {"time", m_player.seconds()}});
}

control::Answer RenderLoop::time(const RenderService::Waiting &, Params &params) {
  const double seconds = params.number("seconds", 0);
  if (!params.ok())
    return params.fault();
  m_player.setSeconds(seconds);
  m_changed = true;
  return Json::object();
}

control::Answer RenderLoop::steps(const RenderService::Waiting &, Params &params) {
  constexpr std::chrono::milliseconds kMax{200}; // a limit, so that other requests need not wait
                                                 // longer
  const int wanted = int(params.integer("steps", 1, 1'000'000'000));
  if (!params.ok())
    return params.fault();
  if (!m_player.hasScene())
    return noScene();
  if (!m_player.hasFeedback())
    return Fault{
        control::kNotPossible, "the document has no feedback: scene.time says when it is", {}};
  if (!m_player.approachStep(wanted, Clock::now() + kMax))
    return Fault{control::kNotPossible, "GL has no room to begin the document anew", {}};
  drawFrame();
  return Json::object({{"steps", m_player.steps()}, {"time", m_player.seconds()}});
}

control::Answer RenderLoop::frame(const RenderService::Waiting &, Params &) {
  if (!m_player.hasScene())
    return noScene();
  m_changed = true;
  drawFrame();
  return Json::object(
      {{"number", m_number}, {"time", m_player.seconds()}, {"milliseconds", m_milliseconds}});
}

control::Answer RenderLoop::size(const RenderService::Waiting &, Params &params) {
  const int width = int(params.integer("width", 0, kMaxSide, 0));
  const int height = int(params.integer("height", 0, kMaxSide, 0));
  if (params.ok() && (width == 0) != (height == 0))
    params.refuse("height", "is 0 where width is");
  if (!params.ok())
    return params.fault();
  if (!m_player.setSize(width, height))
    return Fault{control::kNotPossible, "the document cannot be drawn in this size", {}};
  m_changed = true;
  return Json::object();
}

control::Answer RenderLoop::camera(const RenderService::Waiting &, Params &params) {
  std::optional<Player::Orbit> orbit;
  if (params.has("yaw") || params.has("pitch") || params.has("distance"))
    orbit = Player::Orbit{params.number("yaw", 0), params.number("pitch", 0),
                          params.number("distance", 1)};
  if (!params.ok())
    return params.fault();
  m_player.setCamera(orbit);
  m_changed = true;
  return Json::object();
}

control::Answer RenderLoop::bench(const RenderService::Waiting &, Params &params) {
  const int frames = int(params.integer("frames", 1, 100000));
  if (!params.ok())
    return params.fault();
  if (!m_player.hasScene())
    return noScene();
  constexpr std::chrono::seconds kMax{10};
  const Clock::time_point begin = Clock::now();
  std::vector<double> times;
  while (int(times.size()) < frames && Clock::now() - begin < kMax)
    times.push_back(m_player.draw(nullptr));
  const std::chrono::duration<double, std::milli> took = Clock::now() - begin;
  std::sort(times.begin(), times.end());
  m_changed = true;
  return Json::object({{"frames", times.size()},
                       {"milliseconds", took.count()},
                       {"median", times[times.size() / 2]}});
}

control::Answer RenderLoop::want(const RenderService::Waiting &waiting, Params &params) {
  const auto every = std::uint32_t(params.integer("every", 0, 1'000'000, 1));
  if (!params.ok())
    return params.fault();
  m_service.wantFrames(waiting.client, every);
  m_changed = every != 0;
  return Json::object();
}

} // namespace arbiter::tools
