#include "fp_compiler/back/glsl/bindings.h"

namespace arbiter::fp::glsl {

using ir::AttributeKind;
using ir::OutputKind;

namespace {
std::string indexed(const char *name, int index) {
  return std::string(name) + "[" + std::to_string(index) + "]";
}

RegisterText fragmentAttribute(const ir::Attribute &attribute) {
  switch (attribute.kind) {
  case AttributeKind::ColorPrimary:
    return variable("gl_Color");
  case AttributeKind::ColorSecondary:
    return variable("gl_SecondaryColor");
  case AttributeKind::TexCoord:
    return variable(indexed("gl_TexCoord", attribute.index));
  case AttributeKind::FogCoord:
    return {"", {"gl_FogFragCoord", "0.0", "0.0", "1.0"}};
  case AttributeKind::Position:
    return variable("gl_FragCoord");
  case AttributeKind::Facing:
    return {"", {"(gl_FrontFacing ? 1.0 : -1.0)", "0.0", "0.0", "1.0"}};
  case AttributeKind::Normal:
  case AttributeKind::Generic:
    break; // only in vertex programs
  }
  return {};
}

/// Returns the text of a vertex attribute (table X.2 of ARB_vertex_program). Attribute 0 and the
/// position are the same.
RegisterText vertexAttribute(const ir::Attribute &attribute) {
  switch (attribute.kind) {
  case AttributeKind::ColorPrimary:
    return variable("gl_Color");
  case AttributeKind::ColorSecondary:
    return variable("gl_SecondaryColor");
  case AttributeKind::TexCoord:
    return variable("gl_MultiTexCoord" + std::to_string(attribute.index));
  case AttributeKind::FogCoord:
    return {"", {"gl_FogCoord", "0.0", "0.0", "1.0"}};
  case AttributeKind::Position:
    return variable("gl_Vertex");
  case AttributeKind::Normal:
    return {"", {"gl_Normal.x", "gl_Normal.y", "gl_Normal.z", "1.0"}};
  case AttributeKind::Generic:
    return variable(attribute.index == 0 ? "gl_Vertex" : genericName(attribute.index));
  case AttributeKind::Facing:
    break; // only in fragment programs
  }
  return {};
}
} // namespace

RegisterText variable(const std::string &name) {
  return {name, {name + ".x", name + ".y", name + ".z", name + ".w"}};
}

std::string genericName(int index) { return "arb_attrib" + std::to_string(index); }

RegisterText attributeText(ir::Language language, const ir::Attribute &attribute) {
  return language == ir::Language::ArbVertex ? vertexAttribute(attribute)
                                             : fragmentAttribute(attribute);
}

OutputText outputText(const ir::Program &program, const ir::Output &output) {
  switch (output.kind) {
  case OutputKind::Color:
    return {program.options.drawBuffers ? indexed("gl_FragData", output.index) : "gl_FragColor"};
  case OutputKind::Depth:
    return {"gl_FragDepth", true};
  case OutputKind::Position:
    return {"gl_Position"};
  case OutputKind::FrontPrimary:
    return {"gl_FrontColor"};
  case OutputKind::FrontSecondary:
    return {"gl_FrontSecondaryColor"};
  case OutputKind::BackPrimary:
    return {"gl_BackColor"};
  case OutputKind::BackSecondary:
    return {"gl_BackSecondaryColor"};
  case OutputKind::FogCoord:
    return {"gl_FogFragCoord", true};
  case OutputKind::PointSize:
    return {"gl_PointSize", true};
  case OutputKind::TexCoord:
    return {indexed("gl_TexCoord", output.index)};
  case OutputKind::ClipDistance: // a local; see clipDistances()
    return {"arb_clip" + std::to_string(output.index), true};
  case OutputKind::EnvParameter:
    break; // only in vertex state programs, which never become GLSL
  }
  return {};
}

} // namespace arbiter::fp::glsl
