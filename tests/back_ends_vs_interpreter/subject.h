#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/limits.h"

namespace arbiter::differential {

/// A generated program, as text and as what the compiler made of it.
struct Subject {
  std::string text;
  std::optional<fp::ir::Program> program;
  std::string error; ///< why there is no program
};

/// Limits under which the programs of the suite are checked: wide, the programs are small.
[[nodiscard]] fp::Limits suiteLimits();

/// A program of anywhere.
[[nodiscard]] Subject subjectOf(fp::ir::Language language, std::string text);

/// An ARB fragment program.
[[nodiscard]] Subject arbSubject(std::uint64_t seed);

/// An ARB vertex program.
[[nodiscard]] Subject vertexSubject(std::uint64_t seed);

/// Programs under NVIDIA's options, of an even seed under the lesser ones.
[[nodiscard]] Subject nvSubject(std::uint64_t seed);
[[nodiscard]] Subject nvVertexSubject(std::uint64_t seed);
/// The same without what NVIDIA's driver does otherwise (RandomNvOptions::peer).
[[nodiscard]] Subject nvPeerSubject(std::uint64_t seed);
[[nodiscard]] Subject nvVertexPeerSubject(std::uint64_t seed);

/// The same as the first two with registers that nothing wrote, results written in part or not at
/// all, and vertices without a whole position: undefined by the specifications, zero on every path
/// of the layer.
[[nodiscard]] Subject unwrittenSubject(std::uint64_t seed);
[[nodiscard]] Subject unwrittenVertexSubject(std::uint64_t seed);

/// The same with operands outside of functions' domains, which make infinities and NaNs. Nothing is
/// sampled but at attributes: where a texture is read at an infinity is the host's affair.
[[nodiscard]] Subject wildSubject(std::uint64_t seed);

/// An ATI fragment shader in its text form, for draws with the scene's textures, and under a fog
/// and a colour sum that the seed chooses. Registers clamp to [-8, 8] for half of the seeds.
[[nodiscard]] Subject atiSubject(std::uint64_t seed);

/// The same with registers of any range, as they are under the profile of the host.
[[nodiscard]] Subject atiSubjectOfHost(std::uint64_t seed);

/// The same, and within what the specification defines and Mesa's own implementation keeps to.
[[nodiscard]] Subject atiSubjectOfPeer(std::uint64_t seed);

} // namespace arbiter::differential
