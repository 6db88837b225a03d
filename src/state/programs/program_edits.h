#pragma once
#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "state/objects/target.h"
#include "util/hash.h"

namespace arbiter::state {

struct ProgramContext;

/// True if this process may be controlled (ARBITER_CONTROL). It only loads a constant.
[[nodiscard]] bool controlAllowed();
[[nodiscard]] inline bool controlled() {
  static const bool s_controlled = controlAllowed();
  return s_controlled;
}

/// A parameter for which draws use a client's value.
struct HeldValue {
  Target target = Target::Fragment; ///< the target of an env parameter
  bool env = false;
  std::uint32_t index = 0;
  std::string program; ///< for a local parameter: the file name of the program's text
  Hash128 hash;        ///< for a local parameter: the hash of the text
  Vec4 value{};
};

/// The changes that clients of control have made to the process's programs. There are texts that
/// replace the application's, by file name as in a folder of replacements; programs that are
/// switched off; and parameter values. Contexts take changes over when they look for changed files
/// (refreshReplacements()). Any thread may call. Never destroyed.
class ProgramEdits {
public:
  [[nodiscard]] static ProgramEdits &instance();

  /// Returns a number that grows with every change.
  [[nodiscard]] std::uint64_t generation() const {
    return m_generation.load(std::memory_order_acquire);
  }
  /// True if edits of the program with that text have changed after `generation`.
  [[nodiscard]] bool changedSince(const std::string &name, std::uint64_t generation);
  /// Returns the generation that a context has seen, and sets it to `now`.
  [[nodiscard]] std::uint64_t seenBy(const ProgramContext &context, std::uint64_t now);

  void setText(const std::string &name, std::string text);
  /// Removes the replacement of a text. \returns false if there was none
  bool resetText(const std::string &name);
  /// Removes all replacements. \returns their number
  std::size_t resetTexts();
  /// Gets the replacement of a text. \returns false if there is none
  [[nodiscard]] bool text(const std::string &name, std::string &text);
  void setEnabled(const std::string &name, bool enabled);
  [[nodiscard]] bool isOff(const std::string &name);
  [[nodiscard]] bool anyOff() const { return m_anyOff.load(std::memory_order_relaxed); }

  void hold(HeldValue value);
  /// Releases the held values for which `matches` is true. \returns their number
  template <typename Matches> std::size_t letGo(Matches matches) {
    const std::lock_guard lock(m_mutex);
    const std::size_t count = std::erase_if(m_held, matches);
    if (count != 0)
      changed();
    return count;
  }
  [[nodiscard]] bool anyHeld() const { return m_anyHeld.load(std::memory_order_relaxed); }
  /// Returns the held value of a parameter, if there is one.
  /// \param hash of the program's text, for a local parameter
  [[nodiscard]] std::optional<Vec4> held(Target target, bool env, std::uint32_t index,
                                         const Hash128 &hash);

  /// Undoes all changes.
  void clear();

  /// Switches on or off whether loaded texts are collected.
  void watchLoads(bool watch) { m_watchesLoads.store(watch, std::memory_order_relaxed); }
  void noteLoad(const std::string &name);
  /// Returns the texts loaded since the last call, up to a thousand.
  [[nodiscard]] std::vector<std::string> takeLoads();

private:
  struct Edit {
    std::string text;
    bool hasText = false, off = false;
    std::uint64_t changed = 0; ///< the generation of the last change
  };
  void changed();
  void changed(Edit &edit);

  std::mutex m_mutex;
  std::unordered_map<std::string, Edit> m_edits;
  std::unordered_map<std::uint32_t, std::uint64_t> m_seen; ///< by the context's serial number
  std::vector<HeldValue> m_held;
  std::vector<std::string> m_loads;
  std::atomic<bool> m_watchesLoads{false}, m_anyHeld{false}, m_anyOff{false};
  std::atomic<std::uint64_t> m_generation{0};
};

/// Returns the value that replaces an env or local parameter of the target's program; mostly
/// nothing. It is called where values are collected, not for each draw.
[[nodiscard]] std::optional<Vec4> findHeld(const ProgramContext &context, const ProgramTarget &row,
                                           bool env, std::uint32_t index);
[[nodiscard]] inline bool anyHeld() { return controlled() && ProgramEdits::instance().anyHeld(); }
/// True if the program bound to the target is switched off. Draws are then done as if the target
/// were disabled.
[[nodiscard]] bool isSwitchedOff(const ProgramContext &context, const ProgramTarget &row);

} // namespace arbiter::state
