#pragma once
#include <cstdint>

/// Handles DEPTH_TEXTURE_MODE ALPHA beside a vertex program that is GLSL 1.30 on the host. Mesa
/// then reads such depths as INTENSITY, compared or not: comparisons of 1.30 are scalars, which
/// must not lose their value. Such pairs are drawn with texts that apply the mode themselves
/// (depth_variants.h).
namespace arbiter::state {

struct ProgramContext;
struct ProgramPair;

/// Returns fp::GlslHost::alphaDepths for the images that the pair samples now. Queries the host.
[[nodiscard]] std::uint32_t alphaDepthsOf(ProgramContext &context, const ProgramPair &pair);
/// True if draws now use texts that apply the mode, and some image has had it.
[[nodiscard]] bool mayFollowAlphaDepths(const ProgramContext &context);
/// Checks the images before a draw with such texts, and has the pair chosen anew if the mode has
/// changed for one. Queries the host.
void followAlphaDepths(ProgramContext &context);

} // namespace arbiter::state
