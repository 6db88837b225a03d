#pragma once
#include <chrono>
#include <span>

#include "apps/tools/render/player.h"
#include "apps/tools/render/service.h"

namespace arbiter::tools {

/// Returns the methods that the drawing thread answers.
[[nodiscard]] std::span<const char *const> renderMethods();

/// Draws for clients until they have gone.
class RenderLoop {
public:
  RenderLoop(RenderService &service, std::string folder)
      : m_service(service), m_player(std::move(folder)) {}
  void run();

private:
  using Clock = std::chrono::steady_clock;
  struct Row {
    const char *name;
    control::Answer (RenderLoop::*answer)(const RenderService::Waiting &, control::Params &);
  };
  friend std::span<const char *const> renderMethods();
  static std::span<const Row> rows();

  [[nodiscard]] control::Answer answerTo(const RenderService::Waiting &waiting);
  control::Answer set(const RenderService::Waiting &waiting, control::Params &params);
  control::Answer param(const RenderService::Waiting &waiting, control::Params &params);
  control::Answer pause(const RenderService::Waiting &waiting, control::Params &params);
  control::Answer step(const RenderService::Waiting &waiting, control::Params &params);
  control::Answer time(const RenderService::Waiting &waiting, control::Params &params);
  control::Answer steps(const RenderService::Waiting &waiting, control::Params &params);
  control::Answer frame(const RenderService::Waiting &waiting, control::Params &params);
  control::Answer size(const RenderService::Waiting &waiting, control::Params &params);
  control::Answer camera(const RenderService::Waiting &waiting, control::Params &params);
  control::Answer bench(const RenderService::Waiting &waiting, control::Params &params);
  control::Answer want(const RenderService::Waiting &waiting, control::Params &params);

  [[nodiscard]] bool plays() const { return !m_paused && m_player.isAnimated(); }
  void drawFrame();

  RenderService &m_service;
  Player m_player;
  bool m_paused = false;
  bool m_changed = false; ///< true if a frame must be drawn
  std::int64_t m_number = 0;
  double m_milliseconds = 0; ///< time of the last frame
  Clock::time_point m_next;  ///< time of the next frame while the document plays
};

} // namespace arbiter::tools
