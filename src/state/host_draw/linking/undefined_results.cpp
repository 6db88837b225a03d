#include "state/host_draw/linking/undefined_results.h"

#include <algorithm>
#include <optional>

#include "fp_compiler/ir/reads.h"

namespace arbiter::state {

namespace {

using fp::ir::Attribute;
using fp::ir::AttributeKind;
using fp::ir::Output;
using fp::ir::OutputKind;

/// Returns the built-in variable of a vertex shader.
std::string builtinOf(const Output &result) {
  switch (result.kind) {
  case OutputKind::FrontPrimary:
    return "gl_FrontColor";
  case OutputKind::FrontSecondary:
    return "gl_FrontSecondaryColor";
  case OutputKind::FogCoord:
    return "gl_FogFragCoord";
  default:
    return "gl_TexCoord[" + std::to_string(result.index) + "]";
  }
}

/// Returns the result that a fragment attribute interpolates, or none if vertices do not give it.
std::optional<Output> resultOf(const Attribute &attribute) {
  switch (attribute.kind) {
  case AttributeKind::ColorPrimary:
    return Output{OutputKind::FrontPrimary, 0};
  case AttributeKind::ColorSecondary:
    return Output{OutputKind::FrontSecondary, 0};
  case AttributeKind::FogCoord:
    return Output{OutputKind::FogCoord, 0};
  case AttributeKind::TexCoord:
    return Output{OutputKind::TexCoord, attribute.index};
  case AttributeKind::Position:
  case AttributeKind::Normal:
  case AttributeKind::Generic:
  case AttributeKind::Facing:
    break;
  }
  return std::nullopt;
}

/// True if the program writes the result. One that is bound but never written does not count.
bool writes(const fp::ir::Program &vertex, const Output &result) {
  return std::any_of(vertex.code.begin(), vertex.code.end(),
                     [&](const fp::ir::Instruction &instruction) {
                       return instruction.dst.file == fp::ir::File::Output &&
                              vertex.outputs[instruction.dst.index] == result;
                     });
}

std::vector<Attribute> readBy(const fp::ir::Program &fragment) {
  std::vector<Attribute> attributes = fragment.attributes;
  if (fragment.options.fog != fp::ir::FogMode::None)
    attributes.push_back({AttributeKind::FogCoord, 0});
  if (fragment.options.colorSum)
    attributes.push_back({AttributeKind::ColorSecondary, 0});
  return attributes;
}

} // namespace

std::vector<Output> missingResults(const CompiledProgram &vertex, const CompiledProgram &fragment) {
  std::vector<Output> missing;
  for (const Attribute &attribute : readBy(*fragment.program)) {
    const std::optional<Output> result = resultOf(attribute);
    if (result && !writes(*vertex.program, *result) &&
        std::find(missing.begin(), missing.end(), *result) == missing.end())
      missing.push_back(*result);
  }
  return missing;
}

fp::ir::Program withResults(fp::ir::Program vertex, const std::vector<Output> &missing) {
  fp::ir::Parameter value;
  value.constant = {0, 0, 0, 1};
  vertex.parameters.push_back(value);
  for (const Output &result : missing) {
    fp::ir::Instruction move;
    move.op = fp::ir::Opcode::Mov;
    move.dst.file = fp::ir::File::Output;
    move.dst.index = std::uint16_t(vertex.outputs.size());
    move.dst.mask = fp::ir::resultMask(result.kind);
    move.src[0].file = fp::ir::File::Parameter;
    move.src[0].index = std::uint16_t(vertex.parameters.size() - 1);
    vertex.outputs.push_back(result);
    vertex.code.push_back(move);
  }
  return vertex;
}

std::string glslWithResults(const CompiledProgram &vertex, const std::vector<Output> &missing) {
  constexpr std::string_view kMain = "void main() {\n";
  const std::string &text = vertex.glsl.text;
  const std::size_t main = text.find(kMain);
  if (main == std::string::npos || missing.empty())
    return {};
  std::string definitions;
  for (const Output &result : missing)
    definitions +=
        "  " + builtinOf(result) +
        (result.kind == OutputKind::FogCoord ? " = 0.0;\n" : " = vec4(0.0, 0.0, 0.0, 1.0);\n");
  return std::string(text).insert(main + kMain.size(), definitions);
}

} // namespace arbiter::state
