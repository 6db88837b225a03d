#include "fp_compiler/back/llvm/program/emit.h"

#include <mutex>

#include <llvm/IR/DiagnosticInfo.h>
#include <llvm/IR/DiagnosticPrinter.h>
#include <llvm/IR/IntrinsicsAArch64.h>
#include <llvm/IR/IntrinsicsX86.h>
#include <llvm/IR/LegacyPassManager.h>
#include <llvm/IR/Verifier.h>
#include <llvm/MC/TargetRegistry.h>
#include <llvm/Support/TargetSelect.h>
#include <llvm/Support/raw_ostream.h>
#include <llvm/Target/TargetMachine.h>

#include "fp_compiler/back/llvm/code/failures.h"
#include "fp_compiler/back/llvm/code/passes.h"
#include "fp_compiler/back/llvm/code/release.h"

namespace arbiter::fp::llvm_back {

namespace {
using MachinePtr = std::unique_ptr<llvm::TargetMachine>;

/// Code is linked at its final address. 32-bit x86 has no instructions relative to the program
/// counter, and RuntimeDyld does not support the alternative, a table of offsets.
#if defined(__i386__)
constexpr llvm::Reloc::Model kRelocations = llvm::Reloc::Static;
#else
constexpr llvm::Reloc::Model kRelocations = llvm::Reloc::PIC_;
#endif

MachinePtr makeMachine(const Cpu &cpu, std::string &reason) {
  static std::once_flag s_once;
  std::call_once(s_once, [] {
    llvm::InitializeNativeTarget();
    llvm::InitializeNativeTargetAsmPrinter();
    llvm::InitializeNativeTargetAsmParser();
  });
  llvm::Triple triple(llvm::sys::getProcessTriple());
  const llvm::Target *const target = llvm::TargetRegistry::lookupTarget("", triple, reason);
  if (!target)
    return nullptr;
  llvm::TargetOptions options;
  options.AllowFPOpFusion = llvm::FPOpFusion::Strict;
  release::flushDenormals(options);
  MachinePtr machine(target->createTargetMachine(release::nameOf(triple), cpu.name, cpu.features,
                                                 options, kRelocations, llvm::CodeModel::Small,
                                                 release::kUsualOptimisation, true));
  if (!machine)
    reason = "LLVM makes no code for " + triple.str();
  return machine;
}

/// Collects diagnostics. Without a handler, LLVM ends the process on an error.
struct Listener final : llvm::DiagnosticHandler {
  explicit Listener(std::string &to) : text(to) {}
  bool handleDiagnostics(const llvm::DiagnosticInfo &info) override {
    if (info.getSeverity() == llvm::DS_Error) {
      llvm::raw_string_ostream stream(text);
      llvm::DiagnosticPrinterRawOStream printer(stream);
      info.print(printer);
    }
    return true;
  }
  std::string &text;
};

/// Enables control-flow protection. Code is called by address, so that it must pass the processor's
/// checks of indirect branches and returns.
void setControlFlow(llvm::Module &module) {
#if defined(__x86_64__) || defined(__i386__)
  module.addModuleFlag(llvm::Module::Override, "cf-protection-branch", 1);
  module.addModuleFlag(llvm::Module::Override, "cf-protection-return", 1);
#else
  module.addModuleFlag(llvm::Module::Override, "branch-target-enforcement", 1);
#endif
}

void setAttributes(llvm::Function &function, const Cpu &cpu) {
  function.addFnAttr(llvm::Attribute::NoUnwind);
  function.addFnAttr("target-cpu", cpu.name);
  if (!cpu.features.empty())
    function.addFnAttr("target-features", cpu.features);
  if (cpu.family == Cpu::Family::Avx512)
    function.addFnAttr("prefer-vector-width", "512");
  function.addFnAttr("denormal-fp-math", "preserve-sign,preserve-sign");
  function.addFnAttr("no-trapping-math", "true");
}

/// Reads and sets the processor's floating-point control word.
class ControlWord {
public:
  explicit ControlWord(llvm::IRBuilder<> &ir) : m_ir(ir) {
#if defined(__x86_64__) || defined(__i386__)
    m_slot = ir.CreateAlloca(ir.getInt32Ty());
#endif
  }

#if defined(__x86_64__) || defined(__i386__)
  static constexpr std::uint64_t kMode = 0x9FC0; ///< no traps, round to nearest, FTZ and DAZ
  Value *read() {
    m_ir.CreateIntrinsic(llvm::Intrinsic::x86_sse_stmxcsr, {}, {m_slot});
    return m_ir.CreateLoad(m_ir.getInt32Ty(), m_slot);
  }
  void set(Value *word) {
    m_ir.CreateStore(word, m_slot);
    m_ir.CreateIntrinsic(llvm::Intrinsic::x86_sse_ldmxcsr, {}, {m_slot});
  }
  Value *mode() { return m_ir.getInt32(kMode); }
  /// Returns the word without the exception flags.
  Value *modeOf(Value *word) { return m_ir.CreateAnd(word, m_ir.getInt32(~0x3Fu)); }
#else
  static constexpr std::uint64_t kMode = 1u << 24; ///< only FPCR.FZ
  static constexpr llvm::ArrayRef<llvm::Type *> kNoTypes;
  Value *read() { return m_ir.CreateIntrinsic(llvm::Intrinsic::aarch64_get_fpcr, kNoTypes, {}); }
  void set(Value *word) { m_ir.CreateIntrinsic(llvm::Intrinsic::aarch64_set_fpcr, {}, {word}); }
  Value *mode() { return m_ir.getInt64(kMode); }
  Value *modeOf(Value *word) { return word; }
#endif

private:
  llvm::IRBuilder<> &m_ir;
  Value *m_slot = nullptr;
};

void writeEntry(llvm::IRBuilder<> &ir, llvm::Function *entry, llvm::Function *body) {
  const auto block = [&](const char *name) {
    return llvm::BasicBlock::Create(ir.getContext(), name, entry);
  };
  auto *const start = block("");
  auto *const asIs = block("as_is");
  auto *const changed = block("changed");
  llvm::SmallVector<Value *, 4> arguments;
  for (llvm::Argument &argument : entry->args())
    arguments.push_back(&argument);
  ir.SetInsertPoint(start);
  ControlWord control(ir);
  Value *const callers = control.read();
  // Changing the mode serialises the pipeline. A caller with many small calls sets the mode itself.
  ir.CreateCondBr(ir.CreateICmpEQ(control.modeOf(callers), control.mode()), asIs, changed);
  ir.SetInsertPoint(asIs);
  ir.CreateCall(body, arguments);
  ir.CreateRetVoid();
  ir.SetInsertPoint(changed);
  control.set(control.mode());
  ir.CreateCall(body, arguments);
  control.set(callers);
  ir.CreateRetVoid();
}

/// The LLVM objects of one compilation. Members are destroyed in reverse order.
struct Workspace {
  explicit Workspace(MachinePtr of) : machine(std::move(of)) {}
  MachinePtr machine;
  std::string problem;
  llvm::LLVMContext context;
  llvm::Module module{"arbiter", context};
  llvm::SmallVector<char, 0> bytes;
  llvm::raw_svector_ostream stream{bytes};
  llvm::legacy::PassManager passes;
};

/// Writes the requested output. Returns false if LLVM cannot.
bool write(Workspace &space, Emit what, std::string &reason) {
  if (what == Emit::Ir) {
    space.module.print(space.stream, nullptr);
    return true;
  }
  const auto type = what == Emit::Object ? release::kObjectFile : release::kAssemblyFile;
  if (space.machine->addPassesToEmitFile(space.passes, space.stream, nullptr, type)) {
    reason = "LLVM writes no objects for this processor";
    return false;
  }
  space.passes.run(space.module);
  return true;
}
} // namespace

llvm::SmallVector<char, 0> emit(const Cpu &cpu, int pointers, const BodyWriter &writeBody,
                                Emit what, std::string &reason) {
  MachinePtr machine;
  try {
    machine = makeMachine(cpu, reason);
  } catch (...) {
    noteFailure(); // it may have stopped in the middle of registering targets
    throw;
  }
  if (!machine)
    return {};
  const Kept<Workspace> space(std::move(machine));
  std::string &problem = space->problem;
  llvm::LLVMContext &context = space->context;
  context.setDiagnosticHandler(std::make_unique<Listener>(problem));
  llvm::Module &module = space->module;
  module.setTargetTriple(release::nameOf(space->machine->getTargetTriple()));
  module.setDataLayout(space->machine->createDataLayout());
  setControlFlow(module);

  llvm::IRBuilder<> ir(context);
  llvm::SmallVector<llvm::Type *, 4> parameters(std::size_t(pointers), ir.getPtrTy());
  parameters.push_back(ir.getInt32Ty());
  auto *const type = llvm::FunctionType::get(ir.getVoidTy(), parameters, false);
  auto *const entry =
      llvm::Function::Create(type, llvm::GlobalValue::ExternalLinkage, kEntrySymbol, module);
  auto *const body =
      llvm::Function::Create(type, llvm::GlobalValue::InternalLinkage, "body", module);
  setAttributes(*entry, cpu);
  setAttributes(*body, cpu);
  // If the body were inlined, arithmetic could move before the change of mode.
  body->addFnAttr(llvm::Attribute::NoInline);
  writeEntry(ir, entry, body);

  Code code(ir, cpu);
  if (!writeBody(code, body, reason))
    return {};
  llvm::raw_string_ostream stream(problem);
  if (llvm::verifyFunction(*body, &stream)) {
    reason = "the function is not well-formed: " + problem;
    return {};
  }
  optimise(*body, *space->machine);
  if (!write(*space, what, reason))
    return {};
  if (!problem.empty()) {
    reason = problem;
    return {};
  }
  return std::move(space->bytes);
}

} // namespace arbiter::fp::llvm_back
