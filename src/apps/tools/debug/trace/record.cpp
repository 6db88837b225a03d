#include "apps/tools/debug/trace/record.h"

#include <cmath>
#include <map>
#include <utility>

#include "apps/tools/check/source_text.h"
#include "apps/tools/debug/trace/condition.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::tools::debug {

namespace {

using fp::Numerics;

constexpr std::size_t kLongestStatement = 200;

bool isSame(const fp::ir::Parameter &a, const fp::ir::Parameter &b) {
  if (a.kind != b.kind || a.kind == fp::ir::ParameterKind::Constant)
    return false;
  return a.kind == fp::ir::ParameterKind::State ? a.state == b.state : a.index == b.index;
}

Vec4 valueOf(const fp::ir::Parameter &wanted, const Program &program, const TraceInputs &given) {
  for (std::size_t i = 0; i < program.parameters.size() && i < given.parameters.size(); ++i)
    if (isSame(program.parameters[i], wanted))
      return given.parameters[i];
  // The fog options read these parameters even if the program does not.
  if (wanted.kind == fp::ir::ParameterKind::State) {
    if (wanted.state.item == fp::ir::StateItem::FogColor)
      return given.fogColor;
    if (wanted.state.item == fp::ir::StateItem::FogParams)
      return given.fogParams;
  }
  return {};
}

/// The result of one interpreter run.
struct Run {
  std::vector<fp::ir::Step> steps;
  std::vector<Vec4> texels; ///< by index of the instruction
  fp::ir::Evaluation end;
};

Run runWith(const Program &program, const TraceInputs &given, Numerics numerics) {
  Run run;
  run.texels.resize(program.code.size());
  fp::ir::Inputs inputs = interpreterInputs(program, given, numerics);
  inputs.pastKill = true;
  inputs.observer = [&](const fp::ir::Step &step) { run.steps.push_back(step); };
  const auto texture = inputs.texture;
  inputs.texture = [&](const fp::ir::Sample &sample) {
    // The sampling instruction follows the last completed one.
    return texture
               ? run.texels[run.steps.size()] = given.texture(run.steps.size(), sample, numerics)
               : Vec4{};
  };
  run.end = fp::ir::evaluate(program, inputs);
  return run;
}

/// Returns the program's text at the span, or `otherwise` if the span is empty.
std::string textOr(const SourceText &source, fp::Span span, const std::string &otherwise) {
  return span.end > span.begin ? source.statement(span, kLongestStatement) : otherwise;
}

unsigned flagsOf(const Vec4 &value, std::uint8_t mask) {
  unsigned flags = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    if (!(mask >> c & 1))
      continue;
    flags |= std::isnan(value[c]) ? kNan : 0u;
    flags |= std::isinf(value[c]) ? kInf : 0u;
    flags |= value[c] > 1.0f ? kOver1 : 0u;
    flags |= value[c] < 0.0f ? kBelow0 : 0u;
  }
  return flags;
}

Vec4 errorOf(const Both<Vec4> &value, std::uint8_t mask) {
  Vec4 error = {};
  for (std::size_t c = 0; c < 4; ++c) {
    const float a = value.first[c], b = value.second[c];
    const bool same = a == b || (std::isnan(a) && std::isnan(b));
    if ((mask >> c & 1) && !same)
      error[c] = b - a;
  }
  return error;
}

class Recorder {
public:
  Recorder(const Program &program, std::string_view text, const TraceInputs &given,
           Both<Numerics> numerics)
      : m_program(program), m_given(given), m_source(text),
        m_numerics(numerics), m_runs{runWith(program, given, numerics.first),
                                     runWith(program, given, numerics.second)},
        m_written(program.temporaries.size(), 0), m_outputs(program.outputs.size(), 0) {}

  Trace record() {
    Trace trace;
    trace.language = m_program.language;
    trace.numerics = m_numerics;
    for (std::size_t i = 0; i < m_program.code.size(); ++i)
      trace.rows.push_back(row(i));
    names(trace);
    results(trace);
    trace.isDiscarded = {m_runs.first.end.killed, m_runs.second.end.killed};
    return trace;
  }

private:
  /// Returns the components of an operand that read register components without a value.
  std::uint8_t unwritten(const fp::ir::Operand &operand, std::uint8_t reads) const {
    std::uint8_t mask = 0;
    if (operand.file != File::Temporary)
      return 0;
    for (std::size_t c = 0; c < 4; ++c) {
      const auto select = operand.swizzle[c];
      if ((reads >> c & 1) && select <= fp::ir::Select::W &&
          !(m_written[operand.index] >> int(select) & 1))
        mask |= std::uint8_t(1 << c);
    }
    return mask;
  }

  Operand operand(std::size_t index, int which) const {
    const Instruction &instruction = m_program.code[index];
    const fp::ir::Operand &from = instruction.src[std::size_t(which)];
    Operand operand;
    operand.span = from.span;
    operand.text = textOr(m_source, from.span, "?");
    operand.file = from.file;
    operand.reg = from.index;
    operand.reads = fp::ir::operandMask(instruction, which);
    operand.unwritten = unwritten(from, operand.reads);
    operand.value = {m_runs.first.steps[index].operands[std::size_t(which)],
                     m_runs.second.steps[index].operands[std::size_t(which)]};
    return operand;
  }

