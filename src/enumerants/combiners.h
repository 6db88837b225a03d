#pragma once
#include <optional>

#include <GL/gl.h>

#include "fp_compiler/combiners/state.h"

/// Translates between the enumerants of NV_register_combiners and the compiler's types.
namespace arbiter::enumerants {

/// Returns the register that an input names, or nothing for another enumerant. \param units how
/// many texture registers may be named
[[nodiscard]] std::optional<fp::combiners::Register> inputRegister(GLenum name, int units);
/// Returns the register that an input of the final combiner names. It has two more registers.
[[nodiscard]] std::optional<fp::combiners::Register> finalInputRegister(GLenum name, int units);
/// Returns a register that can be written, or DISCARD_NV.
[[nodiscard]] std::optional<fp::combiners::Register> outputRegister(GLenum name, int units);
[[nodiscard]] std::optional<fp::combiners::Mapping> combinerMapping(GLenum name);
[[nodiscard]] std::optional<fp::combiners::Usage> componentUsage(GLenum name);
[[nodiscard]] std::optional<fp::combiners::Scale> combinerScale(GLenum name);

[[nodiscard]] GLenum nameOf(fp::combiners::Register value);
[[nodiscard]] GLenum nameOf(fp::combiners::Mapping value);
[[nodiscard]] GLenum nameOf(fp::combiners::Usage value);
[[nodiscard]] GLenum nameOf(fp::combiners::Scale value);

} // namespace arbiter::enumerants
