#include "scene/texture/generate.h"

#include <cassert>
#include <filesystem>

#include "scene/texture/generators.h"

namespace arbiter::scene {

namespace {

using Images = Result<std::vector<Image>, TextureError>;

Images readFiles(const TextureSource &source, const std::string &folder) {
  std::vector<Image> images;
  for (const Name &file : source.files) {
    // A panel has no absolute names; a command line may.
    const std::string path = file.text.starts_with('/') ? file.text : folder + file.text;
    std::error_code error;
    // A pipe could keep the reader waiting for ever.
    if (!std::filesystem::is_regular_file(path, error))
      return TextureError{file.span,
                          path + ": " + (error ? error.message() : "is no regular file")};
    const auto picture = readPng(path);
    if (!picture)
      return TextureError{file.span, picture.error().message};
    images.emplace_back(picture.value());
    const Image &image = images.back();
    if (images.size() > 1 || source.generator.value == Generator::Cube)
      if (image.width != images.front().width || image.height != image.width)
        return TextureError{file.span, file.text + ": the faces of a cube are squares of one size"};
  }
  return images;
}

/// Generators of one image from their arguments alone.
Image makeFlat(const TextureSource &source, int width, int height) {
  switch (source.generator.value) {
  case Generator::Checker:
    return makeChecker(source, width, height);
  case Generator::Noise:
    return makeNoise(width, height);
  case Generator::Clouds:
    return makeClouds(source, width, height);
  case Generator::Gradient:
    return makeGradient(source, width, height);
  case Generator::Spot:
    return makeSpot(source, width, height);
  case Generator::Bricks:
    return makeBricks(source, width, height);
  case Generator::Bumps:
    return makeBumps(source, width, height);
  case Generator::Landscape:
    return makeLandscape(width, height);
  case Generator::Cells:
    return makeCells(source, width, height);
  case Generator::Rule:
    return makeRule();
  case Generator::Hairs:
    return makeHairs(source, width, height);
  case Generator::Twirl:
    return makeTwirl(source, width, height);
  case Generator::Ripple:
    return makeRipple(source, width, height);
  default:
    return makeConstant(source, width, height);
  }
}

Images makeSized(const TextureSource &source, const std::string &folder, int width, int height);

Images feedback(const TextureSource &source, const std::string &folder, int width, int height) {
  if (source.of.empty())
    return std::vector<Image>{Image(width, height)};
  Images inner = makeSized(source.of.front(), folder, width, height);
  if (inner && (inner.value()[0].width != width || inner.value()[0].height != height))
    return TextureError{source.of.front().generator.span,
                        "what feedback begins with must have the size of the picture, " +
                            std::to_string(width) + " " + std::to_string(height)};
  return inner;
}

Images makeSized(const TextureSource &source, const std::string &folder, int width, int height) {
  switch (source.generator.value) {
  case Generator::File:
  case Generator::Cube:
    return readFiles(source, folder);
  case Generator::Normalise:
    return makeNormalise(width);
  case Generator::Sky:
    return makeSky(source, width);
  case Generator::Normals: {
    const TextureSource &heights = source.of.front();
    Images inner = makeSized(heights, folder, int(heights.width.value), int(heights.height.value));
    if (!inner)
      return inner;
    return std::vector<Image>{
        makeNormals(inner.value().front(), float(source.argument("strength")))};
  }
  default:
    return std::vector<Image>{makeFlat(source, width, height)};
  }
}

} // namespace

Images generate(const TextureSource &source, const std::string &folder, int width, int height) {
  assert(source.generator.value != Generator::Picture &&
         source.generator.value != Generator::DepthOf);
  if (source.generator.value == Generator::Feedback)
    return feedback(source, folder, width, height);
  return makeSized(source, folder, int(source.width.value), int(source.height.value));
}

} // namespace arbiter::scene
