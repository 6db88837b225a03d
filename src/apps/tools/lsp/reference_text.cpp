#include "apps/tools/lsp/reference_text.h"

namespace arbiter::tools::lsp {

namespace {

struct TraitText {
  fp::ir::Trait trait;
  const char *text;
};
constexpr TraitText kTraits[] = {
    {fp::ir::PerComponent, "each component by itself"},
    {fp::ir::Replicates, "one value in all four components"},
    {fp::ir::Commutative, "the first two operands may change places"},
    {fp::ir::Texture, "samples a texture"},
    {fp::ir::Kills, "no destination"},
    {fp::ir::FixedMask, "writes some components only; the others are zero here"},
    {fp::ir::VertexOnly, "vertex programs only"},
    {fp::ir::FragmentOnly, "fragment programs only"},
};

std::string operands(int count, const char *shapes) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    text += i > 0 ? ", " : "";
    text += char('a' + i);
    text += shapes && shapes[i] == 'S' ? ".x" : "";
  }
  return text;
}

} // namespace

std::string codeBlock(std::string_view text) {
  return "```arbprogram\n" + std::string(text) + "\n```\n";
}

std::string sectionText(std::string_view section) {
  if (section.empty())
    return {};
  const char *name = section.starts_with("2.") ? "ARB_vertex_program"
                     : section == "3.10.1"     ? "ATI_text_fragment_shader"
                                               : "ARB_fragment_program";
  return "\n\n*" + std::string(name) + " " + std::string(section) + "*";
}

namespace {
/// Returns the section of the first extension with an opcode of NVIDIA's options.
std::string nvSectionText(const fp::ir::OpInfo &op) {
  const char *name = op.has(fp::ir::OfF1)   ? "NV_fragment_program_option"
                     : op.has(fp::ir::OfF2) ? "NV_fragment_program2"
                     : op.has(fp::ir::OfV2) ? "NV_vertex_program2_option"
                                            : "NV_vertex_program3";
  return "\n\n*" + std::string(name) + " " + std::string(op.section) + "*";
}
} // namespace

std::string signatureOf(fp::ir::Opcode opcode, fp::ir::Language language) {
  const fp::ir::OpInfo &op = info(opcode);
  std::string text = op.mnemonic;
  if (op.has(fp::ir::Flow))
    return op.operandCount() == 0 ? text : text + " " + operands(op.operandCount(), op.shapes);
  if (op.has(fp::ir::Kills))
    return text + " " + operands(op.operandCount(), op.shapes);
  if (language == fp::ir::Language::ArbFragment)
    text += "[_SAT]";
  text += opcode == fp::ir::Opcode::Arl ? " A.x, " : " result, ";
  text += operands(op.operandCount(), op.shapes);
  if (opcode == fp::ir::Opcode::Swz)
    text += ", x, y, z, w";
  if (op.has(fp::ir::Texture))
    text += ", texture[n], target";
  return text;
}

std::string documentationOf(fp::ir::Opcode opcode) {
  const fp::ir::OpInfo &op = info(opcode);
  const std::string formula(fp::reference::formula(opcode));
  std::string text =
      std::string(op.doc) + "\n\n`" +
      (op.has(fp::ir::Kills) || op.has(fp::ir::Flow) ? formula : "result = " + formula) + "`\n";
  std::string properties;
  for (const TraitText &row : kTraits)
    if (op.has(row.trait))
      properties += (properties.empty() ? "" : "; ") + std::string(row.text);
  if (!properties.empty())
    text += "\n" + properties;
  return text + (int(opcode) >= fp::ir::kOpcodeCount ? nvSectionText(op) : sectionText(op.section));
}

std::string documentationOf(const fp::reference::Binding &binding) {
  return std::string(binding.doc) + "\n\ncomponents: `" + std::string(binding.components) + "`" +
         sectionText(binding.section);
}

std::string documentationOf(const fp::reference::Entry &entry) {
  return std::string(entry.doc) + sectionText(entry.section);
}

std::string signatureOf(const fp::reference::AtiOp &op) {
  return std::string(op.word) + " rN, " + operands(op.arguments, nullptr);
}

std::string documentationOf(const fp::reference::AtiOp &op) {
  return "`result = " + std::string(op.formula) + "`" + sectionText("3.10.1");
}

} // namespace arbiter::tools::lsp
