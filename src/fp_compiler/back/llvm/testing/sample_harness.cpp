#include "fp_compiler/back/llvm/testing/sample_harness.h"

#include "fp_compiler/back/llvm/program/emit.h"

namespace arbiter::fp::llvm_back::testing {
namespace {

/// Writes the loop over chunks.
class Body {
public:
  Body(Code &code, llvm::Function *function, const abi::SamplerKey &key,
       const SampleOptions &options)
      : m_code(code), m_function(function), m_key(key), m_options(options),
        m_call(function->getArg(0)) {}

  bool write() {
    llvm::IRBuilder<> &ir = m_code.ir;
    auto *const entry = llvm::BasicBlock::Create(m_code.context(), "entry", m_function);
    auto *const loop = llvm::BasicBlock::Create(m_code.context(), "loop", m_function);
    auto *const done = llvm::BasicBlock::Create(m_code.context(), "done", m_function);
    ir.SetInsertPoint(entry);
    ir.CreateBr(loop);
    ir.SetInsertPoint(loop);
    llvm::PHINode *const chunk = ir.CreatePHI(ir.getInt32Ty(), 2);
    chunk->addIncoming(ir.getInt32(0), entry);
    m_first =
        ir.CreateZExt(ir.CreateMul(chunk, ir.getInt32(unsigned(m_code.lanes))), ir.getInt64Ty());
    const Texel texel = sample(m_code, m_key, m_options.lanes, pointer(offsetof(SampleCall, view)),
                               where(), m_options.needed);
    for (std::size_t i = 0; i < 4; ++i)
      if (texel.rgba[i] && !m_options.onlyPacked)
        ir.CreateAlignedStore(texel.rgba[i],
                              element(offsetof(SampleCall, result) + sizeof(void *) * i),
                              llvm::Align(4));
    if (texel.packed)
      ir.CreateAlignedStore(texel.packed, element(offsetof(SampleCall, packed)), llvm::Align(4));
    Value *const next = ir.CreateAdd(chunk, ir.getInt32(1));
    chunk->addIncoming(next, ir.GetInsertBlock());
    ir.CreateCondBr(ir.CreateICmpULT(next, m_function->getArg(1)), loop, done);
    ir.SetInsertPoint(done);
    ir.CreateRetVoid();
    return texel.packed != nullptr;
  }

private:
  /// Loads a pointer. The test's arrays do not change while it runs, so that LLVM can hoist the
  /// load.
  Value *constant(llvm::Type *type, std::size_t offset) {
    auto *const load = m_code.ir.CreateLoad(
        type, m_code.ir.CreateConstInBoundsGEP1_64(m_code.ir.getInt8Ty(), m_call, offset));
    load->setMetadata(llvm::LLVMContext::MD_invariant_load,
                      llvm::MDNode::get(m_code.context(), {}));
    return load;
  }
  Value *pointer(std::size_t offset) { return constant(m_code.ir.getPtrTy(), offset); }
  Value *element(std::size_t offset) {
    return m_code.ir.CreateGEP(m_code.ir.getInt32Ty(), pointer(offset), m_first);
  }
  Value *vector(std::size_t offset) {
    return m_code.ir.CreateAlignedLoad(m_code.f32, element(offset), llvm::Align(4));
  }
  SampleAt where() {
    SampleAt at;
    for (std::size_t i = 0; i < 3; ++i) {
      at.coordinate[i] = vector(offsetof(SampleCall, coordinate) + sizeof(void *) * i);
      if (m_options.derivatives) {
        llvm::Type *const real = m_code.ir.getFloatTy();
        at.dx[i] = m_code.splat(constant(real, offsetof(SampleCall, dx) + 4 * i));
        at.dy[i] = m_code.splat(constant(real, offsetof(SampleCall, dy) + 4 * i));
      }
    }
    if (m_options.mask)
      at.mask = m_code.ir.CreateFCmpORD(at.coordinate[0], at.coordinate[0]);
    if (m_options.lod)
      at.lod = vector(offsetof(SampleCall, bias));
    else if (m_options.bias)
      at.bias = vector(offsetof(SampleCall, bias));
    if (m_options.texels) {
      const unsigned bytes = unsigned(abi::bytesOf(m_key.format.layout));
      at.texels = m_code.ir.CreateGEP(m_code.ir.getIntNTy(bytes * 8),
                                      pointer(offsetof(SampleCall, texels)), m_first);
    }
    return at;
  }

  Code &m_code;
  llvm::Function *m_function;
  const abi::SamplerKey &m_key;
  const SampleOptions &m_options;
  Value *m_call;
  Value *m_first = nullptr; ///< i64: index of the chunk's first pixel
};

llvm::SmallVector<char, 0> compiled(const Cpu &cpu, const abi::SamplerKey &key,
                                    const SampleOptions &options, Emit what, bool &packed,
                                    std::string &reason) {
  return emit(
      cpu, 1,
      [&](Code &code, llvm::Function *function, std::string &) {
        packed = Body(code, function, key, options).write();
        return true;
      },
      what, reason);
}

} // namespace

std::unique_ptr<SampleFunction> SampleFunction::make(const Cpu &cpu, const abi::SamplerKey &key,
                                                     const SampleOptions &options,
                                                     std::string &reason) {
  auto function = std::make_unique<SampleFunction>();
  const auto object = compiled(cpu, key, options, Emit::Object, function->m_packed, reason);
  if (object.empty())
    return nullptr;
  function->m_linked =
      Linked::link(llvm::MemoryBufferRef(llvm::StringRef(object.data(), object.size()), "sample"),
                   kEntrySymbol, reason);
  return function->m_linked ? std::move(function) : nullptr;
}

std::string SampleFunction::assembly(const Cpu &cpu, const abi::SamplerKey &key,
                                     const SampleOptions &options) {
  bool packed = false;
  std::string reason;
  const auto text = compiled(cpu, key, options, Emit::Assembly, packed, reason);
  return text.empty() ? reason : std::string(text.data(), text.size());
}

} // namespace arbiter::fp::llvm_back::testing
