#pragma once
#include <cstddef>
#include <memory>
#include <type_traits>
#include <unordered_map>

#include "fp_compiler/abi.h"
#include "fp_compiler/emit.h"
#include "fp_compiler/ir/ir.h"
#include "state/host_draw/variants/drop_variants.h"
#include "state/programs/program_object.h"

namespace arbiter::state {

class Context;

/// A program that GL state was made into, compiled for this context: there is no text of the
/// application's, and none of its limits count.
/// \param target whose env parameters the program reads
/// \param program valid, of language ArbFragment
[[nodiscard]] std::shared_ptr<const CompiledProgram> programOfState(const Context &context,
                                                                    Target target,
                                                                    fp::ir::Program program,
                                                                    const fp::GlslHost &host);

/// A context's programs of a target that is state, by what they were made for: plain bytes. Each is
/// made once. An application has some dozens or hundreds; one that makes others for ever begins
/// again here.
template <typename Key> class StatePrograms {
public:
  /// \param lower gives the program of the key
  template <typename Lower>
  [[nodiscard]] std::shared_ptr<const CompiledProgram>
  of(Context &context, Target target, const Key &key, const fp::GlslHost &host, Lower lower) {
    if (const auto it = m_programs.find(key); it != m_programs.end())
      return it->second;
    if (m_programs.size() >= kMost) {
      for (const auto &known : m_programs)
        dropVariants(context, *known.second);
      m_programs.clear();
    }
    return m_programs.emplace(key, programOfState(context, target, lower(key), host)).first->second;
  }

private:
  static constexpr std::size_t kMost = 2048;
  struct Hash {
    std::size_t operator()(const Key &key) const {
      static_assert(std::has_unique_object_representations_v<Key>);
      return abi::hashOf(key);
    }
  };
  std::unordered_map<Key, std::shared_ptr<const CompiledProgram>, Hash> m_programs;
};

} // namespace arbiter::state
