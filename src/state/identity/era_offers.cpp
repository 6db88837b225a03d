#include "state/identity/era_offers.h"

#include <string>

#include "state/capabilities/host_caps.h"
#include "state/identity/active_profile.h"
#include "util/flags.h"

namespace arbiter::state {

namespace {

struct Row {
  const char *name;
  bool EraOffers::*state; ///< set if the layer keeps state for it; null: the host knows its enums
  /// Host extensions that implement it; null: none.
  const char *needs, *needsToo;
  bool everyGeForce; ///< in the drivers of all GeForce cards with fragment programs
};

constexpr Row kRows[] = {
    {"GL_APPLE_client_storage", &EraOffers::clientStorage, nullptr, nullptr, false},
    {"GL_APPLE_fence", &EraOffers::appleFence, nullptr, nullptr, false},
    {"GL_APPLE_float_pixels", nullptr, "GL_ARB_texture_float", "GL_ARB_half_float_pixel", false},
    {"GL_APPLE_texture_range", &EraOffers::textureRange, nullptr, nullptr, false},
    {"GL_APPLE_transform_hint", &EraOffers::transformHint, nullptr, nullptr, false},
    {"GL_APPLE_vertex_array_object", &EraOffers::vertexArrayObject, "GL_ARB_vertex_array_object",
     nullptr, false},
    {"GL_APPLE_vertex_array_range", &EraOffers::appleRange, nullptr, nullptr, false},
    {"GL_ARB_imaging", &EraOffers::imaging, "GL_ARB_texture_float",
     "GL_ARB_texture_non_power_of_two", true},
    {"GL_ATIX_texture_env_combine3", nullptr, "GL_ATI_texture_env_combine3", nullptr, false},
    {"GL_ATI_envmap_bumpmap", &EraOffers::bumpMap, "GL_ARB_texture_float", "GL_ARB_texture_rg",
     false},
    {"GL_EXT_vertex_shader", &EraOffers::vertexShader, nullptr, nullptr, false},
    {"GL_NV_fence", &EraOffers::nvFence, nullptr, nullptr, true},
    {"GL_NV_multisample_filter_hint", &EraOffers::multisampleFilterHint, nullptr, nullptr, true},
    {"GL_NV_point_sprite", &EraOffers::pointSprite, "GL_ARB_point_sprite", nullptr, true},
    {"GL_NV_vertex_array_range", &EraOffers::nvRange, nullptr, nullptr, true},
    {"GL_NV_vertex_array_range2", &EraOffers::nvRange, nullptr, nullptr, true},
    {"GL_SGIX_depth_texture", nullptr, "GL_ARB_depth_texture", nullptr, true},
    {"GL_SGIX_shadow", &EraOffers::sgixShadow, "GL_ARB_shadow", nullptr, true},
};

/// True if `names`, separated by spaces, contains `name`.
bool lists(const std::string &names, const std::string &name) {
  return (" " + names + " ").find(" " + name + " ") != std::string::npos;
}

bool hasCard(const fp::hw::Profile &profile, const Row &row) {
  if (profile.fromHost)
    return true;
  const std::string &names = profile.identity.extensions.value;
  return names.empty() ? row.everyGeForce && profile.fragment.nvOptions != 0
                       : lists(names, row.name);
}

} // namespace

EraOffers eraOffers(const HostCaps &caps) {
  EraOffers offers;
  const fp::hw::Profile &profile = activeProfile();
  for (const Row &row : kRows) {
    if (caps.has(row.name) ||
        !(hasCard(profile, row) || isSwitchedOn(settings().extensions, row.name)) ||
        (row.needs && !caps.has(row.needs)) || (row.needsToo && !caps.has(row.needsToo)))
      continue;
    offers.names.push_back(row.name);
    if (row.state)
      offers.*row.state = true;
  }
  return offers;
}

} // namespace arbiter::state
