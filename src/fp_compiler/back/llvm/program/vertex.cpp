#include "fp_compiler/back/llvm/program/vertex.h"

#include <algorithm>

#include "fp_compiler/back/llvm/program/program.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::llvm_back {

namespace {
constexpr int kRowBytes = 4 * int(sizeof(float));

/// Provides a vertex program's registers from memory.
class VertexHooks final : public ProgramHooks {
public:
  /// \param count the number of vertices, an i64
  VertexHooks(Code &code, const PreparedVertex &program, const abi::VertexKey &key, Value *data,
              Value *count)
      : m_code(code), m_ir(code.ir), m_program(program.program()), m_shape(program.shape()),
        m_key(key), m_data(data), m_count(count),
        m_parameters(pointer(data, offsetof(abi::VertexData, parameters))),
        m_inputs(pointer(data, offsetof(abi::VertexData, inputs))),
        m_outputs(pointer(data, offsetof(abi::VertexData, outputs))) {}

  /// Sets the first vertex of the vector, an i64.
  void at(Value *first) { m_first = first; }

  Vec attribute(int index, unsigned needed) override {
    const auto &inputs = m_shape.inputs;
    const auto found =
        std::find(inputs.begin(), inputs.end(), m_program.attributes[std::size_t(index)]);
    const int input = int(found - inputs.begin());
    Vec value = {};
    for (int i = 0; i < 4; ++i)
      if (needed >> i & 1)
        value[std::size_t(i)] =
            m_ir.CreateAlignedLoad(m_code.f32, lane(m_inputs, 4 * input + i), alignment());
    return value;
  }

  Vec parameter(int index, unsigned needed) override {
    Vec value = {};
    for (int i = 0; i < 4; ++i)
      if (needed >> i & 1)
        value[std::size_t(i)] = m_code.splat(
            constant(m_code.field(m_ir.getFloatTy(), m_parameters,
                                  std::size_t(index * kRowBytes + i * int(sizeof(float))))));
    return value;
  }

  /// Samples a texture. A vertex has no neighbours, so the level of detail is 0 before biases and
  /// clamps if the instruction gives none. TXB is TXL (NV_vertex_program3).
  Vec texture(const ir::Instruction &instruction, const std::array<Vec, 3> &operands,
              unsigned needed) override {
    const Vec &operand = operands[0];
    const bool isGiven = instruction.op == ir::Opcode::Txl || instruction.op == ir::Opcode::Txb;
    SampleAt at;
    at.lod = isGiven && operand[3] ? operand[3] : m_code.splat(0.0f); // a rectangle has no w
    for (std::size_t c = 0; c < 3; ++c)
      if (operand[c])
        at.coordinate[c] = instruction.op == ir::Opcode::Txp
                               ? m_ir.CreateFDiv(operand[c], operand[3])
                               : operand[c];
    at.mask = wanted();
    if (running())
      at.mask = m_ir.CreateAnd(at.mask, running());
    Value *const views = pointer(m_data, offsetof(abi::VertexData, textures));
    Value *const view = pointer(views, sizeof(void *) * instruction.unit);
    return sample(m_code, m_key.samplers[instruction.unit], abi::Lanes::Row, view, at, needed).rgba;
  }
  void kill(Value *) override {}
  /// Returns the lanes of existing vertices. After the last one, memory may hold anything.
  Value *wanted() override {
    Value *const left = m_ir.CreateTrunc(m_ir.CreateSub(m_count, m_first), m_ir.getInt32Ty());
    return m_ir.CreateICmpULT(m_code.iota(), m_code.splat(left));
  }

  Vec relative(int array, Value *index, unsigned needed) override {
    const auto &rows = m_program.arrays[std::size_t(array)].rows;
    Value *const inside = m_ir.CreateICmpULT(index, m_code.splat(int(rows.size())), "inside");
    Value *const row = m_code.select(inside, index, m_code.splat(0));
    Value *const bytes = m_ir.CreateMul(rowOf(rows, row, inside), m_code.splat(kRowBytes));
    Vec value = {};
    for (int i = 0; i < 4; ++i)
      if (needed >> i & 1) {
        Value *const at = m_ir.CreateAdd(bytes, m_code.splat(i * int(sizeof(float))));
        value[std::size_t(i)] = gather(m_code.f32, m_parameters, at, inside);
      }
    return value;
  }

