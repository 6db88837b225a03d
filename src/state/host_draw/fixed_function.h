#pragma once
#include <cstdint>
#include <memory>

#include <GL/gl.h>

/// Follows fixed-function state for programs that depend on it. ATI fragment shaders, as text or by
/// API, replace texturing alone: their texture targets, colour sum and fog are fixed function's at
/// the time of the draw. Register combiners sample the enabled targets and may read fog. The host
/// is queried (texturing/fixed_function_now.h) when such a program becomes effective, and again
/// after what may have changed that state.
namespace arbiter::state {

struct DrawContext;
struct CompiledProgram;

/// Returns the effective ATI shader, in the variant for the host's present state. The text form is
/// preferred if its target is enabled, else the API form is used. Returns null if neither is
/// enabled with a valid shader. Both specifications leave such draws undefined, and here fixed
/// function does them.
[[nodiscard]] std::shared_ptr<const CompiledProgram> chooseAtiShaderProgram(DrawContext &context);

/// Notes that fixedFunctionNow() may have changed, so that the next draw that depends on it queries
/// again. It only takes a test if no program does.
void noteFixedFunctionChange(DrawContext &context);
/// Notes a change of a parameter or capability that selects the variant. If a list is being
/// compiled that such shaders may draw in, the list is cut here, so that the rest uses the variant
/// for the new state.
void noteFixedFunctionCommand(DrawContext &context);

} // namespace arbiter::state
