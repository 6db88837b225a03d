#pragma once
#include <cstdint>

/// DEPTH_TEXTURE_MODE ALPHA beside a vertex program that is GLSL 1.30 on the host, under which Mesa
/// reads such depths as INTENSITY, compared or not: 1.30's comparisons are scalars, which must not
/// lose their value. Such pairs are drawn with the mode in their texts (depth_variants.h).
namespace arbiter::state {

class Context;
struct ProgramPair;

/// fp::GlslHost::alphaDepths of the images that the pair samples, as they are now. Asks the host.
[[nodiscard]] std::uint32_t alphaDepthsOf(Context &context, const ProgramPair &pair);
/// What draws now would have the mode in its texts, and some image has had it.
[[nodiscard]] bool mayFollowAlphaDepths(const Context &context);
/// Before a draw of a pair that has the mode in its texts: it is chosen anew if others have it now.
/// Asks the
/// host.
void followAlphaDepths(Context &context);

} // namespace arbiter::state
