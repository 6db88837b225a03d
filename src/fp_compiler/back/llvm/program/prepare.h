#pragma once
#include <memory>

#include "fp_compiler/analysis/live_values.h"
#include "fp_compiler/jit.h"

/// Programs prepared for compilation before a key is known: optimised for the mode, with their
/// requirements on the draw.
namespace arbiter::fp::llvm_back {

/// True if a key has a place for each unit that the program samples.
[[nodiscard]] bool hasCode(const ir::Program &program);

class PreparedFragment final : public jit::FragmentProgram {
public:
  PreparedFragment(ir::Program program, Numerics numerics);
  [[nodiscard]] const jit::FragmentShape &shape() const override { return m_shape; }
  [[nodiscard]] const ir::Program &program() const override { return m_program; }
  [[nodiscard]] Numerics numerics() const { return m_numerics; }

private:
  ir::Program m_program;
  Numerics m_numerics;
  jit::FragmentShape m_shape;
};

class PreparedVertex final : public jit::VertexProgram {
public:
  PreparedVertex(ir::Program program, Numerics numerics);
  [[nodiscard]] const jit::VertexShape &shape() const override { return m_shape; }
  [[nodiscard]] const ir::Program &program() const override { return m_program; }
  [[nodiscard]] Numerics numerics() const { return m_numerics; }

private:
  ir::Program m_program;
  Numerics m_numerics;
  jit::VertexShape m_shape;
};

} // namespace arbiter::fp::llvm_back
