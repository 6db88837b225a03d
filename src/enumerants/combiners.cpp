#include "enumerants/combiners.h"

#include <algorithm>
#include <iterator>

#include <GL/glext.h>

namespace arbiter::enumerants {

using fp::combiners::Mapping;
using fp::combiners::Register;
using fp::combiners::Scale;
using fp::combiners::Usage;

namespace {

/// The names of the registers in the order of Register, up to the first texture register.
constexpr GLenum kRegisters[] = {GL_ZERO,      GL_CONSTANT_COLOR0_NV, GL_CONSTANT_COLOR1_NV,
                                 GL_FOG,       GL_PRIMARY_COLOR_NV,   GL_SECONDARY_COLOR_NV,
                                 GL_SPARE0_NV, GL_SPARE1_NV};
static_assert(std::size(kRegisters) == std::size_t(Register::Texture0));

} // namespace

std::optional<Register> inputRegister(GLenum name, int units) {
  if (const GLenum unit = name - GL_TEXTURE0; unit < GLenum(units))
    return fp::combiners::textureRegister(int(unit));
  const auto *const row = std::find(std::begin(kRegisters), std::end(kRegisters), name);
  if (row == std::end(kRegisters))
    return std::nullopt;
  return Register(row - std::begin(kRegisters));
}

std::optional<Register> finalInputRegister(GLenum name, int units) {
  if (name == GL_E_TIMES_F_NV)
    return Register::ETimesF;
  if (name == GL_SPARE0_PLUS_SECONDARY_COLOR_NV)
    return Register::Spare0PlusSecondary;
  return inputRegister(name, units);
}

std::optional<Register> outputRegister(GLenum name, int units) {
  if (name == GL_DISCARD_NV)
    return Register::Discard;
  const auto found = inputRegister(name, units);
  return found && *found >= Register::Primary ? found : std::nullopt;
}

std::optional<Mapping> combinerMapping(GLenum name) {
  const GLenum at = name - GL_UNSIGNED_IDENTITY_NV;
  return at < GLenum(fp::combiners::kMappings) ? std::optional(Mapping(at)) : std::nullopt;
}

std::optional<Usage> componentUsage(GLenum name) {
  switch (name) {
  case GL_RGB:
    return Usage::Rgb;
  case GL_ALPHA:
    return Usage::Alpha;
  case GL_BLUE:
    return Usage::Blue;
  default:
    return std::nullopt;
  }
}

std::optional<Scale> combinerScale(GLenum name) {
  if (name == GL_NONE)
    return Scale::None;
  const GLenum at = name - GL_SCALE_BY_TWO_NV;
  return at < 3 ? std::optional(Scale(at + 1)) : std::nullopt;
}

GLenum nameOf(Register value) {
  if (const int unit = fp::combiners::textureUnit(value); unit >= 0)
    return GLenum(GL_TEXTURE0 + unit);
  switch (value) {
  case Register::ETimesF:
    return GL_E_TIMES_F_NV;
  case Register::Spare0PlusSecondary:
    return GL_SPARE0_PLUS_SECONDARY_COLOR_NV;
  case Register::Discard:
    return GL_DISCARD_NV;
  default:
    return kRegisters[std::size_t(value)];
  }
}

GLenum nameOf(Mapping value) { return GLenum(GL_UNSIGNED_IDENTITY_NV) + GLenum(value); }

GLenum nameOf(Usage value) {
  constexpr GLenum kNames[] = {GL_RGB, GL_ALPHA, GL_BLUE};
  return kNames[std::size_t(value)];
}

GLenum nameOf(Scale value) {
  return value == Scale::None ? GLenum(GL_NONE) : GLenum(GL_SCALE_BY_TWO_NV) + GLenum(value) - 1;
}

} // namespace arbiter::enumerants
