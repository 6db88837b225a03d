#pragma once
#include <memory>

#include "fp_compiler/emit.h"

/// Draws with register combiners: the program that their state is made into, under what it depends
/// on: the targets that the units sample, whether their textures are depths, whether those are
/// compared, and fog.
namespace arbiter::state {

class Context;
struct CompiledProgram;

/// The program of the combiners as they are now. Asks the host. REGISTER_COMBINERS_NV is enabled.
[[nodiscard]] std::shared_ptr<const CompiledProgram> combinersEffective(Context &context,
                                                                        const fp::GlslHost &host);

/// A client of control has switched off what the combiners are now, without texture shaders before
/// them: draws are as if REGISTER_COMBINERS_NV were not enabled.
[[nodiscard]] bool combinersSwitchedOff(Context &context);

/// What draws now samples textures that might be depths, or cease to be: after what may have
/// changed which are (noteTextureChange()), and always where other contexts may.
[[nodiscard]] bool mayFollowCombinedDepths(const Context &context);
/// Before a draw of which that is true: the program is chosen anew if one is otherwise than when it
/// was chosen. Asks the host.
void followCombinedDepths(Context &context);

} // namespace arbiter::state
