#include "fp_compiler/ir/print.h"

#include <charconv>
#include <cmath>

#include "fp_compiler/ir/fog.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::ir {

namespace {
constexpr const char *kLetters = "xyzw01";

std::string number(float value) {
  if (std::isnan(value))
    return "nan";
  char digits[64];
  const auto end = std::to_chars(digits, digits + sizeof digits, value);
  return std::string(digits, end.ptr);
}

std::string bracket(unsigned index) { return "[" + std::to_string(index) + "]"; }

char fileLetter(File file) {
  switch (file) {
  case File::Temporary:
    return 't';
  case File::Attribute:
    return 'a';
  case File::Parameter:
    return 'p';
  case File::Output:
    return 'o';
  case File::Address:
    return 'A';
  }
  return '?';
}

std::string registerText(File file, unsigned index) {
  return fileLetter(file) + std::to_string(index);
}

/// Returns "c0[A0+3]" for row A0+3 of the program's array 0.
std::string relativeText(const Operand &operand) {
  std::string text =
      "c" + std::to_string(operand.index) + "[" + registerText(File::Address, operand.address);
  if (operand.offset != 0)
    text += (operand.offset > 0 ? "+" : "") + std::to_string(operand.offset);
  return text + "]";
}

/// Returns ".wzyx", or ".(-x,0,1,w)" if the components differ in sign or are constant.
std::string operandText(const Operand &operand, bool scalar) {
  const std::string name =
      operand.relative ? relativeText(operand) : registerText(operand.file, operand.index);
  const bool sameSign = operand.negate == 0 || operand.negate == 0xF;
  bool constant = false;
  for (const Select select : operand.swizzle)
    constant |= select > Select::W;
  if (scalar && operand.swizzle[0] <= Select::W)
    return std::string(operand.negate & 1 ? "-" : "") + name + "." +
           kLetters[int(operand.swizzle[0])];
  if (!sameSign || constant) {
    std::string text = name + ".(";
    for (std::size_t i = 0; i < 4; ++i)
      text += std::string(i ? "," : "") + (operand.negate >> i & 1 ? "-" : "") +
              kLetters[int(operand.swizzle[i])];
    return text + ")";
  }
  std::string text = (operand.negate ? "-" : "") + name;
  if (operand.swizzle == kIdentity)
    return text;
  text += '.';
  for (const Select select : operand.swizzle)
    text += kLetters[int(select)];
  return text;
}

std::string destinationText(const Destination &dst) {
  std::string text = registerText(dst.file, dst.index);
  if (dst.mask == 0xF)
    return text;
  text += '.';
  for (int i = 0; i < 4; ++i)
    if (dst.mask >> i & 1)
      text += kLetters[i];
  return text;
}

const char *matrixName(StateItem item) {
  switch (item) {
  case StateItem::MatrixModelview:
    return "modelview";
  case StateItem::MatrixProjection:
    return "projection";
  case StateItem::MatrixMvp:
    return "mvp";
  case StateItem::MatrixTexture:
    return "texture";
  case StateItem::MatrixPalette:
    return "palette";
  case StateItem::MatrixProgram:
    return "program";
  default:
    return "";
  }
}

std::string matrixText(const StateRef &ref) {
  constexpr const char *kModifiers[] = {"", ".inverse", ".transpose", ".invtrans"};
  const bool single = ref.item == StateItem::MatrixProjection || ref.item == StateItem::MatrixMvp;
  return std::string("state.matrix.") + matrixName(ref.item) + (single ? "" : bracket(ref.index)) +
         kModifiers[std::size_t(ref.modifier)] + ".row" + bracket(ref.row);
}

std::string stateBinding(const StateRef &ref) {
  const std::string face = ref.back ? ".back" : "";
  const std::string light = "state.light" + bracket(ref.index);
  const std::string product = "state.lightprod" + bracket(ref.index) + face;
  const std::string texGen = "state.texgen" + bracket(ref.index) + ".";
  switch (ref.item) {
  case StateItem::MaterialAmbient:
    return "state.material" + face + ".ambient";
  case StateItem::MaterialDiffuse:
    return "state.material" + face + ".diffuse";
  case StateItem::MaterialSpecular:
    return "state.material" + face + ".specular";
  case StateItem::MaterialEmission:
    return "state.material" + face + ".emission";
  case StateItem::MaterialShininess:
    return "state.material" + face + ".shininess";
  case StateItem::LightAmbient:
    return light + ".ambient";
  case StateItem::LightDiffuse:
    return light + ".diffuse";
  case StateItem::LightSpecular:
    return light + ".specular";
  case StateItem::LightPosition:
    return light + ".position";
  case StateItem::LightAttenuation:
    return light + ".attenuation";
  case StateItem::LightSpotDirection:
    return light + ".spot.direction";
  case StateItem::LightHalf:
    return light + ".half";
  case StateItem::LightModelAmbient:
    return "state.lightmodel.ambient";
  case StateItem::LightModelSceneColor:
    return "state.lightmodel" + face + ".scenecolor";
  case StateItem::LightProdAmbient:
    return product + ".ambient";
  case StateItem::LightProdDiffuse:
    return product + ".diffuse";
  case StateItem::LightProdSpecular:
    return product + ".specular";
  case StateItem::TexEnvColor:
    return "state.texenv" + bracket(ref.index) + ".color";
  case StateItem::FogColor:
    return "state.fog.color";
  case StateItem::FogParams:
    return "state.fog.params";
  case StateItem::FogFactors:
    return "state.fog.factors";
  case StateItem::DepthRange:
    return "state.depth.range";
  case StateItem::MatrixModelview:
  case StateItem::MatrixProjection:
  case StateItem::MatrixMvp:
  case StateItem::MatrixTexture:
  case StateItem::MatrixPalette:
  case StateItem::MatrixProgram:
    return matrixText(ref);
  case StateItem::TexGenEye:
    return texGen + "eye." + "strq"[ref.row & 3];
  case StateItem::TexGenObject:
    return texGen + "object." + "strq"[ref.row & 3];
  case StateItem::ClipPlane:
    return "state.clip" + bracket(ref.index) + ".plane";
  case StateItem::PointSize:
    return "state.point.size";
  case StateItem::PointAttenuation:
    return "state.point.attenuation";
  }
  return "";
}

std::string optionsText(const Options &options, Language language) {
  std::string text;
  constexpr const char *kHint[] = {"", "ARB_precision_hint_fastest", "ARB_precision_hint_nicest"};
  const auto option = [&](bool given, const char *name) {
    if (given)
      text += std::string("option ") + name + "\n";
  };
  option(options.fog != FogMode::None, rowOf(options.fog).option);
  option(options.precision != Precision::Unspecified, kHint[std::size_t(options.precision)]);
  option(options.shadow, "ARB_fragment_program_shadow");
  option(options.drawBuffers, "ARB_draw_buffers");
  option(options.originUpperLeft, "ARB_fragment_coord_origin_upper_left");
  option(options.pixelCenterInteger, "ARB_fragment_coord_pixel_center_integer");
  option(options.positionInvariant, "ARB_position_invariant");
  option(options.colorSum, "color_sum");
  if (options.native != NativeLanguage::None)
    return text + std::string("native ") + std::string(headerOf(options.native)) + "\n";
  const bool vertex = language == Language::ArbVertex;
  option(options.nv == NvOption::First, vertex ? "NV_vertex_program2" : "NV_fragment_program");
  option(options.nv == NvOption::Second, vertex ? "NV_vertex_program3" : "NV_fragment_program2");
  return text;
}
} // namespace

