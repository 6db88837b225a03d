#pragma once
#include <optional>

#include <GL/gl.h>

#include "fp_compiler/combiners/state.h"

/// The enumerants of NV_register_combiners and what they stand for.
namespace arbiter::enumerants {

/// A register that an input may name, of texture registers the first `units`; nothing for another
/// enumerant.
[[nodiscard]] std::optional<fp::combiners::Register> inputRegister(GLenum name, int units);
/// The same of the final combiner's, which has two more.
[[nodiscard]] std::optional<fp::combiners::Register> finalInputRegister(GLenum name, int units);
/// A register that can be written, or DISCARD_NV.
[[nodiscard]] std::optional<fp::combiners::Register> outputRegister(GLenum name, int units);
[[nodiscard]] std::optional<fp::combiners::Mapping> combinerMapping(GLenum name);
[[nodiscard]] std::optional<fp::combiners::Usage> componentUsage(GLenum name);
[[nodiscard]] std::optional<fp::combiners::Scale> combinerScale(GLenum name);

[[nodiscard]] GLenum nameOf(fp::combiners::Register value);
[[nodiscard]] GLenum nameOf(fp::combiners::Mapping value);
[[nodiscard]] GLenum nameOf(fp::combiners::Usage value);
[[nodiscard]] GLenum nameOf(fp::combiners::Scale value);

} // namespace arbiter::enumerants
