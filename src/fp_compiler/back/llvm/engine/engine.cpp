#include "fp_compiler/back/llvm/engine/engine.h"

#include <exception>

#include <llvm/Config/llvm-config.h>
#include <llvm/Support/MemoryBuffer.h>

#include "fp_compiler/back/llvm/code/failures.h"
#include "fp_compiler/back/llvm/engine/budget.h"
#include "fp_compiler/back/llvm/engine/linked.h"
#include "fp_compiler/back/llvm/engine/reserve.h"
#include "fp_compiler/back/llvm/fragment/fragment.h"
#include "fp_compiler/back/llvm/program/prepare.h"
#include "fp_compiler/back/llvm/program/vertex.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/semantics.h"
#include "fp_compiler/ir/validate.h"
#include "util/build_id.h"
#include "util/cache/cache_store.h"

namespace arbiter::fp::llvm_back {

namespace {
template <typename Function> struct LinkedCode final : jit::Code<Function> {
  explicit LinkedCode(std::unique_ptr<Linked> from) : linked(std::move(from)) {
    this->function = reinterpret_cast<Function>(linked->entry());
    this->bytes = linked->codeBytes();
  }
  std::unique_ptr<Linked> linked;
};

/// Calls \p function and turns exceptions into a reason. No exception may leave the library: memory
/// may run out, and LLVM has errors that would end the process.
template <typename Result, typename F> Result guarded(std::string &reason, F function) {
  if (hasFailed()) {
    reason = "LLVM has failed before in this process";
    return {};
  }
  if (reserve::isLow()) {
    reason = "memory has run out";
    return {};
  }
  const FailureScope scope;
  try {
    return function();
  } catch (const std::exception &error) {
    reason = error.what();
  } catch (...) {
    reason = "an unknown exception";
  }
  return {};
}

/// Returns the identity of the code that makes objects: this library and the mapped LLVM. A
/// distribution may install a fixed LLVM while this library stays the same. Empty if either is
/// unknown.
std::string makerOfObjects() {
  const auto *const inLlvm = reinterpret_cast<const void *>(&llvm::MemoryBuffer::getMemBufferCopy);
  const std::string own = buildId(), llvms = buildIdAt(inLlvm);
  return own.empty() || llvms.empty() ? std::string()
                                      : own + " LLVM " LLVM_VERSION_STRING " " + llvms;
}

class LlvmEngine final : public jit::Engine {
public:
  LlvmEngine(Cpu cpu, const jit::EngineOptions &options)
      : m_cpu(std::move(cpu)), m_build(makerOfObjects()) {
    if (!options.cacheFolder.empty())
      m_cache.emplace(options.cacheFolder, options.cacheMaxBytes);
  }

  [[nodiscard]] int lanes() const override { return m_cpu.lanes(); }
  [[nodiscard]] int blockWidth() const override { return m_cpu.blockWidth(); }
  [[nodiscard]] int blockHeight() const override { return m_cpu.blockHeight(); }
  [[nodiscard]] std::string target() const override {
    return m_cpu.name + ", " + familyName(m_cpu.family) + ", " + std::to_string(lanes()) + " lanes";
  }

  std::unique_ptr<jit::FragmentProgram> prepareFragment(const ir::Program &program,
                                                        Numerics numerics) override {
    if (program.language == ir::Language::ArbVertex || numerics == Numerics::Fp24 ||
        !hasCode(program))
      return nullptr;
    return prepare<PreparedFragment>(program, ir::numericsOf(program.language, numerics));
  }

  std::unique_ptr<jit::VertexProgram> prepareVertex(const ir::Program &program,
                                                    Numerics numerics) override {
    if (program.language != ir::Language::ArbVertex || !hasCode(program))
      return nullptr;
    return prepare<PreparedVertex>(program, ir::numericsOf(program.language, numerics));
  }

  std::unique_ptr<jit::FragmentCode> compile(const jit::FragmentProgram &program,
                                             const abi::FragmentKey &key,
                                             std::string &reason) override {
    if (!sameNumerics(program, key, reason) ||
        !isWithinBudget(program.program(), &key.samplers, reason))
      return nullptr;
    return make<abi::ShadeFunction>("fragment", program.program(),
                                    {reinterpret_cast<const char *>(&key), sizeof key},
                                    kFragmentPointers, bodyOf(program, key), reason);
  }

  std::unique_ptr<jit::VertexCode> compile(const jit::VertexProgram &program,
                                           const abi::VertexKey &key,
                                           std::string &reason) override {
    if (!isWithinBudget(program.program(), &key.samplers, reason))
      return nullptr;
    std::string whole(1, char(static_cast<const PreparedVertex &>(program).numerics()));
    if (!program.shape().samplers.empty())
      whole.append(reinterpret_cast<const char *>(&key), sizeof key);
    return make<abi::VertexFunction>("vertex", program.program(), whole, kVertexPointers,
                                     bodyOf(program, key), reason);
  }

  std::string listing(const jit::FragmentProgram &program, const abi::FragmentKey &key,
                      jit::Listing what, std::string &reason) override {
    if (!sameNumerics(program, key, reason))
      return {};
    return listed(kFragmentPointers, bodyOf(program, key), what, reason);
  }
  std::string listing(const jit::VertexProgram &program, const abi::VertexKey &key,
                      jit::Listing what, std::string &reason) override {
    return listed(kVertexPointers, bodyOf(program, key), what, reason);
  }

private:
  static constexpr int kFragmentPointers = 3; ///< parameters of abi::ShadeFunction before the count
  static constexpr int kVertexPointers = 1; ///< parameters of abi::VertexFunction before the count

