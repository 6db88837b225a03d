#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/limits.h"

namespace arbiter::differential {

/// A generated program, as text and as the compiler's result.
struct Subject {
  std::string text;
  std::optional<fp::ir::Program> program;
  std::string error; ///< why there is no program
};

/// Returns the limits for checking the suite's programs: wide, as the programs are small.
[[nodiscard]] fp::Limits suiteLimits();

/// Makes a subject from any program text.
[[nodiscard]] Subject subjectOf(fp::ir::Language language, std::string text);

/// Generates an ARB fragment program.
[[nodiscard]] Subject arbSubject(std::uint64_t seed);

/// Generates an ARB vertex program.
[[nodiscard]] Subject vertexSubject(std::uint64_t seed);

/// These generate programs with NVIDIA's options; even seeds have the lesser ones.
[[nodiscard]] Subject nvSubject(std::uint64_t seed);
[[nodiscard]] Subject nvVertexSubject(std::uint64_t seed);
/// These leave out what NVIDIA's driver does differently (RandomNvOptions::peer).
[[nodiscard]] Subject nvPeerSubject(std::uint64_t seed);
[[nodiscard]] Subject nvVertexPeerSubject(std::uint64_t seed);

/// These generate ARB programs that read registers nothing wrote, or write results in part or not
/// at all, and vertices without a complete position. The specifications leave them undefined; every
/// path of the layer uses zero.
[[nodiscard]] Subject unwrittenSubject(std::uint64_t seed);
[[nodiscard]] Subject unwrittenVertexSubject(std::uint64_t seed);

/// Generates a program with operands outside of functions' domains, which yield infinities and
/// NaNs. It only samples at attributes: sampling at an infinity is host-dependent.
[[nodiscard]] Subject wildSubject(std::uint64_t seed);

/// Generates an ATI fragment shader in its text form, for draws with the scene's textures, and a
/// fog and a color sum that the seed chooses. Registers clamp to [-8, 8] for half of the seeds.
[[nodiscard]] Subject atiSubject(std::uint64_t seed);

/// Generates an ATI shader with unclamped registers, as under the profile of the host.
[[nodiscard]] Subject atiSubjectOfHost(std::uint64_t seed);

/// Generates an ATI shader within the specification that Mesa's own implementation also supports.
[[nodiscard]] Subject atiSubjectOfPeer(std::uint64_t seed);

} // namespace arbiter::differential