  void store(const ProgramResults &results) {
    for (std::size_t i = 0; i < m_program.outputs.size(); ++i) {
      const auto found =
          std::find(m_shape.outputs.begin(), m_shape.outputs.end(), m_program.outputs[i]);
      if (found == m_shape.outputs.end())
        continue;
      const int output = int(found - m_shape.outputs.begin());
      const std::uint8_t counts = ir::resultMask(found->kind);
      for (int c = 0; c < 4; ++c) {
        Value *const value = results.outputs[i][std::size_t(c)];
        if (counts >> c & 1)
          m_ir.CreateAlignedStore(value ? value : m_code.splat(0.0f),
                                  lane(m_outputs, 4 * output + c), alignment());
      }
    }
  }

private:
  Value *pointer(Value *from, std::size_t offset) {
    return constant(m_code.field(m_ir.getPtrTy(), from, offset));
  }
  /// Marks a load from memory that does not change during the call.
  Value *constant(Value *load) {
    llvm::cast<llvm::LoadInst>(load)->setMetadata(llvm::LLVMContext::MD_invariant_load,
                                                  llvm::MDNode::get(m_code.context(), {}));
    return load;
  }
  /// Returns the address of element `index` of a table of arrays, at the current vertices.
  Value *lane(Value *table, int index) {
    Value *const array = pointer(table, std::size_t(index) * sizeof(void *));
    return m_ir.CreateInBoundsGEP(m_ir.getFloatTy(), array, m_first);
  }
  [[nodiscard]] llvm::Align alignment() const {
    return llvm::Align(std::uint64_t(m_code.lanes) * sizeof(float));
  }

  Value *gather(llvm::VectorType *type, Value *base, Value *bytes, Value *mask) {
    Value *const pointers = m_ir.CreateGEP(m_ir.getInt8Ty(), base, bytes);
    return m_ir.CreateMaskedGather(type, pointers, llvm::Align(4), mask,
                                   llvm::Constant::getNullValue(type));
  }

  /// Returns indices into Program::parameters for elements of an array.
  Value *rowOf(const std::vector<std::uint16_t> &rows, Value *element, Value *inside) {
    const bool inOrder = std::adjacent_find(rows.begin(), rows.end(),
                                            [](int a, int b) { return b != a + 1; }) == rows.end();
    if (inOrder)
      return m_ir.CreateAdd(element, m_code.splat(rows.empty() ? 0 : int(rows[0])));
    const std::vector<std::uint32_t> wide(rows.begin(), rows.end());
    llvm::Constant *const table = llvm::ConstantDataArray::get(m_code.context(), wide);
    // The module owns the variable.
    auto *const variable =
        new llvm::GlobalVariable(*m_ir.GetInsertBlock()->getModule(), table->getType(), true,
                                 llvm::GlobalValue::PrivateLinkage, table, "rows");
    return gather(m_code.i32, variable, m_ir.CreateShl(element, m_code.splat(2)), inside);
  }

  Code &m_code;
  llvm::IRBuilder<> &m_ir;
  const ir::Program &m_program;
  const jit::VertexShape &m_shape;
  const abi::VertexKey &m_key;
  Value *m_data, *m_count, *m_parameters, *m_inputs, *m_outputs;
  Value *m_first = nullptr;
};
} // namespace

void writeVertex(Code &code, llvm::Function *function, const PreparedVertex &program,
                 const abi::VertexKey &key) {
  llvm::IRBuilder<> &ir = code.ir;
  auto *const entry = llvm::BasicBlock::Create(code.context(), "entry", function);
  auto *const loop = llvm::BasicBlock::Create(code.context(), "loop", function);
  auto *const end = llvm::BasicBlock::Create(code.context(), "end", function);
  ir.SetInsertPoint(entry);
  Value *const count = ir.CreateZExt(function->getArg(1), ir.getInt64Ty());
  VertexHooks hooks(code, program, key, function->getArg(0), count);
  ir.CreateCondBr(ir.CreateICmpEQ(count, ir.getInt64(0)), end, loop);

  ir.SetInsertPoint(loop);
  llvm::PHINode *const first = ir.CreatePHI(ir.getInt64Ty(), 2, "first");
  first->addIncoming(ir.getInt64(0), entry);
  hooks.at(first);
  hooks.store(writeProgram(code, program.program(), program.numerics(), hooks));
  Value *const next = ir.CreateAdd(first, ir.getInt64(std::uint64_t(code.lanes)));
  first->addIncoming(next, ir.GetInsertBlock());
  ir.CreateCondBr(ir.CreateICmpULT(next, count), loop, end);

  ir.SetInsertPoint(end);
  ir.CreateRetVoid();
}

} // namespace arbiter::fp::llvm_back