const char *targetText(TexTarget target) {
  constexpr const char *kNames[] = {"1D",   "2D",       "3D",       "CUBE",
                                    "RECT", "SHADOW1D", "SHADOW2D", "SHADOWRECT"};
  return kNames[std::size_t(target)];
}

std::string bindingText(const Attribute &attribute, Language language) {
  const bool vertex = language == Language::ArbVertex;
  const std::string stage = vertex ? "vertex." : "fragment.";
  switch (attribute.kind) {
  case AttributeKind::ColorPrimary:
    return stage + "color.primary";
  case AttributeKind::ColorSecondary:
    return stage + "color.secondary";
  case AttributeKind::TexCoord:
    return stage + "texcoord" + bracket(attribute.index);
  case AttributeKind::FogCoord:
    return stage + "fogcoord";
  case AttributeKind::Position:
    return stage + "position";
  case AttributeKind::Normal:
    return stage + "normal";
  case AttributeKind::Generic:
    return stage + "attrib" + bracket(attribute.index);
  case AttributeKind::Facing:
    return stage + "facing";
  }
  return "";
}

std::string bindingText(const Output &output) {
  switch (output.kind) {
  case OutputKind::Color:
    return "result.color" + bracket(output.index);
  case OutputKind::Depth:
    return "result.depth";
  case OutputKind::Position:
    return "result.position";
  case OutputKind::FrontPrimary:
    return "result.color.front.primary";
  case OutputKind::FrontSecondary:
    return "result.color.front.secondary";
  case OutputKind::BackPrimary:
    return "result.color.back.primary";
  case OutputKind::BackSecondary:
    return "result.color.back.secondary";
  case OutputKind::FogCoord:
    return "result.fogcoord";
  case OutputKind::PointSize:
    return "result.pointsize";
  case OutputKind::TexCoord:
    return "result.texcoord" + bracket(output.index);
  case OutputKind::ClipDistance:
    return "result.clip" + bracket(output.index);
  case OutputKind::EnvParameter:
    return "program.env" + bracket(output.index);
  }
  return "";
}

