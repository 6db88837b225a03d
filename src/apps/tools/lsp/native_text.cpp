#include "apps/tools/lsp/native_text.h"

#include <cstdio>

#include "apps/tools/language.h"
#include "fp_compiler/compiler.h"

namespace arbiter::tools::lsp {

namespace {

/// Returns a program of one instruction, with a different attribute for each operand.
std::string programOf(const fp::ir::OpInfo &op, bool vertex) {
  // A sample goes to a temporary, because moving a sample to a result costs one more slot.
  const bool sample = op.has(fp::ir::Texture);
  std::string text = vertex ? "!!ARBvp1.0\nADDRESS A0;\n" : "!!ARBfp1.0\nTEMP t;\n";
  text += op.mnemonic;
  if (op.has(fp::ir::Kills))
    text += " ";
  else if (std::string_view(op.mnemonic) == "ARL")
    text += " A0.x, ";
  else
    text += vertex ? " result.texcoord, " : sample ? " t, " : " result.color, ";
  for (int i = 0; i < op.operandCount(); ++i) {
    text += i > 0 ? ", " : "";
    text += (vertex ? "vertex.texcoord[" : "fragment.texcoord[") + std::to_string(i) + "]";
    text += op.shapes[i] == 'S' ? ".x" : "";
  }
  if (std::string_view(op.mnemonic) == "SWZ")
    text += ", y, -x, 0, 1";
  if (sample)
    text += ", texture[0], 2D;\nMOV result.color, t";
  return text + ";\nEND\n";
}

struct Measured {
  fp::Limits limits;
  fp::CheckResult check;
};

Measured measure(fp::ir::Opcode opcode, const fp::hw::Profile &profile) {
  const fp::ir::OpInfo &op = info(opcode);
  const bool vertex = op.has(fp::ir::VertexOnly);
  const auto language = vertex ? fp::ir::Language::ArbVertex : fp::ir::Language::ArbFragment;
  fp::CompileOptions options;
  options.limits = limitsOf(profile, language);
  return {options.limits, fp::checkProgram(language, programOf(op, vertex), options)};
}

} // namespace

std::string costText(double slots, std::uint32_t textures) {
  char number[32];
  std::snprintf(number, sizeof number, "%.3g", slots);
  std::string text;
  if (slots > 0)
    text = std::string(number) + (slots == 1 ? " slot" : " slots");
  if (textures > 0)
    text += (text.empty() ? "" : ", ") + std::to_string(textures) + " TEX";
  return text.empty() ? "no slot" : text;
}

bool opcodeLoads(fp::ir::Opcode op, const fp::hw::Profile &profile) {
  return measure(op, profile).check.ok();
}

std::string costOfOpcode(fp::ir::Opcode op, const fp::hw::Profile &profile) {
  const Measured measured = measure(op, profile);
  if (!measured.check.ok())
    return {};
  const fp::hw::NativeReport report =
      fp::hw::explainNative(*measured.check.program, measured.check.counts, measured.limits);
  if (report.costs.empty())
    return {};
  return "alone on " + profile.name + ": " +
         costText(report.costs[0].slots, report.costs[0].textures);
}

} // namespace arbiter::tools::lsp
