#pragma once
#include "state/capabilities/host_faults.h"
#include "state/core/context.h"
#include "state/share/share_group.h"

/// Bitmaps that a host keeps for later (HostFault::KeptLetters): it draws them where its next draw
/// begins, with a program that is not current any more. They are drawn before that draw instead,
/// whatever came between. A bitmap behind others is kept with them.
namespace arbiter::state {

[[nodiscard]] inline bool keepsLetters(const Context &context) {
  return (context.caps.faults & bitOf(HostFault::KeptLetters)) != 0;
}

/// Notes that the host was given a bitmap, or compiled one into a list.
inline void noteLetters(Context &context) {
  if (!keepsLetters(context))
    return;
  if (context.listMode != GL_COMPILE)
    context.attention |= attention::kLetters;
  if (context.listMode != 0)
    context.group->listsHoldLetters.store(true, std::memory_order_relaxed);
}
/// Notes that lists were called, in which bitmaps may be.
inline void noteLettersOfLists(Context &context) {
  if (context.group->listsHoldLetters.load(std::memory_order_relaxed))
    context.attention |= attention::kLetters;
}
/// Makes the host draw what it keeps. Called before its next draw, where attention::kLetters is
/// set.
void drawKeptLetters(Context &context);

/// While it lives a command is prepared that leaves kept bitmaps where they are.
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
