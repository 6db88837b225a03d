#include "state/programs/program_edits.h"

#include <algorithm>
#include <sys/auxv.h>
#include <utility>

#include "state/programs/program_context.h"
#include "state/share/share_group.h"
#include "util/flags.h"

namespace arbiter::state {

bool controlAllowed() { return settings().control && getauxval(AT_SECURE) == 0; }

ProgramEdits &ProgramEdits::instance() {
  static auto *const s_edits = new ProgramEdits;
  return *s_edits;
}

/// Requires the lock.
void ProgramEdits::changed() {
  m_anyHeld.store(!m_held.empty(), std::memory_order_relaxed);
  m_anyOff.store(
      std::any_of(m_edits.begin(), m_edits.end(), [](const auto &each) { return each.second.off; }),
      std::memory_order_relaxed);
  m_generation.fetch_add(1, std::memory_order_release);
}

void ProgramEdits::changed(Edit &edit) {
  edit.changed = m_generation.load(std::memory_order_relaxed) + 1;
  changed();
}

bool ProgramEdits::changedSince(const std::string &name, std::uint64_t generation) {
  const std::lock_guard lock(m_mutex);
  const auto it = m_edits.find(name);
  return it != m_edits.end() && it->second.changed > generation;
}

void ProgramEdits::setText(const std::string &name, std::string text) {
  const std::lock_guard lock(m_mutex);
  Edit &edit = m_edits[name];
  edit.text = std::move(text);
  edit.hasText = true;
  changed(edit);
}

bool ProgramEdits::resetText(const std::string &name) {
  const std::lock_guard lock(m_mutex);
  const auto it = m_edits.find(name);
  if (it == m_edits.end() || !it->second.hasText)
    return false;
  it->second.text.clear();
  it->second.hasText = false;
  changed(it->second);
  return true;
}

std::size_t ProgramEdits::resetTexts() {
  const std::lock_guard lock(m_mutex);
  std::size_t count = 0;
  for (auto &[name, edit] : m_edits) {
    if (!edit.hasText)
      continue;
    edit.text.clear();
    edit.hasText = false;
    changed(edit);
    ++count;
  }
  return count;
}

bool ProgramEdits::text(const std::string &name, std::string &text) {
  const std::lock_guard lock(m_mutex);
  const auto it = m_edits.find(name);
  if (it == m_edits.end() || !it->second.hasText)
    return false;
  text = it->second.text;
  return true;
}

void ProgramEdits::setEnabled(const std::string &name, bool enabled) {
  const std::lock_guard lock(m_mutex);
  Edit &edit = m_edits[name];
  if (edit.off == !enabled)
    return;
  edit.off = !enabled;
  changed(edit);
}

bool ProgramEdits::isOff(const std::string &name) {
  const std::lock_guard lock(m_mutex);
  const auto it = m_edits.find(name);
  return it != m_edits.end() && it->second.off;
}

void ProgramEdits::hold(HeldValue value) {
  const std::lock_guard lock(m_mutex);
  const auto same = [&](const HeldValue &other) {
    return other.target == value.target && other.env == value.env && other.index == value.index &&
           other.program == value.program;
  };
  const auto it = std::find_if(m_held.begin(), m_held.end(), same);
  if (it == m_held.end())
    m_held.push_back(std::move(value));
  else
    it->value = value.value;
  changed();
}

std::optional<Vec4> ProgramEdits::held(Target target, bool env, std::uint32_t index,
                                       const Hash128 &hash) {
  const std::lock_guard lock(m_mutex);
  for (const HeldValue &value : m_held)
    if (value.target == target && value.env == env && value.index == index &&
        (env || value.hash == hash))
      return value.value;
  return std::nullopt;
}

std::uint64_t ProgramEdits::seenBy(const ProgramContext &context, std::uint64_t now) {
  const std::lock_guard lock(m_mutex);
  return std::exchange(m_seen[context.serial], now);
}

void ProgramEdits::clear() {
  const std::lock_guard lock(m_mutex);
  for (auto &[name, edit] : m_edits) {
    if (!edit.hasText && !edit.off)
      continue;
    edit.text.clear();
    edit.hasText = edit.off = false;
    changed(edit);
  }
  if (!m_held.empty()) {
    m_held.clear();
    changed();
  }
}

void ProgramEdits::noteLoad(const std::string &name) {
  constexpr std::size_t kMax = 1000;
  if (!m_watchesLoads.load(std::memory_order_relaxed))
    return;
  const std::lock_guard lock(m_mutex);
  if (m_loads.size() < kMax)
    m_loads.push_back(name);
}

std::vector<std::string> ProgramEdits::takeLoads() {
  const std::lock_guard lock(m_mutex);
  return std::exchange(m_loads, {});
}

std::optional<Vec4> findHeld(const ProgramContext &context, const ProgramTarget &row, bool env,
                             std::uint32_t index) {
  Hash128 hash;
  if (!env)
    if (const auto compiled = context.group->compiledOf(*row.bound))
      hash = compiled->hash;
  return ProgramEdits::instance().held(row.target, env, index, hash);
}

bool isSwitchedOff(const ProgramContext &context, const ProgramTarget &row) {
  if (!controlled() || !ProgramEdits::instance().anyOff())
    return false;
  const auto compiled = context.group->compiledOf(*row.bound);
  return compiled && ProgramEdits::instance().isOff(textFileName(row.target, compiled->hash));
}

} // namespace arbiter::state
