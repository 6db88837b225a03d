#pragma once
#include "state/capabilities/host_faults.h"
#include "state/host_draw/draw_context.h"
#include "state/share/share_group.h"

/// Works around bitmaps that a host keeps for later (HostFault::KeptLetters). The host draws them
/// when its next draw begins, with a program that may no longer be current. The layer has them
/// drawn before that draw, whatever came in between. Consecutive bitmaps are kept together.
namespace arbiter::state {

[[nodiscard]] inline bool keepsLetters(const DrawContext &context) {
  return (context.caps.faults & bitOf(HostFault::KeptLetters)) != 0;
}

/// Notes that the host was given a bitmap, or compiled one into a list.
inline void noteLetters(DrawContext &context) {
  if (!keepsLetters(context))
    return;
  if (context.listMode != GL_COMPILE)
    context.attention |= attention::kLetters;
  if (context.listMode != 0)
    context.group->listsHoldLetters.store(true, std::memory_order_relaxed);
}
/// Notes that lists were called, which may contain bitmaps.
inline void noteLettersOfLists(DrawContext &context) {
  if (context.group->listsHoldLetters.load(std::memory_order_relaxed))
    context.attention |= attention::kLetters;
}
/// Makes the host draw the bitmaps that it keeps. Called before the host's next draw if
/// attention::kLetters is set.
void drawKeptLetters(DrawContext &context);

/// While it lives, a command is prepared that must not draw kept bitmaps.
class LettersStay {
public:
  explicit LettersStay(ContextHot &context)
      : m_context(context), m_kept(context.attention & attention::kLetters) {
    m_context.attention &= ~attention::kLetters;
  }
  ~LettersStay() { m_context.attention |= m_kept; }
  LettersStay(const LettersStay &) = delete;
  LettersStay &operator=(const LettersStay &) = delete;

private:
  ContextHot &m_context;
  const std::uint32_t m_kept;
};

} // namespace arbiter::state
