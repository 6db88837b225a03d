#include "state/host_draw/undefined_results.h"

#include <vector>

#include "fp_compiler/ir/ir.h"

namespace arbiter::state {

namespace {

using fp::ir::Attribute;
using fp::ir::AttributeKind;
using fp::ir::OutputKind;

/// The built-in of a vertex shader for what a fragment attribute interpolates; empty for those that
/// no vertex gives.
std::string builtinOf(const Attribute &attribute) {
  switch (attribute.kind) {
  case AttributeKind::ColorPrimary:
    return "gl_FrontColor";
  case AttributeKind::ColorSecondary:
    return "gl_FrontSecondaryColor";
  case AttributeKind::FogCoord:
    return "gl_FogFragCoord";
  case AttributeKind::TexCoord:
    return "gl_TexCoord[" + std::to_string(attribute.index) + "]";
  case AttributeKind::Position:
  case AttributeKind::Normal:
  case AttributeKind::Generic:
    break;
  }
  return {};
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

std::string withMissingResults(const CompiledProgram &vertex, const CompiledProgram &fragment) {
  constexpr std::string_view kMain = "void main() {\n";
  const std::string &text = vertex.glsl.text;
  const std::size_t main = text.find(kMain);
  if (main == std::string::npos)
    return {};
  std::string definitions;
  for (const Attribute &attribute : readBy(*fragment.program)) {
    const std::string builtin = builtinOf(attribute);
    // A result that is written in part is defined as a whole already.
    if (builtin.empty() || text.find("  " + builtin) != std::string::npos ||
        definitions.find(builtin + " ") != std::string::npos)
      continue;
    const bool scalar = attribute.kind == AttributeKind::FogCoord;
    definitions += "  " + builtin + (scalar ? " = 0.0;\n" : " = vec4(0.0, 0.0, 0.0, 1.0);\n");
  }
  return definitions.empty() ? definitions
                             : std::string(text).insert(main + kMain.size(), definitions);
}

} // namespace arbiter::state
