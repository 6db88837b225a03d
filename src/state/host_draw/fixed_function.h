#pragma once
#include <cstdint>
#include <memory>

#include <GL/gl.h>

#include "fp_compiler/fixed_function.h"

/// ATI fragment shaders, in their text and their API form, take the place of texturing alone: the
/// texture targets they sample, colour sum and fog are fixed function's at the draw. The host is
/// asked for it when a shader becomes effective, and again after what may have changed it.
namespace arbiter::state {

class Context;
struct CompiledProgram;

/// The ATI shader that shades fragments now, in the form for the host's present state: that of the
/// text form if its target is enabled, else that of the API form. Null where neither is enabled
/// with a valid shader: draws with another are undefined by both specifications, and are fixed
/// function's here.
[[nodiscard]] std::shared_ptr<const CompiledProgram> atiShaderEffective(Context &context);

/// The host's state, as far as the units of `units` sample. The context's program selection is done
/// at a draw, so that this asks the host some ten to fifty values.
[[nodiscard]] fp::FixedFunction fixedFunctionNow(Context &context, std::uint32_t units);

/// What fixedFunctionNow() asks may have changed: the next draw of an ATI shader looks again. One
/// test where none is effective.
void noteFixedFunctionChange(Context &context);
/// The same for a parameter or a capability that chooses the form. While a list is compiled that
/// ATI shaders may be drawn from, it is cut here, so that what follows is drawn with the form for
/// the new state.
void noteFixedFunctionCommand(Context &context);

} // namespace arbiter::state
