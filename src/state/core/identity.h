#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/hw/profile.h"
#include "state/capabilities/host_caps.h"

namespace arbiter {
struct ExtensionSwitch;
}

/// Whom a compatibility context says it is: GL_VENDOR, GL_RENDERER, GL_VERSION,
/// GL_SHADING_LANGUAGE_VERSION and the extensions. What is announced works: a card's list is cut to
/// what host and layer have, never the other way round.
namespace arbiter::state {

/// What the settings ask for.
struct IdentityRules {
  const fp::hw::Identity *card = nullptr; ///< null: the host's own identity
  std::uint32_t maxYear = 0;              ///< of an extension; 0: any
  std::uint32_t maxLength = 0;            ///< bytes of the joined list; 0: any
  std::uint32_t nvFragmentOptions = 0;    ///< Limits::nvOptions of fragment programs
  std::uint32_t nvVertexOptions = 0;      ///< and of vertex programs
  std::uint32_t generalCombiners = 0;     ///< stages of NV_register_combiners; 0: not offered
  bool perStageConstants = false;         ///< and NV_register_combiners2
  std::uint32_t textureShaders = 0;       ///< the first so many of NV_texture_shader, 2 and 3
  bool nvAsHost = false; ///< of NVIDIA's extensions only those that the host announces too
  std::uint32_t nvVertexProgram = 0; ///< Limits::nvVertexProgram
  /// Names that are announced, or are not, whatever the rules above say; null: none.
  const std::vector<ExtensionSwitch> *switches = nullptr;

  [[nodiscard]] bool cutExtensions() const { return card || maxYear != 0 || maxLength != 0; }
};

/// ARBITER_IDENTITY, ARBITER_EXTENSIONS_MAX_YEAR and ARBITER_EXTENSIONS_MAX_LENGTH, with the active
/// profile's card.
[[nodiscard]] IdentityRules identityRules();

/// The answers; an empty string is left to the host.
struct Identity {
  std::string vendor;
  std::string renderer;
  std::string version;
  std::string shadingLanguage;
  bool hidesShadingLanguage = false; ///< GL_SHADING_LANGUAGE_VERSION is no enum of this version
  int major = 0;                     ///< of `version`; 0: the host's
  int minor = 0;
  FilteredExtensions extensions;
  std::vector<std::string> absent; ///< to be announced, and neither host nor layer has them

  bool operator==(const Identity &) const = default;
};

/// `offered`: the layer implements ARB_fragment_program in this context. A card's version above the
/// host's is not taken over: it would promise entry points that are not there.
[[nodiscard]] Identity makeIdentity(const HostCaps &caps, bool offered, const IdentityRules &rules);

/// The one copy of such an identity in the process, which is never freed: applications keep the
/// pointers of GetString beyond the life of the context that gave them (6.1.11: static strings).
[[nodiscard]] const Identity &internIdentity(Identity identity);

/// The year in which an extension was first written (extension_years.def); nothing if not known.
[[nodiscard]] std::optional<std::uint32_t> extensionYear(std::string_view name);

} // namespace arbiter::state
