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

class Context;

/// Whether this process may be controlled (ARBITER_CONTROL): one load of a constant.
[[nodiscard]] bool controlAllowed();
[[nodiscard]] inline bool controlled() {
  static const bool s_controlled = controlAllowed();
  return s_controlled;
}

/// A parameter that has a value of a client's in draws.
struct HeldValue {
  Target target = Target::Fragment; ///< of an env parameter: whose
  bool env = false;
  std::uint32_t index = 0;
  std::string program; ///< of a local parameter: the name of the text's file
  Hash128 hash;        ///< likewise: of the text
  Vec4 value{};
};

/// What clients of control have changed of the process's programs: texts that stand in for the
/// application's, by the name of the text's file as in a folder of replacements; programs that are
/// not drawn with; values of parameters. Contexts take it over where they look for changed files
/// (refreshReplacements()). Any thread may call; never destroyed.
class ProgramEdits {
public:
  [[nodiscard]] static ProgramEdits &instance();

  /// Grows with every change.
  [[nodiscard]] std::uint64_t generation() const {
    return m_generation.load(std::memory_order_acquire);
  }
  /// What is drawn with that text changed after `generation`.
  [[nodiscard]] bool changedSince(const std::string &name, std::uint64_t generation);
  /// The generation that a context has taken over, which is that of now from here on.
  [[nodiscard]] std::uint64_t seenBy(const Context &context, std::uint64_t now);

  void setText(const std::string &name, std::string text);
  /// \returns false where none stood in.
  bool resetText(const std::string &name);
  /// \returns how many did.
  std::size_t resetTexts();
  /// \returns false where there is none.
  [[nodiscard]] bool text(const std::string &name, std::string &text);
  void setEnabled(const std::string &name, bool enabled);
  [[nodiscard]] bool isOff(const std::string &name);
  [[nodiscard]] bool anyOff() const { return m_anyOff.load(std::memory_order_relaxed); }

  void hold(HeldValue value);
  /// Lets go of what `matches` says. \returns how many.
  template <typename Matches> std::size_t letGo(Matches matches) {
    const std::lock_guard lock(m_mutex);
    const std::size_t count = std::erase_if(m_held, matches);
    if (count != 0)
      changed();
    return count;
  }
  [[nodiscard]] bool anyHeld() const { return m_anyHeld.load(std::memory_order_relaxed); }
  /// \param hash of the program's text, of a local parameter
  [[nodiscard]] std::optional<Vec4> held(Target target, bool env, std::uint32_t index,
                                         const Hash128 &hash);

  /// All is the application's again.
  void clear();

  /// Texts that were loaded are to be told of, or not any more.
  void watchLoads(bool watch) { m_watchesLoads.store(watch, std::memory_order_relaxed); }
  void noteLoad(const std::string &name);
  /// Those since the last call, up to a thousand.
  [[nodiscard]] std::vector<std::string> takeLoads();

private:
  struct Edit {
    std::string text;
    bool hasText = false, off = false;
    std::uint64_t changed = 0; ///< the generation
  };
  void changed();
  void changed(Edit &edit);

  std::mutex m_mutex;
  std::unordered_map<std::string, Edit> m_edits;
  std::unordered_map<std::uint32_t, std::uint64_t> m_seen; ///< by the context's serial
  std::vector<HeldValue> m_held;
  std::vector<std::string> m_loads;
  std::atomic<bool> m_watchesLoads{false}, m_anyHeld{false}, m_anyOff{false};
  std::atomic<std::uint64_t> m_generation{0};
};

/// What stands in for an env or local parameter of the row's program; nothing mostly. Asked for
/// where values are gathered, not at each draw.
[[nodiscard]] std::optional<Vec4> findHeld(const Context &context, const ProgramTarget &row,
                                           bool env, std::uint32_t index);
[[nodiscard]] inline bool anyHeld() { return controlled() && ProgramEdits::instance().anyHeld(); }
/// The program that is bound to the row is switched off: draws are as if the target were not
/// enabled.
[[nodiscard]] bool isSwitchedOff(const Context &context, const ProgramTarget &row);

} // namespace arbiter::state