std::string bindingText(const Parameter &parameter) {
  switch (parameter.kind) {
  case ParameterKind::Constant: {
    std::string text;
    for (const float value : parameter.constant)
      text += (text.empty() ? "{" : ", ") + number(value);
    return text + "}";
  }
  case ParameterKind::Env:
    return "program.env" + bracket(parameter.index);
  case ParameterKind::Local:
    return "program.local" + bracket(parameter.index);
  case ParameterKind::State:
    return stateBinding(parameter.state);
  }
  return "";
}

std::string print(const Instruction &instruction) {
  const OpInfo &row = info(instruction.op);
  std::string text = row.mnemonic;
  if (row.hasDestination()) {
    text += instruction.dst.saturate ? "_SAT " : " ";
    text += destinationText(instruction.dst) + ",";
  }
  for (int i = 0; i < row.operandCount(); ++i)
    text += (i ? ", " : " ") + operandText(instruction.src[std::size_t(i)], row.shapes[i] == 'S');
  if (row.has(Texture))
    text += ", texture" + bracket(instruction.unit) + ", " + targetText(instruction.target);
  return text;
}

std::string print(const Program &program) {
  std::string text = optionsText(program.options, program.language);
  const auto line = [&](char letter, std::size_t index, const std::string &what) {
    text += letter + std::to_string(index) + " = " + what + "\n";
  };
  for (std::size_t i = 0; i < program.attributes.size(); ++i)
    line('a', i, bindingText(program.attributes[i], program.language));
  for (std::size_t i = 0; i < program.parameters.size(); ++i)
    line('p', i, bindingText(program.parameters[i]));
  for (std::size_t i = 0; i < program.temporaries.size(); ++i)
    line('t', i, "temporary " + program.temporaries[i].name);
  for (std::size_t i = 0; i < program.outputs.size(); ++i)
    line('o', i, bindingText(program.outputs[i]));
  for (std::size_t i = 0; i < program.addresses.size(); ++i)
    line('A', i, "address " + program.addresses[i].name);
  for (std::size_t i = 0; i < program.arrays.size(); ++i) {
    std::string rows;
    for (const std::uint16_t row : program.arrays[i].rows)
      rows += " p" + std::to_string(row);
    line('c', i, "array " + program.arrays[i].name + ":" + rows);
  }
  for (const Instruction &instruction : program.code)
    text += "  " + print(instruction) + "\n";
  return text;
}

} // namespace arbiter::fp::ir
