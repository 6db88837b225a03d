#include "peer.h"

#include <optional>

#include "fp_compiler/texture_shader/operations.h"

namespace shaded {

using namespace arbiter::fp::texture_shader;

namespace {

/// The offset that does not scale.
Operation withoutScale(Operation operation) {
  switch (operation) {
  case Operation::Offset2DScale:
    return Operation::Offset2D;
  case Operation::OffsetRectangleScale:
    return Operation::OffsetRectangle;
  case Operation::OffsetProjective2DScale:
    return Operation::OffsetProjective2D;
  case Operation::OffsetProjectiveRectangleScale:
    return Operation::OffsetProjectiveRectangle;
  default:
    return operation;
  }
}

bool reflects(Operation operation) { return infoOf(operation).family == Family::Reflect; }

/// Units whose stage's result is no colour, though it samples, are (1, 1, 1, 1) there where an
/// environment names them.
bool isOtherwiseNamed(const State &state, std::size_t unit) {
  const Texture &texture = state.textures[unit];
  return infoOf(state.stages[unit].operation).target && texture.base >= Base::Hilo &&
         texture.base != Base::DsdtMagIntensity;
}

/// The unit whose texture an argument of `unit`'s COMBINE is the colour of; nothing: another
/// colour.
std::optional<std::size_t> unitOf(const CombineArgument &argument, std::size_t unit) {
  if (argument.source >= CombineSource::Unit0)
    return std::size_t(argument.source) - std::size_t(CombineSource::Unit0);
  return argument.source == CombineSource::Texture ? std::optional(unit) : std::nullopt;
}

} // namespace

void leaveOut(State &state) {
  if (state.conventional)
    return;
  for (std::size_t unit = 0; unit < state.units; ++unit) {
    Stage &stage = state.stages[unit];
    const OperationInfo &info = infoOf(stage.operation);
    Texture &own = state.textures[unit];
    // Of other formats a scaled one is not consistent there.
    if (info.scale && isRgba(own.base) && own.base != Base::Rgb)
      own.base = Base::Rgba;
    // A diffuse stage before a reflection that is not consistent is consistent there.
    if (unit > 1 && reflects(stage.operation) &&
        state.stages[unit - 1].operation == Operation::DotProductDiffuseCubeMap &&
        stage.previous + 2 >= int(unit))
      stage.previous = 0;
    if (!readsPrevious(info.family))
      continue;
    Stage &previous = state.stages[stage.previous];
    Texture &read = state.textures[stage.previous];
    // What is read of a scaled offset is scaled there.
    previous.operation = withoutScale(previous.operation);
    // What is read of an ALPHA texture is (0, 0, 0, A) there.
    if (read.base == Base::Alpha)
      read.base = Base::Rgba;
    // A component that a signed texture does not have, and is 1, makes its signedness mixed there.
    if (computesDot(info.family) && (read.base == Base::Luminance || read.base == Base::Rgb))
      read.signs = Signs::Unsigned;
    // A signed HILO result of an offset has a third component of 1 there.
    if (computesDot(info.family) && read.base == Base::Hilo &&
        infoOf(previous.operation).family == Family::Offset)
      read.signs = Signs::Unsigned;
    // It gives nothing there.
    if (stage.operation == Operation::DependentRgbCubeMap)
      stage.operation = Operation::TextureCubeMap;
  }
}

void leaveOut(const State &state, Environments &environments) {
  if (state.conventional)
    return;
  for (std::size_t unit = 0; unit < state.units; ++unit) {
    Environment &environment = environments[unit];
    // Its process ends there in a fault.
    const Family family = infoOf(state.stages[unit].operation).family;
    if ((family == Family::PassThrough || family == Family::DotColor) &&
        environment.mode == EnvironmentMode::Blend)
      environment.mode = EnvironmentMode::Modulate;
    for (CombineHalf *const half : {&environment.color, &environment.alpha})
      for (CombineArgument &argument : half->arguments) {
        const auto of = unitOf(argument, unit);
        if (of && isOtherwiseNamed(state, *of))
          argument.source = CombineSource::Previous;
        // The colour of an ALPHA texture is black in COMBINE there.
        else if (of && state.textures[*of].base == Base::Alpha)
          argument.alpha = true;
      }
  }
}

} // namespace shaded
