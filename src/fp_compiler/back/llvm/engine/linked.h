#pragma once
#include <memory>
#include <string>

#include <llvm/Support/MemoryBufferRef.h>

#include "fp_compiler/back/llvm/engine/code_memory.h"

namespace arbiter::fp::llvm_back {

/// An object file in memory, relocated and ready to run. The destructor unmaps it.
class Linked {
public:
  /// \return null, with a reason, if this is no complete object for this machine, if it needs a
  /// symbol that program code does not use, or if it lacks \p symbol
  static std::unique_ptr<Linked> link(llvm::MemoryBufferRef object, const char *symbol,
                                      std::string &reason);

  [[nodiscard]] void *entry() const { return m_entry; }
  [[nodiscard]] std::size_t codeBytes() const { return m_memory.codeBytes(); }

private:
  Linked() = default;
  CodeMemory m_memory;
  void *m_entry = nullptr;
};

} // namespace arbiter::fp::llvm_back
