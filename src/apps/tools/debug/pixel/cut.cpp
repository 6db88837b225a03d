#include "apps/tools/debug/pixel/cut.h"

#include <algorithm>
#include <cassert>

#include "fp_compiler/ir/builder.h"

namespace arbiter::tools::debug {

namespace {

/// Returns a program with the tables of another, without its code. Its only outputs are colours,
/// one for each target, and no option changes them after they are written.
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

bool isDepth(const fp::ir::Output &output) { return output.kind == fp::ir::OutputKind::Depth; }

fp::ir::Destination colorTarget(std::size_t index) {
  fp::ir::Destination dst;
  dst.file = File::Output;
  dst.index = std::uint16_t(index);
  return dst;
}

/// Returns a MOV of an operand to a target.
Instruction moveToTarget(std::size_t target, const fp::ir::Operand &from) {
  Instruction move;
  move.op = Opcode::Mov;
  move.dst = colorTarget(target);
  move.src[0] = from;
  return move;
}

/// Builds a program that shows values: it copies instructions of the original program, and inserts
/// writes of its colour targets.
class Cutter {
public:
  Cutter(const Program &program, std::size_t targets, Fragments fragments)
      : m_program(program), m_fragments(fragments), m_cut(shell(program, targets)),
        m_standIns(program.temporaries.size()) {
    for (std::size_t i = 0; i < program.outputs.size(); ++i)
      m_cut.temporaries.push_back({"o" + std::to_string(i)});
  }

  Program withProbes(const std::vector<Probe> &probes) {
    // KIL and depth after the last probe also decide which fragments survive.
    const bool whole = m_fragments == Fragments::Surviving;
    const std::size_t end = whole ? m_program.code.size() : probes.back().row + 1;
    for (std::size_t row = 0; row < end; ++row) {
      addProbes(probes, row, false);
      copy(m_program.code[row]);
      addProbes(probes, row, true);
    }
    addDepth();
    return std::move(m_cut);
  }

  Program withOperands(const std::vector<fp::ir::Operand> &operands) {
    for (std::size_t i = 0; i < operands.size(); ++i)
      m_cut.code.push_back(moveToTarget(i, operands[i]));
    if (m_fragments == Fragments::Surviving)
      for (const Instruction &instruction : m_program.code)
        copy(instruction);
    addDepth();
    return std::move(m_cut);
  }

private:
  /// Redirects outputs to temporaries, which can be read.
  fp::ir::Destination readable(fp::ir::Destination dst) const {
    if (dst.file == File::Output) {
      dst.file = File::Temporary;
      dst.index = std::uint16_t(m_standIns + dst.index);
    }
    return dst;
  }

  /// Copies an instruction of the original program. KIL is left out if all fragments are shown.
  void copy(const Instruction &instruction) {
    if (fp::ir::info(instruction.op).has(fp::ir::Kills)) {
      if (m_fragments == Fragments::Surviving)
        m_cut.code.push_back(instruction);
      return;
    }
    m_cut.code.push_back(instruction);
    m_cut.code.back().dst = readable(instruction.dst);
  }

  /// Writes the program's own depth, if the program has one and fragments are tested with it.
  void addDepth() {
    if (m_fragments != Fragments::Surviving)
      return;
    for (std::size_t i = 0; i < m_program.outputs.size(); ++i) {
      if (m_program.outputs[i].kind != fp::ir::OutputKind::Depth)
        continue;
      fp::ir::Operand depth;
      depth.index = std::uint16_t(m_standIns + i);
      m_cut.code.push_back(moveToTarget(m_cut.outputs.size(), depth));
      m_cut.code.back().dst.mask = 4; // result.depth is a z component
      m_cut.outputs.push_back(m_program.outputs[i]);
      return;
    }
  }

