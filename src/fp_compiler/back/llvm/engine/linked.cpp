#include "fp_compiler/back/llvm/engine/linked.h"

#include <cstring>

#include <llvm/ExecutionEngine/JITSymbol.h>
#include <llvm/ExecutionEngine/RuntimeDyld.h>
#include <llvm/Object/ObjectFile.h>

#include "fp_compiler/back/llvm/code/failures.h"

namespace arbiter::fp::llvm_back {

namespace {
/// Resolves the functions that compiled code may call: those that LLVM uses for long copies. No
/// symbol is looked up in the process.
class Resolver final : public llvm::LegacyJITSymbolResolver {
public:
  llvm::JITSymbol findSymbol(const std::string &name) override {
    const auto symbol = [](auto *function) {
      return llvm::JITSymbol(llvm::JITTargetAddress(reinterpret_cast<std::uintptr_t>(function)),
                             llvm::JITSymbolFlags::Exported);
    };
    if (name == "memcpy")
      return symbol(&std::memcpy);
    if (name == "memset")
      return symbol(&std::memset);
    if (name == "memmove")
      return symbol(static_cast<void *(*)(void *, const void *, std::size_t)>(&std::memmove));
    return nullptr;
  }
  llvm::JITSymbol findSymbolInLogicalDylib(const std::string &) override { return nullptr; }
};
} // namespace

std::unique_ptr<Linked> Linked::link(llvm::MemoryBufferRef object, const char *symbol,
                                     std::string &reason) {
  auto file = llvm::object::ObjectFile::createObjectFile(object);
  if (!file) {
    reason = "the object is damaged: " + llvm::toString(file.takeError());
    return nullptr;
  }
  std::unique_ptr<Linked> linked(new Linked);
  Resolver resolver;
  const Kept<llvm::RuntimeDyld> kept(linked->m_memory, resolver);
  llvm::RuntimeDyld &linker = *kept;
  linker.loadObject(**file);
  if (!linker.hasError())
    linker.resolveRelocations();
  if (linker.hasError()) {
    reason = "the object cannot be linked: " + linker.getErrorString().str();
    return nullptr;
  }
  linked->m_entry = linker.getSymbolLocalAddress(symbol);
  std::string problem;
  if (linked->m_memory.finalizeMemory(&problem)) {
    reason = "the code cannot be made executable: " + problem;
    return nullptr;
  }
  if (!linked->m_entry) {
    reason = std::string("the object lacks ") + symbol;
    return nullptr;
  }
  return linked;
}

} // namespace arbiter::fp::llvm_back
