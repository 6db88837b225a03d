#pragma once
#include <vector>

namespace arbiter::state {

struct HostCaps;

/// The extensions of this room that the layer implements in a context.
struct EraOffers {
  bool nvFence = false;
  bool appleFence = false;
  bool nvRange = false;
  bool appleRange = false;
  bool multisampleFilterHint = false;
  bool transformHint = false;
  bool sgixShadow = false;
  bool bumpMap = false;
  bool clientStorage = false;
  bool imaging = false;
  bool pointSprite = false;
  bool textureRange = false;
  bool vertexArrayObject = false;
  bool vertexShader = false;
  /// Their names for the extension string, including those that need no state of the layer's.
  std::vector<const char *> names;

  [[nodiscard]] bool any() const { return !names.empty(); }
};

/// Returns what the profile offers on this host. A card's profile offers what its driver announced
/// ([identity]). A profile with NVIDIA's options and no such list offers what all those cards had.
/// The host's own profile offers everything, and ARBITER_EXTENSIONS may add single ones. An
/// extension that the host has stays the host's, and one that needs a missing host function is not
/// offered.
[[nodiscard]] EraOffers eraOffers(const HostCaps &caps);

} // namespace arbiter::state
