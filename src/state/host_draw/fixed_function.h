#pragma once
#include <cstdint>
#include <memory>

#include <GL/gl.h>

/// ATI fragment shaders, in their text and their API form, take the place of texturing alone: the
/// texture targets they sample, colour sum and fog are fixed function's at the draw. Register
/// combiners sample the enabled targets and have fog among their inputs. The host is asked for it
/// (texturing/fixed_function_now.h) when one becomes effective, and again after what may have
/// changed it.
namespace arbiter::state {

class Context;
struct CompiledProgram;

/// The ATI shader that shades fragments now, in the form for the host's present state: that of the
/// text form if its target is enabled, else that of the API form. Null where neither is enabled
/// with a valid shader: draws with another are undefined by both specifications, and are fixed
/// function's here.
[[nodiscard]] std::shared_ptr<const CompiledProgram> atiShaderEffective(Context &context);

/// What fixedFunctionNow() asks may have changed: the next draw that depends on it looks again. One
/// test where none does.
void noteFixedFunctionChange(Context &context);
/// The same for a parameter or a capability that chooses the form. While a list is compiled that
/// such shaders may be drawn from, it is cut here, so that what follows is drawn with the form for
/// the new state.
void noteFixedFunctionCommand(Context &context);

} // namespace arbiter::state
