#pragma once
#include <memory>
#include <mutex>
#include <unordered_map>

#include "fp_compiler/abi.h"
#include "fp_compiler/ir/interface.h"

namespace arbiter::state {

/// The programs of fixed function by state, shared by all contexts of the process. Machine code is
/// found by its program (functions/) and lives as long. A new context can thus draw its first frame
/// with code that another one compiled.
template <typename Key> class FixedPrograms {
public:
  FixedPrograms() = default;
  FixedPrograms(const FixedPrograms &) = delete;
  FixedPrograms &operator=(const FixedPrograms &) = delete;

  /// Returns the program for `key`; the same key gives the same object. Takes no lock if this
  /// context has used it before. The reference is valid as long as *this.
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
      if (m_programs.size() >= kMax) // contexts keep the programs that they use alive
        m_programs.clear();
      Program &program = m_programs[key];
      if (!program)
        program = std::make_shared<const fp::ir::Program>(make(key));
      return program;
    }

  private:
    static constexpr std::size_t kMax = 1024;
    std::mutex m_mutex;
    Map m_programs;
  };
  /// Returns the process's programs. Never freed, because contexts may outlive static destructors.
  static OfProcess &ofProcess() {
    static auto *const s_programs = new OfProcess;
    return *s_programs;
  }

  Map m_programs;
  /// The last result. What differs between draws is often no part of the key.
  typename Map::value_type *m_last = nullptr;
};

} // namespace arbiter::state
