#include "apps/tools/shader_test.h"

#include <algorithm>
#include <cstdio>

#include "fp_compiler/hw/profile.h"
#include "fp_compiler/ir/ir.h"

namespace arbiter::tools {

namespace {

using fp::ir::AttributeKind;
using fp::ir::Language;

/// The largest texture that a test makes. An application's own size has no effect on a program's
/// test.
constexpr unsigned kMaxTexture = 256;

/// Puts a space before each "[" at the start of a line, where it would begin a section of the test.
std::string asSection(std::string_view text) {
  std::string section;
  bool lineBegins = true;
  for (const char c : text) {
    if (lineBegins && c == '[')
      section += ' ';
    section += c;
    lineBegins = c == '\n';
  }
  return section.empty() || section.back() == '\n' ? section : section + "\n";
}

/// Returns a vertex program that writes a value to each attribute that the fragment program reads.
std::string feeder(const CapturedProgram &program) {
  std::string text = "!!ARBvp1.0\nMOV result.position, vertex.position;\n"
                     "MOV result.color, vertex.texcoord[0];\n";
  fp::CompileOptions options;
  const fp::hw::Profile *const host = fp::hw::findBuiltin("host");
  options.limits = (host ? *host : *fp::hw::findBuiltin(fp::hw::kDefaultProfile)).fragment;
  options.policy = fp::LimitPolicy::Report;
  const fp::CheckResult result = fp::checkProgram(program.target->language, program.text, options);
  if (result.ok())
    for (const fp::ir::Attribute &attribute : result.program->attributes) {
      if (attribute.kind == AttributeKind::TexCoord)
        text +=
            "MOV result.texcoord[" + std::to_string(attribute.index) + "], vertex.texcoord[0];\n";
      else if (attribute.kind == AttributeKind::ColorSecondary)
        text += "MOV result.color.secondary, vertex.texcoord[0];\n";
      else if (attribute.kind == AttributeKind::FogCoord)
        text += "MOV result.fogcoord.x, vertex.texcoord[0].x;\n";
    }
  return text + "END\n";
}

/// Returns the shader_runner word: "program.env[3]" becomes "env_fp 3". Returns nothing for other
/// rows.
std::string parameterWord(const std::string &name, const char *suffix) {
  for (const char *kind : {"env", "local"}) {
    const std::string head = std::string("program.") + kind + "[";
    if (name.starts_with(head) && name.ends_with("]"))
      return std::string(kind) + suffix + " " +
             name.substr(head.size(), name.size() - head.size() - 1);
  }
  return {};
}

std::string parameterLines(const CapturedProgram &program) {
  const char *const suffix = program.target->language == Language::ArbVertex ? "_vp" : "_fp";
  std::string text;
  for (const CapturedParameter &parameter : program.parameters) {
    char value[128];
    std::snprintf(value, sizeof value, " (%.9g, %.9g, %.9g, %.9g)\n", parameter.value[0],
                  parameter.value[1], parameter.value[2], parameter.value[3]);
    const std::string word = parameterWord(parameter.name, suffix);
    text += word.empty() ? "# was: " + parameter.name + value : "parameter " + word + value;
  }
  return text;
}

std::string textureLine(const CapturedTexture &texture) {
  const unsigned width = std::clamp(texture.width, 1u, kMaxTexture);
  const unsigned height = std::clamp(texture.height, 1u, kMaxTexture);
  const std::string unit = std::to_string(texture.unit);
  const std::string size = std::to_string(width) + ", " + std::to_string(height);
  const std::string was = "# unit " + unit + " was " + texture.target + " " +
                          std::to_string(texture.width) + "x" + std::to_string(texture.height) +
                          "x" + std::to_string(texture.depth) + " " + texture.format + "\n";
  if (texture.target == "2D")
    return was + "texture rgbw " + unit + " (" + size + ")\n";
  if (texture.target == "1D" || texture.target == "3D")
    return was + "texture rgbw " + texture.target + " " + unit + "\n";
  if (texture.target == "SHADOW2D")
    return was + "texture shadow2D " + unit + " (" + size + ")\n";
  if (texture.target == "SHADOWRECT")
    return was + "texture shadowRect " + unit + " (" + size + ")\n";
  if (texture.target == "SHADOW1D")
    return was + "texture shadow1D " + unit + " (" + std::to_string(width) + ")\n";
  return was + "# shader_runner makes no texture of this target: samples of it are undefined\n";
}

} // namespace

std::string shaderTest(const CapturedProgram &program, std::string &reason) {
  if (program.target->language == Language::AtiFragment) {
    reason = "shader_runner knows no ATI_text_fragment_shader";
    return {};
  }
  if (isNvparse(program.target->language)) {
    reason = "shader_runner knows no texts of nvparse's";
    return {};
  }
  if (program.text.find('\0') != std::string::npos) {
    reason = "the text has a NUL byte";
    return {};
  }
  const bool vertex = program.target->language == Language::ArbVertex;
  std::string text = "# " + program.file() + ", captured by arbiter.\n";
  if (!program.error.empty())
    text += "# The application's load of it was refused at byte " +
            std::to_string(program.errorPosition) + ", and so is this one.\n";
  text += "[require]\nGL >= 1.3\nGL_ARB_vertex_program\nGL_ARB_fragment_program\n\n";
  text += "[vertex program]\n" + (vertex ? asSection(program.text) : feeder(program)) + "\n";
  text += "[fragment program]\n" +
          (vertex ? std::string("!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n")
                  : asSection(program.text)) +
          "\n";
  text += "[test]\nclear color 0.0 0.0 0.0 0.0\nclear\n" + parameterLines(program);
  for (const CapturedTexture &texture : program.textures)
    text += textureLine(texture);
  return text + "draw rect tex -1 -1 2 2 0 0 1 1\n";
}

} // namespace arbiter::tools
