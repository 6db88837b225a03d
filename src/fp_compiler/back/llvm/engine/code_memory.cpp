#include "fp_compiler/back/llvm/engine/code_memory.h"

#include <string>
#include <sys/mman.h>
#include <unistd.h>

#include <llvm/Support/Memory.h>

namespace arbiter::fp::llvm_back {

namespace {

std::size_t roundUp(std::size_t value, std::size_t unit) {
  return (value + unit - 1) / unit * unit;
}

} // namespace

CodeMemory::~CodeMemory() {
  if (m_mapping)
    munmap(m_mapping, m_mapped);
}

void CodeMemory::reserveAllocationSpace(std::uintptr_t codeBytes, release::SectionAlignment,
                                        std::uintptr_t constantBytes, release::SectionAlignment,
                                        std::uintptr_t dataBytes, release::SectionAlignment) {
  // No section is aligned to more than a page.
  const std::size_t page = std::size_t(sysconf(_SC_PAGESIZE));
  m_code.bytes = roundUp(codeBytes, page);
  m_constants.bytes = roundUp(constantBytes, page);
  m_data.bytes = roundUp(dataBytes, page);
  m_mapped = m_code.bytes + m_constants.bytes + m_data.bytes;
  void *const mapping =
      mmap(nullptr, m_mapped, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapping == MAP_FAILED) {
    m_code.bytes = m_constants.bytes = m_data.bytes = m_mapped = 0;
    return;
  }
  m_mapping = mapping;
  m_code.begin = static_cast<std::uint8_t *>(mapping);
  m_constants.begin = m_code.begin + m_code.bytes;
  m_data.begin = m_constants.begin + m_constants.bytes;
}

std::uint8_t *CodeMemory::take(Part &part, std::size_t bytes, unsigned alignment) {
  const std::size_t at = roundUp(part.used, alignment ? alignment : 1);
  if (at > part.bytes || bytes > part.bytes - at) {
    m_astray.push_back(std::make_unique<std::uint8_t[]>(bytes));
    return m_astray.back().get();
  }
  part.used = at + bytes;
  return part.begin + at;
}

std::uint8_t *CodeMemory::allocateCodeSection(std::uintptr_t bytes, unsigned alignment, unsigned,
                                              llvm::StringRef) {
  return take(m_code, bytes, alignment);
}

std::uint8_t *CodeMemory::allocateDataSection(std::uintptr_t bytes, unsigned alignment, unsigned,
                                              llvm::StringRef, bool readOnly) {
  return take(readOnly ? m_constants : m_data, bytes, alignment);
}

bool CodeMemory::finalizeMemory(std::string *problem) {
  const auto protect = [](const Part &part, int rights) {
    return part.bytes == 0 || mprotect(part.begin, part.bytes, rights) == 0;
  };
  const char *reason = nullptr;
  if (!m_astray.empty())
    reason = m_mapping ? "the object has more than it announced" : "no memory";
  else if (!protect(m_constants, PROT_READ) || !protect(m_code, PROT_READ | PROT_EXEC))
    reason = "the system refuses the rights";
  if (reason && problem)
    *problem = reason;
  if (!reason && m_code.bytes > 0)
    llvm::sys::Memory::InvalidateInstructionCache(m_code.begin, m_code.bytes);
  return reason != nullptr;
}

} // namespace arbiter::fp::llvm_back
