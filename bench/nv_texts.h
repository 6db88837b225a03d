#pragma once
#include <span>
#include <string>
#include <string_view>

#include <epoxy/gl.h>

namespace bench {

/// Two texts of one meaning: in the language of ARB_fragment_program or ARB_vertex_program alone,
/// and in one of NVIDIA's. `@` stands for a number (in a fragment program) or for the index of an
/// environment parameter (in a vertex program) that differs from text to text.
struct NvPair {
  std::string_view name;
  GLenum target;
  std::string_view arb, nv;
};

[[nodiscard]] std::span<const NvPair> nvFragmentPairs();
[[nodiscard]] std::span<const NvPair> nvVertexPairs();

/// Returns one of a pair's texts with number \p seed in it. Any 400 consecutive seeds give
/// different texts.
[[nodiscard]] std::string nvText(const NvPair &pair, bool nv, unsigned seed);

} // namespace bench
