#include "subject.h"

#include "fp_compiler/compiler.h"
#include "fp_compiler/fixed_function.h"
#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/random_ati.h"
#include "gl_host.h"

namespace arbiter::differential {

namespace {
Subject checked(fp::ir::Language language, std::string text, const fp::Limits &limits) {
  fp::CheckResult result = fp::checkProgram(language, text, {limits, fp::LimitPolicy::Enforce});
  std::string error = result.ok() ? "" : result.errorString(text);
  return {std::move(text), std::move(result.program), std::move(error)};
}

Subject atiUnder(const fp::Limits &limits, std::uint64_t seed, bool peer) {
  // Beyond unit 4 the scene has shadow textures, which these shaders do not compare. One shader of
  // four reads what it did not write.
  const fp::ati::Shader shader = fp::testing::randomAtiShader(
      seed,
      {.sampledUnits = 0x1F, .tameDivisors = true, .defined = peer || seed % 4 != 0, .peer = peer});
  Subject subject =
      checked(fp::ir::Language::AtiFragment, fp::testing::spell(shader, seed), limits);
  if (!subject.program)
    return subject;
  fp::testing::Random random(seed);
  fp::FixedFunction state;
  state.targets = fp::testing::kUnitTargets;
  // Without GLSL, what is clamped before these is the host's own affair with float buffers.
  state.colorSum = !peer && random.chance(30);
  if (!peer && random.chance(30))
    state.fog = fp::ir::FogMode(1 + random.below(3));
  subject.program = fp::withFixedFunction(*std::move(subject.program), state);
  return subject;
}
} // namespace

fp::Limits suiteLimits() {
  fp::Limits limits;
  limits.api = {1024, 1024, 1024, 1024, 64, 256, 16, 2};
  limits.native = limits.api;
  limits.localParameters = limits.envParameters = 16;
  limits.textureCoords = limits.textureImageUnits = limits.textureUnits = 8;
  limits.programMatrices = 8;
  limits.drawBuffers = kColorBuffers;
  return limits;
}

Subject arbSubject(std::uint64_t seed) {
  return checked(fp::ir::Language::ArbFragment,
                 fp::testing::spell(fp::testing::randomProgram(seed), seed), suiteLimits());
}

Subject atiSubject(std::uint64_t seed) {
  fp::Limits limits = suiteLimits();
  limits.atiRegisterRange = seed % 2 ? 8 : 0;
  return atiUnder(limits, seed, false);
}

Subject atiSubjectOfHost(std::uint64_t seed) { return atiUnder(suiteLimits(), seed, false); }
Subject atiSubjectOfPeer(std::uint64_t seed) { return atiUnder(suiteLimits(), seed, true); }

} // namespace arbiter::differential
