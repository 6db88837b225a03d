#pragma once
#include <string>

#include "apps/scene/panel/panel.h"
#include "apps/scene/texture/image.h"
#include "util/result.h"

namespace arbiter::scene {

struct TextureError {
  fp::Span span; ///< of the word or name that is wrong
  std::string message;
};

/// Makes the images of a source: one, or six faces of a cube map in GL's order.
/// \param folder the document's folder, where its files are; ends with a slash, or is empty. An
///        absolute name, which a panel never has, is used as it is.
/// \param width,height of the document's picture: feedback begins with an image of that size
/// Requires that the source is neither Picture nor DepthOf, which passes draw.
[[nodiscard]] Result<std::vector<Image>, TextureError>
generate(const TextureSource &source, const std::string &folder, int width, int height);

} // namespace arbiter::scene
