#include "state/identity/active_profile.h"

#include <algorithm>

#include "fp_compiler/ati/limits.h"
#include "state/capabilities/host_caps.h"
#include "state/objects/target.h"
#include "util/defaults/choice.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::state {

namespace {
constexpr GLint kMaxImageUnits = 32; ///< the compiler numbers no more
} // namespace

const fp::hw::Profile &activeProfile() {
  static const fp::hw::Profile *const s_profile = [] {
    auto loaded = fp::hw::loadProfile(settings().profile);
    if (loaded)
      return static_cast<const fp::hw::Profile *>(
          new fp::hw::Profile(std::move(loaded).value())); // never freed
    const defaults::Choice *const choice = defaults::ownChoiceIfRead();
    const defaults::Setting *const from = choice ? choice->find(Env::Profile) : nullptr;
    logWarn("state", "%s%s; going on with profile %s",
            from && from->used ? (from->place() + ": ").c_str() : "",
            loaded.error().message.c_str(), std::string(fp::hw::kDefaultProfile).c_str());
    return fp::hw::findBuiltin(fp::hw::kDefaultProfile);
  }();
  return *s_profile;
}

fp::Numerics activeNumerics() {
  return fp::numericsNamed(settings().numerics).value_or(activeProfile().numerics);
}

std::string_view nameOf(fp::Numerics numerics) { return fp::kNumericsNames[std::size_t(numerics)]; }

fp::Limits limitsUnder(const fp::hw::Profile &profile, Target target, const host::HostTable &host,
                       const HostCaps &caps) {
  if (target == Target::AtiText || target == Target::AtiApi)
    return fp::ati::limitsOf(limitsUnder(profile, Target::Fragment, host, caps));
  const bool vertex = target == Target::Vertex || target == Target::VertexState;
  const fp::Limits &ofProfile = vertex ? profile.vertex : profile.fragment;
  const bool fromHost = profile.fromHost && (vertex ? caps.vertexProgram : caps.fragmentProgram);
  // The host has only the two targets of the ARB extensions.
  const GLenum asked = infoOf(vertex ? Target::Vertex : Target::Fragment).name;
  fp::Limits limits = fromHost ? queryHostLimits(asked, host, caps) : ofProfile;
  limits.card = ofProfile.card;
  limits.nvOptions = caps.drawsNvOptions() ? ofProfile.nvOptions : 0;
  limits.nvVertexProgram = caps.drawsNvOptions() ? ofProfile.nvVertexProgram : 0;
  // A vertex program that samples may name the units of all stages.
  const GLint imageUnits = vertex && limits.nvOptions >= 2
                               ? std::min(caps.maxCombinedImageUnits, kMaxImageUnits)
                               : caps.maxTextureImageUnits;
  if (fromHost) {
    limits.textureImageUnits = std::uint32_t(imageUnits);
    return limits;
  }
  const auto clamp = [](std::uint32_t &value, GLint host_) {
    value = std::min(value, std::uint32_t(std::max(host_, 0)));
  };
  clamp(limits.textureCoords, caps.maxTextureCoords);
  clamp(limits.textureImageUnits, imageUnits);
  clamp(limits.textureUnits, caps.maxTextureUnits);
  clamp(limits.programMatrices, caps.maxProgramMatrices);
  clamp(limits.programMatrixStackDepth, caps.maxProgramMatrixStackDepth);
  clamp(limits.vertexAttribs, caps.maxVertexAttribs);
  // The host answers queries of these limits unless the card's identity is asked for (cardValue()
  // in gets.cpp). A program may use exactly what the query promises.
  if (!settings().identityOfProfile)
    limits.drawBuffers = limits.clipPlanes = UINT32_MAX;
  clamp(limits.drawBuffers, caps.maxDrawBuffers);
  clamp(limits.clipPlanes, caps.maxClipPlanes);
  // GLSL has no names for palette matrices and vertex units, so no program could read them.
  limits.paletteMatrices = 0;
  limits.vertexUnits = 1;
  return limits;
}

} // namespace arbiter::state