  /// Adds the probes of a row that come before or after its instruction.
  void addProbes(const std::vector<Probe> &probes, std::size_t row, bool behind) {
    for (std::size_t i = 0; i < probes.size(); ++i)
      if (probes[i].row == row && (probes[i].kind == Probe::Kind::Value) == behind)
        addProbe(probes[i].kind, i, m_program.code[row]);
  }

  void addProbe(Probe::Kind kind, std::size_t target, const Instruction &instruction) {
    if (kind == Probe::Kind::Texel) {
      Instruction access = instruction;
      access.dst = colorTarget(target);
      m_cut.code.push_back(access);
      return;
    }
    const bool kills = fp::ir::info(instruction.op).has(fp::ir::Kills);
    fp::ir::Operand from = instruction.src[0]; // the coordinate, or KIL's operand
    if (kind == Probe::Kind::Value && !kills) {
      const fp::ir::Destination dst = readable(instruction.dst);
      from = {};
      from.file = dst.file;
      from.index = dst.index;
    }
    m_cut.code.push_back(moveToTarget(target, from));
  }

  const Program &m_program;
  const Fragments m_fragments;
  Program m_cut;
  std::size_t m_standIns; ///< the temporary that stands for the original output 0
};

} // namespace

bool decidesFragments(const Program &program) {
  return std::any_of(program.code.begin(), program.code.end(),
                     [](const Instruction &instruction) {
                       return fp::ir::info(instruction.op).has(fp::ir::Kills);
                     }) ||
         writesDepth(program);
}

bool writesDepth(const Program &program) {
  return std::any_of(program.outputs.begin(), program.outputs.end(), isDepth);
}

Program withoutDepth(const Program &program) {
  Program cut = program;
  std::erase_if(cut.outputs, isDepth);
  const auto unread = std::uint16_t(cut.temporaries.size());
  cut.temporaries.push_back({"depth"});
  for (Instruction &instruction : cut.code) {
    fp::ir::Destination &dst = instruction.dst;
    if (fp::ir::info(instruction.op).has(fp::ir::Kills) || dst.file != File::Output)
      continue;
    const fp::ir::Output output = program.outputs[dst.index];
    if (isDepth(output)) {
      dst.file = File::Temporary;
      dst.index = unread;
    } else {
      dst.index = std::uint16_t(std::find(cut.outputs.begin(), cut.outputs.end(), output) -
                                cut.outputs.begin());
    }
  }
  return cut;
}

Program cutProgram(const Program &program, const std::vector<Probe> &probes, Fragments fragments) {
  assert(!probes.empty() && probes.size() <= kMaxTargets);
  return Cutter(program, probes.size(), fragments).withProbes(probes);
}

Program showOperands(const Program &program, const std::vector<fp::ir::Operand> &operands,
                     Fragments fragments) {
  assert(!operands.empty() && operands.size() <= kMaxTargets);
  return Cutter(program, operands.size(), fragments).withOperands(operands);
}

Program sampleQuad(const Program &program, std::uint8_t unit, fp::ir::TexTarget target,
                   bool biased) {
  fp::ir::Builder b;
  b.options().shadow = program.options.shadow;
  // Parameters 0 to 3 are coordinates, and parameter 4 is the middle of the quad.
  const auto side = b.temporary(), lower = b.temporary(), upper = b.temporary();
  // x is negative in the left pixels, and y in the lower pixels.
  b.op(Opcode::Sub, side, {b.attribute(fp::ir::AttributeKind::Position), b.local(4)});
  b.op(Opcode::Cmp, lower, {side.read().swz("x"), b.local(0), b.local(1)});
  b.op(Opcode::Cmp, upper, {side.read().swz("x"), b.local(2), b.local(3)});
  b.op(Opcode::Cmp, lower, {side.read().swz("y"), lower.read(), upper.read()});
  b.tex(biased ? Opcode::Txb : Opcode::Tex, b.color(), lower.read(), unit, target);
  return b.take();
}

} // namespace arbiter::tools::debug
