#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <llvm/ExecutionEngine/RTDyldMemoryManager.h>

#include "fp_compiler/back/llvm/code/release.h"

namespace arbiter::fp::llvm_back {

/// The memory of one linked object: a single mapping for all sections. Code addresses its constants
/// with 32-bit offsets, which the linker truncates silently. With two mappings they may be too far
/// apart in a process that has reserved much address space.
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
  /// Makes the code executable, and code and constants read-only. Returns true, with the reason, if
  /// memory ran out or the object has more than it announced. The object must not be used then.
  bool finalizeMemory(std::string *problem) override;
  /// No exceptions unwind through this code.
  void registerEHFrames(std::uint8_t *, std::uint64_t, std::size_t) override {}
  void deregisterEHFrames() override {}

private:
  /// Whole pages with the same access rights.
  struct Part {
    std::uint8_t *begin = nullptr;
    std::size_t bytes = 0, used = 0;
  };
  std::uint8_t *take(Part &part, std::size_t bytes, unsigned alignment);

  void *m_mapping = nullptr;
  std::size_t m_mapped = 0;
  Part m_code, m_constants, m_data;
  /// Sections for which there was no memory. LLVM's linker would end the process if allocation
  /// failed.
  std::vector<std::unique_ptr<std::uint8_t[]>> m_astray;
};

} // namespace arbiter::fp::llvm_back