  std::optional<Texel> texel(std::size_t index) const {
    const auto &first = m_runs.first.steps[index].sample,
               &second = m_runs.second.steps[index].sample;
    if (!first || !second)
      return {};
    Texel texel;
    texel.unit = first->unit;
    texel.target = first->target;
    texel.coordinate = {first->coordinate, second->coordinate};
    texel.bias = {first->bias, second->bias};
    texel.value = {m_runs.first.texels[index], m_runs.second.texels[index]};
    if (m_given.lod)
      texel.lod = m_given.lod(index);
    return texel;
  }

  void destination(const fp::ir::Destination &dst, Row &row) {
    row.destination = textOr(m_source, dst.span, "?");
    row.file = dst.file;
    row.reg = dst.index;
    row.mask = dst.file == File::Address ? 1 : dst.mask;
    row.name =
        m_names.try_emplace({dst.file, dst.index}, registerName(row.destination)).first->second;
    if (dst.file == File::Temporary)
      m_written[dst.index] |= dst.mask;
    if (dst.file == File::Output)
      m_outputs[dst.index] |= dst.mask;
  }

  Row row(std::size_t index) {
    const Instruction &instruction = m_program.code[index];
    const fp::ir::OpInfo &info = fp::ir::info(instruction.op);
    const fp::ir::Step &first = m_runs.first.steps[index], &second = m_runs.second.steps[index];
    Row row;
    row.span = instruction.span;
    row.at = m_source.at(instruction.span.begin);
    row.text = textOr(m_source, instruction.span, fp::ir::print(instruction));
    row.op = instruction.op;
    row.isDiscarded = m_isDiscarded;
    for (int i = 0; i < info.operandCount(); ++i) {
      row.operands.push_back(operand(index, i));
      row.flags |= row.operands.back().unwritten ? kUnwritten : 0u;
    }
    row.value = {first.value, second.value};
    row.discards = {first.discards, second.discards};
    row.texel = texel(index);
    m_isDiscarded |= first.discards;
    if (!info.has(fp::ir::Kills))
      destination(instruction.dst, row);
    row.flags |= flagsOf(row.value.first, row.mask);
    row.error = errorOf(row.value, row.mask);
    return row;
  }

  void names(Trace &trace) const {
    for (std::size_t i = 0; i < m_program.attributes.size(); ++i) {
      const Vec4 value = i < m_given.attributes.size() ? m_given.attributes[i] : Vec4{};
      trace.attributes.push_back(
          {fp::ir::bindingText(m_program.attributes[i], m_program.language), {value, value}, 0xF});
    }
    for (const fp::ir::Parameter &parameter : m_program.parameters) {
      if (parameter.kind == fp::ir::ParameterKind::Constant)
        continue;
      const Vec4 value = valueOf(parameter, m_program, m_given);
      trace.parameters.push_back({fp::ir::bindingText(parameter), {value, value}, 0xF});
    }
  }

  /// Returns a result's name; a program without draw buffers calls its color result.color.
  std::string resultName(const fp::ir::Output &output) const {
    const bool single = output.kind == fp::ir::OutputKind::Color && !m_program.options.drawBuffers;
    return single ? "result.color" : fp::ir::bindingText(output);
  }

  void results(Trace &trace) const {
    for (std::size_t i = 0; i < m_program.outputs.size(); ++i)
      trace.results.push_back({resultName(m_program.outputs[i]),
                               {m_runs.first.end.outputs[i], m_runs.second.end.outputs[i]},
                               m_outputs[i]});
  }

  const Program &m_program;
  const TraceInputs &m_given;
  SourceText m_source;
  Both<Numerics> m_numerics;
  Both<Run> m_runs;
  std::vector<std::uint8_t> m_written, m_outputs;           ///< components written so far
  std::map<std::pair<File, unsigned>, std::string> m_names; ///< by register
  bool m_isDiscarded = false;
};

} // namespace

fp::ir::Inputs interpreterInputs(const Program &program, const TraceInputs &given,
                                 Numerics numerics) {
  fp::ir::Inputs inputs;
  inputs.attributes = given.attributes;
  inputs.parameter = [&](const fp::ir::Parameter &parameter) {
    return valueOf(parameter, program, given);
  };
  if (given.texture)
    inputs.texture = [](const fp::ir::Sample &) { return Vec4{}; };
  inputs.fogCoordinate = given.fogCoordinate;
  inputs.secondary = given.secondary;
  inputs.numerics = numerics;
  return inputs;
}

Trace record(const Program &program, std::string_view text, const TraceInputs &given,
             Both<Numerics> numerics) {
  return Recorder(program, text, given, numerics).record();
}

} // namespace arbiter::tools::debug
