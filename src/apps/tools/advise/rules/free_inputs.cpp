#include "apps/tools/advise/rules/free_inputs.h"

#include <algorithm>

namespace arbiter::tools::advise {

namespace {

/// Returns the first unused number in [0, count).
template <typename Used>
std::optional<std::uint8_t> firstFree(std::uint32_t count, const Used &isUsed) {
  for (std::uint32_t index = 0; index < std::min(count, 256u); ++index)
    if (!isUsed(std::uint8_t(index)))
      return std::uint8_t(index);
  return std::nullopt;
}

} // namespace

std::optional<std::uint8_t> freeLocal(const Subject &subject) {
  const auto &rows = subject.program().parameters;
  return firstFree(subject.setting().limits.localParameters, [&](std::uint8_t index) {
    return std::any_of(rows.begin(), rows.end(), [&](const fp::ir::Parameter &row) {
      return row.kind == fp::ir::ParameterKind::Local && row.index == index;
    });
  });
}

std::vector<std::uint8_t> freeTexCoords(const Subject &subject) {
  const auto &attributes = subject.program().attributes;
  std::vector<std::uint8_t> free;
  for (std::uint32_t i = 0; i < std::min(subject.setting().limits.textureCoords, 256u); ++i) {
    const fp::ir::Attribute wanted{fp::ir::AttributeKind::TexCoord, std::uint8_t(i)};
    if (std::find(attributes.begin(), attributes.end(), wanted) == attributes.end())
      free.push_back(std::uint8_t(i));
  }
  return free;
}

std::optional<std::uint8_t> freeUnit(const Subject &subject) {
  const auto &code = subject.program().code;
  return firstFree(subject.setting().limits.textureImageUnits, [&](std::uint8_t index) {
    return std::any_of(code.begin(), code.end(), [&](const fp::ir::Instruction &each) {
      return fp::ir::info(each.op).has(fp::ir::Texture) && each.unit == index;
    });
  });
}

std::string localText(std::uint8_t index) { return "program.local[" + std::to_string(index) + "]"; }

std::string texCoordText(std::uint8_t index) {
  return "fragment.texcoord[" + std::to_string(index) + "]";
}

} // namespace arbiter::tools::advise