  static bool isWithinBudget(const ir::Program &program, const SamplerKeys *samplers,
                             std::string &reason) {
    const double expected = expectedMilliseconds(program, samplers);
    if (expected <= kMaxMilliseconds)
      return true;
    reason = "its " + std::to_string(program.code.size()) + " instructions would take some " +
             std::to_string(long(expected)) + " ms to compile";
    return false;
  }
  /// Checks that the key has the numerics mode that the program was optimised for.
  static bool sameNumerics(const jit::FragmentProgram &program, const abi::FragmentKey &key,
                           std::string &reason) {
    const Numerics prepared = static_cast<const PreparedFragment &>(program).numerics();
    if (key.numerics == std::uint8_t(prepared))
      return true;
    reason = "the program was prepared for another mode of arithmetic than the key's";
    return false;
  }
  static BodyWriter bodyOf(const jit::FragmentProgram &program, const abi::FragmentKey &key) {
    return [&](Code &code, llvm::Function *function, std::string &why) {
      return writeFragment(code, function, program, key, why);
    };
  }
  static BodyWriter bodyOf(const jit::VertexProgram &program, const abi::VertexKey &key) {
    return [&](Code &code, llvm::Function *function, std::string &) {
      writeVertex(code, function, static_cast<const PreparedVertex &>(program), key);
      return true;
    };
  }

  std::string listed(int pointers, const BodyWriter &body, jit::Listing what,
                     std::string &reason) const {
    return guarded<std::string>(reason, [&] {
      const auto text =
          emit(m_cpu, pointers, body, what == jit::Listing::Ir ? Emit::Ir : Emit::Assembly, reason);
      return std::string(text.begin(), text.end());
    });
  }

  template <typename Prepared>
  std::unique_ptr<Prepared> prepare(const ir::Program &program, Numerics numerics) {
    std::string reason;
    return guarded<std::unique_ptr<Prepared>>(reason, [&]() -> std::unique_ptr<Prepared> {
      // The passes take time too. They may shorten a program, but not by more than this factor.
      constexpr double kShortened = 8;
      if (expectedMilliseconds(program, nullptr) > kShortened * kMaxMilliseconds ||
          !ir::validate(program).empty())
        return nullptr;
      return std::make_unique<Prepared>(program, numerics);
    });
  }

  /// Returns the cache key: everything that the object depends on.
  std::string cacheKey(const char *kind, const ir::Program &program, std::string_view key) const {
    const std::string code = ir::print(program);
    std::string text = m_build;
    for (const std::string_view part :
         {std::string_view(kind), std::string_view(m_cpu.name), std::string_view(m_cpu.features),
          std::string_view(familyName(m_cpu.family)), key, std::string_view(code)}) {
      text += std::to_string(part.size()) + ":";
      text += part;
    }
    return text;
  }

  template <typename Function>
  std::unique_ptr<jit::Code<Function>> make(const char *kind, const ir::Program &program,
                                            std::string_view key, int pointers,
                                            const BodyWriter &body, std::string &reason) {
    return guarded<std::unique_ptr<jit::Code<Function>>>(
        reason, [&]() -> std::unique_ptr<jit::Code<Function>> {
          auto linked = object(kind, program, key, pointers, body, reason);
          return linked ? std::make_unique<LinkedCode<Function>>(std::move(linked)) : nullptr;
        });
  }

  std::unique_ptr<Linked> object(const char *kind, const ir::Program &program, std::string_view key,
                                 int pointers, const BodyWriter &body, std::string &reason) const {
    const bool cached = m_cache && m_cache->usable() && !m_build.empty();
    const std::string name = cached ? cacheKey(kind, program, key) : std::string();
    if (cached)
      if (const auto bytes = m_cache->find(name))
        if (auto linked = link(*bytes, reason))
          return linked;
    const llvm::SmallVector<char, 0> bytes = emit(m_cpu, pointers, body, Emit::Object, reason);
    if (bytes.empty())
      return nullptr;
    const std::string_view view(bytes.data(), bytes.size());
    auto linked = link(view, reason);
    if (linked && cached)
      m_cache->store(name, view);
    return linked;
  }

  static std::unique_ptr<Linked> link(std::string_view bytes, std::string &reason) {
    // A string's bytes may be unaligned, but ELF structures must be aligned.
    const auto copy = llvm::MemoryBuffer::getMemBufferCopy({bytes.data(), bytes.size()}, "object");
    if (!copy)
      throw std::bad_alloc();
    return Linked::link(copy->getMemBufferRef(), kEntrySymbol, reason);
  }

  const Cpu m_cpu;
  std::optional<CacheStore> m_cache; ///< cache of object code
  const std::string m_build;
};
} // namespace

std::unique_ptr<jit::Engine> makeEngine(const jit::EngineOptions &options) {
  std::optional<Cpu> cpu = chooseCpu(options.cpu);
  return cpu ? std::make_unique<LlvmEngine>(std::move(*cpu), options) : nullptr;
}

} // namespace arbiter::fp::llvm_back
