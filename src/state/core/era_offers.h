#pragma once
#include <vector>

namespace arbiter::state {

struct HostCaps;

/// What of these extensions the layer answers for.
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
  /// Names in the extension string, of those that need no state beyond the host's too.
  std::vector<const char *> names;

  [[nodiscard]] bool any() const { return !names.empty(); }
};

/// By profile: a card's profile has what its driver announced (its [identity]; a profile of
/// NVIDIA's options without such a list has what all those cards had), the host's own has all, and
/// ARBITER_EXTENSIONS may ask for single ones. What
/// the host has itself stays the host's, and what rests on a function that it lacks is not offered.
[[nodiscard]] EraOffers eraOffers(const HostCaps &caps);

} // namespace arbiter::state
