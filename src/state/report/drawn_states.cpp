#include "state/report/drawn_states.h"

#include <utility>

#include "state/objects/target.h"

namespace arbiter::state {

DrawnStates &DrawnStates::instance() {
  static auto *const s_states = new DrawnStates;
  return *s_states;
}

bool DrawnStates::note(std::shared_ptr<const CompiledProgram> state) {
  std::string name = textFileName(state->target, state->hash);
  const std::lock_guard lock(m_mutex);
  if (m_states.size() >= kMax && m_states.count(name) == 0)
    m_states.clear();
  return m_states.insert_or_assign(std::move(name), std::move(state)).second;
}

std::map<std::string, std::shared_ptr<const CompiledProgram>> DrawnStates::all() {
  const std::lock_guard lock(m_mutex);
  return m_states;
}

} // namespace arbiter::state
