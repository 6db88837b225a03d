#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <llvm/ExecutionEngine/RTDyldMemoryManager.h>

#include "fp_compiler/back/llvm/code/release.h"

namespace arbiter::fp::llvm_back {

/// The memory of one object that is linked: all its sections in one mapping. Code reaches its
/// constants by distances of 32 bits, which the linker cuts off without a word, and two mappings of
/// a process that has reserved much of its address space may lie further apart.
class CodeMemory final : public llvm::RTDyldMemoryManager {
public:
  CodeMemory() = default;
  ~CodeMemory() override;
  CodeMemory(const CodeMemory &) = delete;
  CodeMemory &operator=(const CodeMemory &) = delete;

  [[nodiscard]] std::size_t codeBytes() const { return m_code.used; }

  bool needsToReserveAllocationSpace() override { return true; }
  void reserveAllocationSpace(std::uintptr_t codeBytes, release::SectionAlignment codeAlignment,
                              std::uintptr_t constantBytes,
                              release::SectionAlignment constantAlignment, std::uintptr_t dataBytes,
                              release::SectionAlignment dataAlignment) override;
  std::uint8_t *allocateCodeSection(std::uintptr_t bytes, unsigned alignment, unsigned id,
                                    llvm::StringRef name) override;
  std::uint8_t *allocateDataSection(std::uintptr_t bytes, unsigned alignment, unsigned id,
                                    llvm::StringRef name, bool readOnly) override;
  /// Code becomes executable, and it and constants read only. True, with the reason, if there was
  /// no memory, or the object has more than it announced: nothing of it may be run.
  bool finalizeMemory(std::string *problem) override;
  /// Nothing unwinds through this code.
  void registerEHFrames(std::uint8_t *, std::uint64_t, std::size_t) override {}
  void deregisterEHFrames() override {}

private:
  /// Whole pages with the same rights.
  struct Part {
    std::uint8_t *begin = nullptr;
    std::size_t bytes = 0, used = 0;
  };
  std::uint8_t *take(Part &part, std::size_t bytes, unsigned alignment);

  void *m_mapping = nullptr;
  std::size_t m_mapped = 0;
  Part m_code, m_constants, m_data;
  /// The linker ends the process where it gets no memory: sections without a place lie here.
  std::vector<std::unique_ptr<std::uint8_t[]>> m_astray;
};

} // namespace arbiter::fp::llvm_back
