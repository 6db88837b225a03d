#include "tools/debug/pixel/cut.h"

#include <cassert>

#include "fp_compiler/ir/builder.h"

namespace arbiter::tools::debug {

namespace {

using fp::ir::Builder;
using fp::ir::File;
using fp::ir::Instruction;
using fp::ir::Opcode;
using fp::ir::Program;

/// The tables of a program, without its code and what it writes.
Program shell(const Program &program, std::size_t targets) {
  Program bare = program;
  bare.language = fp::ir::Language::ArbFragment;
  bare.code.clear();
  bare.outputs.clear();
  bare.options.fog = fp::ir::FogMode::None;
  bare.options.colorSum = false;
  bare.options.drawBuffers = targets > 1;
  for (std::size_t i = 0; i < targets; ++i)
    bare.outputs.push_back({fp::ir::OutputKind::Color, std::uint8_t(i)});
  return bare;
}

fp::ir::Destination colorTarget(std::size_t index) {
  fp::ir::Destination dst;
  dst.file = File::Output;
  dst.index = std::uint16_t(index);
  return dst;
}

Instruction moved(std::size_t target, const fp::ir::Operand &from) {
  Instruction move;
  move.op = Opcode::Mov;
  move.dst = colorTarget(target);
  move.src[0] = from;
  return move;
}

class Cutter {
public:
  Cutter(const Program &program, const std::vector<Probe> &probes)
      : m_program(program), m_probes(probes), m_cut(shell(program, probes.size())),
        m_firstOutput(program.temporaries.size()) {
    for (std::size_t i = 0; i < program.outputs.size(); ++i)
      m_cut.temporaries.push_back({"o" + std::to_string(i)});
  }

  Program run() {
    for (std::size_t row = 0; row <= m_probes.back().row; ++row) {
      probes(row, false);
      const Instruction &instruction = m_program.code[row];
      if (!fp::ir::info(instruction.op).has(fp::ir::Kills)) {
        m_cut.code.push_back(instruction);
        m_cut.code.back().dst = kept(instruction.dst);
      }
      probes(row, true);
    }
    return std::move(m_cut);
  }

private:
  /// What the program's results become: temporaries, which can be read.
  fp::ir::Destination kept(fp::ir::Destination dst) const {
    if (dst.file == File::Output) {
      dst.file = File::Temporary;
      dst.index = std::uint16_t(m_firstOutput + dst.index);
    }
    return dst;
  }

  /// The probes of a row that stand before or behind its instruction.
  void probes(std::size_t row, bool behind) {
    for (std::size_t i = 0; i < m_probes.size(); ++i)
      if (m_probes[i].row == row && (m_probes[i].kind == Probe::Kind::Value) == behind)
        probe(i, m_program.code[row]);
  }

  void probe(std::size_t target, const Instruction &instruction) {
    const Probe::Kind kind = m_probes[target].kind;
    if (kind == Probe::Kind::Texel) {
      Instruction access = instruction;
      access.dst = colorTarget(target);
      m_cut.code.push_back(access);
      return;
    }
    const bool kills = fp::ir::info(instruction.op).has(fp::ir::Kills);
    fp::ir::Operand from = instruction.src[0];
    if (kind == Probe::Kind::Value && !kills) {
      const fp::ir::Destination dst = kept(instruction.dst);
      from = {};
      from.file = dst.file;
      from.index = dst.index;
    }
    m_cut.code.push_back(moved(target, from));
  }

  const Program &m_program;
  const std::vector<Probe> &m_probes;
  Program m_cut;
  std::size_t m_firstOutput;
};

} // namespace

Program cutProgram(const Program &program, const std::vector<Probe> &probes) {
  assert(!probes.empty() && probes.size() <= kMostTargets);
  return Cutter(program, probes).run();
}

Program showOperands(const Program &program, const std::vector<fp::ir::Operand> &operands) {
  assert(!operands.empty() && operands.size() <= kMostTargets);
  Program shown = shell(program, operands.size());
  for (std::size_t i = 0; i < operands.size(); ++i)
    shown.code.push_back(moved(i, operands[i]));
  return shown;
}

Program sampleQuad(const Program &program, std::uint8_t unit, fp::ir::TexTarget target, bool biased,
                   int x, int y, const std::array<fp::ir::Vec4, 4> &coordinates) {
  Builder b;
  b.options().shadow = program.options.shadow;
  const auto constant = [&](const fp::ir::Vec4 &v) { return b.constant(v[0], v[1], v[2], v[3]); };
  const auto side = b.temporary(), lower = b.temporary(), upper = b.temporary();
  // Below zero in the left, and in the lower, pixels.
  b.op(
      Opcode::Sub, side,
      {b.attribute(fp::ir::AttributeKind::Position), b.constant(float(x) + 1, float(y) + 1, 0, 0)});
  b.op(Opcode::Cmp, lower,
       {side.read().swz("x"), constant(coordinates[0]), constant(coordinates[1])});
  b.op(Opcode::Cmp, upper,
       {side.read().swz("x"), constant(coordinates[2]), constant(coordinates[3])});
  b.op(Opcode::Cmp, lower, {side.read().swz("y"), lower.read(), upper.read()});
  b.tex(biased ? Opcode::Txb : Opcode::Tex, b.color(), lower.read(), unit, target);
  return b.take();
}

} // namespace arbiter::tools::debug
