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

/// The reported vendor, renderer, versions and extensions of a compatibility context: GL_VENDOR,
/// GL_RENDERER, GL_VERSION, GL_SHADING_LANGUAGE_VERSION. A card's extension list is cut to what
/// host and layer implement, so that everything announced works.
namespace arbiter::state {

/// The identity that the settings ask for.
struct IdentityRules {
  const fp::hw::Identity *card = nullptr; ///< null: the host's own identity
  std::uint32_t maxYear = 0;              ///< last year of an announced extension; 0: any
  std::uint32_t maxLength = 0;            ///< most bytes of the joined list; 0: any
  std::uint32_t nvFragmentOptions = 0;    ///< Limits::nvOptions of fragment programs
  std::uint32_t nvVertexOptions = 0;      ///< Limits::nvOptions of vertex programs
  std::uint32_t generalCombiners = 0;     ///< stages of NV_register_combiners; 0: not offered
  bool perStageConstants = false;         ///< NV_register_combiners2 is offered
  std::uint32_t textureShaders = 0;       ///< announces the first so many of NV_texture_shader, 2
                                          ///< and 3
  bool nvAsHost = false; ///< announces only those of NVIDIA's extensions that the host announces
  std::uint32_t nvVertexProgram = 0; ///< Limits::nvVertexProgram
  /// Names that are shown or hidden whatever the rules above say; null: none.
  const std::vector<ExtensionSwitch> *switches = nullptr;

  [[nodiscard]] bool cutExtensions() const { return card || maxYear != 0 || maxLength != 0; }
};

/// Returns the rules of the settings and the active profile's card. The settings are
/// ARBITER_IDENTITY, ARBITER_EXTENSIONS_MAX_YEAR and ARBITER_EXTENSIONS_MAX_LENGTH.
[[nodiscard]] IdentityRules identityRules();

/// The answers to the queries. An empty string leaves the query to the host.
struct Identity {
  std::string vendor;
  std::string renderer;
  std::string version;
  std::string shadingLanguage;
  bool hidesShadingLanguage = false; ///< GL_SHADING_LANGUAGE_VERSION is no enum in this version
  int major = 0;                     ///< from `version`; 0: the host's
  int minor = 0;
  FilteredExtensions extensions;
  std::vector<std::string> absent; ///< switched on, but implemented by neither host nor layer

  bool operator==(const Identity &) const = default;
};

/// Makes a context's identity. A card's version above the host's is ignored: it would promise entry
/// points that are not there.
/// \param offered the layer implements ARB_fragment_program in this context
[[nodiscard]] Identity makeIdentity(const HostCaps &caps, bool offered, const IdentityRules &rules);

/// Returns the process's one copy of an identity. It is never freed: applications keep the pointers
/// of GetString after the context is gone (6.1.11: static strings).
[[nodiscard]] const Identity &internIdentity(Identity identity);

/// Returns the year in which an extension was first written (extension_years.def), or nothing.
[[nodiscard]] std::optional<std::uint32_t> extensionYear(std::string_view name);

} // namespace arbiter::state
