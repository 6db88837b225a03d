#pragma once
#include <string>

#include "scene/panel/panel.h"
#include "scene/texture/image.h"
#include "util/result.h"

namespace arbiter::scene {

struct TextureError {
  fp::Span span; ///< of the word or name that is wrong
  std::string message;
};

/// The images of a source: one, or six faces of a cube map in GL's order.
/// \param folder of the document, where its files are; with a slash behind it, or empty. An
///        absolute name, which a panel never has, is taken as it is.
/// \param width,height of the document's picture: the size of what feedback begins with, whatever
///        numbers stand there
/// Requires: the source is neither Picture nor DepthOf, which passes draw.
[[nodiscard]] Result<std::vector<Image>, TextureError>
generate(const TextureSource &source, const std::string &folder, int width, int height);

} // namespace arbiter::scene
