#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <unordered_map>

#include "fp_compiler/abi.h"
#include "fp_compiler/emit.h"
#include "fp_compiler/ir/ir.h"
#include "state/objects/program_object.h"
#include "state/programs/variants/drop_variants.h"

namespace arbiter::state {

struct ProgramContext;

struct StateText;

/// Compiles a program that was made from GL state, for this context. There is no text of the
/// application's, and none of its limits apply.
/// \param text the state's text, or null if nothing needs one
/// \param target the target whose env parameters the program reads
/// \param program a valid program of language ArbFragment
[[nodiscard]] std::shared_ptr<const CompiledProgram>
programOfState(const ProgramContext &context, Target target, fp::ir::Program program,
               const fp::GlslHost &host, const StateText *text);

/// A context's programs of a target whose program is GL state, by the state's plain bytes. Each is
/// made once. An application has dozens or hundreds. If there are too many, all are dropped.
template <typename Key> class StatePrograms {
public:
  /// Returns the program of `key`.
  /// \param lower makes the program of the key
  /// \param text see programOfState()
  template <typename Lower>
  [[nodiscard]] std::shared_ptr<const CompiledProgram> of(ProgramContext &context, Target target,
                                                          const Key &key, const fp::GlslHost &host,
                                                          const StateText *text, Lower lower) {
    if (const auto it = m_programs.find(key); it != m_programs.end())
      return it->second;
    if (m_programs.size() >= kMax)
      clear(context);
    return m_programs.emplace(key, programOfState(context, target, lower(key), host, text))
        .first->second;
  }

  void clear(ProgramContext &context) {
    for (const auto &known : m_programs)
      dropVariants(context, *known.second);
    m_programs.clear();
  }

private:
  static constexpr std::size_t kMax = 2048;
  struct Hash {
    std::size_t operator()(const Key &key) const {
      static_assert(std::has_unique_object_representations_v<Key>);
      return abi::hashOf(key);
    }
  };
  std::unordered_map<Key, std::shared_ptr<const CompiledProgram>, Hash> m_programs;
};

/// A context's programs of states that have texts, by the text and its replacement.
template <typename Key> class NamedStatePrograms {
public:
  [[nodiscard]] StatePrograms<Key> &of(ProgramContext &context, const std::string &name) {
    const auto it = m_programs.find(name);
    if (it != m_programs.end())
      return it->second;
    if (m_programs.size() >= kMax) {
      for (auto &known : m_programs)
        known.second.clear(context);
      m_programs.clear();
    }
    return m_programs[name];
  }

private:
  static constexpr std::size_t kMax = 512;
  std::unordered_map<std::string, StatePrograms<Key>> m_programs;
};

} // namespace arbiter::state
