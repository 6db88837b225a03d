#pragma once
#include <memory>
#include <mutex>
#include <unordered_map>

#include "fp_compiler/abi.h"
#include "fp_compiler/ir/interface.h"

namespace arbiter::state::software {

/// The programs of fixed function by the state that they stand for, of all contexts of the process.
/// Machine code is found by its program (functions/), and lives as long as that: what one context
/// has compiled, the next one draws with from its first frame on.
template <typename Key> class FixedPrograms {
public:
  FixedPrograms() = default;
  FixedPrograms(const FixedPrograms &) = delete;
  FixedPrograms &operator=(const FixedPrograms &) = delete;

  /// The program of a context for `key`: the same object for the same key. Takes no lock where this
  /// context had it before. The reference stays good as long as *this does.
  template <typename Make>
  [[nodiscard]] const std::shared_ptr<const fp::ir::Program> &get(const Key &key, Make make) {
    if (m_last && m_last->first == key) [[likely]]
      return m_last->second;
    m_last = &*m_programs.try_emplace(key).first;
    if (!m_last->second)
      m_last->second = ofProcess().get(key, make);
    return m_last->second;
  }

private:
  using Program = std::shared_ptr<const fp::ir::Program>;
  struct Hash {
    std::size_t operator()(const Key &key) const { return abi::hashOf(key); }
  };
  using Map = std::unordered_map<Key, Program, Hash>;

  class OfProcess {
  public:
    template <typename Make> Program get(const Key &key, Make make) {
      const std::lock_guard lock(m_mutex);
      if (m_programs.size() >= kMost) // contexts hold those that they draw with
        m_programs.clear();
      Program &program = m_programs[key];
      if (!program)
        program = std::make_shared<const fp::ir::Program>(make(key));
      return program;
    }

  private:
    static constexpr std::size_t kMost = 1024;
    std::mutex m_mutex;
    Map m_programs;
  };
  /// Never freed, as contexts may outlive static destructors.
  static OfProcess &ofProcess() {
    static auto *const s_programs = new OfProcess;
    return *s_programs;
  }

  Map m_programs;
  /// Of the last answer: what draws differ in, often as not, is no part of the key.
  typename Map::value_type *m_last = nullptr;
};

} // namespace arbiter::state::software
