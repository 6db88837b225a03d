#pragma once
#include <memory>
#include <string>

#include <llvm/ExecutionEngine/SectionMemoryManager.h>
#include <llvm/Support/MemoryBufferRef.h>

namespace arbiter::fp::llvm_back {

/// An object file in memory, relocated and ready to run; unmapped when this dies.
class Linked {
public:
  /// \return null, with a reason, for what is no whole object of this machine, asks for a symbol
  ///         that code of ours does not use, or lacks \p symbol
  static std::unique_ptr<Linked> link(llvm::MemoryBufferRef object, const char *symbol,
                                      std::string &reason);

  [[nodiscard]] void *entry() const { return m_entry; }
  [[nodiscard]] std::size_t codeBytes() const { return m_memory.codeBytes; }

private:
  class Memory final : public llvm::SectionMemoryManager {
  public:
    std::uint8_t *allocateCodeSection(std::uintptr_t size, unsigned alignment, unsigned id,
                                      llvm::StringRef name) override {
      codeBytes += size;
      return SectionMemoryManager::allocateCodeSection(size, alignment, id, name);
    }
    std::size_t codeBytes = 0;
  };

  Linked() = default;
  Memory m_memory;
  void *m_entry = nullptr;
};

} // namespace arbiter::fp::llvm_back
