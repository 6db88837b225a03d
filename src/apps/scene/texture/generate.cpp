#include "apps/scene/texture/generate.h"

#include <cassert>
#include <filesystem>

#include "apps/scene/texture/generators.h"
#include "apps/scene/texture/read_image.h"

namespace arbiter::scene {

namespace {

using Images = Result<std::vector<Image>, TextureError>;

std::string pathOf(const Name &file, const std::string &folder) {
  // A panel has no absolute names, but a command line may.
  return file.text.starts_with('/') ? file.text : folder + file.text;
}

Images readFile(const Name &file, const std::string &folder, Rows rows) {
  const std::string path = pathOf(file, folder);
  std::error_code error;
  // A pipe could block the reader forever.
  if (!std::filesystem::is_regular_file(path, error))
    return TextureError{file.span, path + ": " + (error ? error.message() : "is no regular file")};
  auto images = readImage(path, rows);
  if (!images)
    return TextureError{file.span, images.error().message};
  return std::move(images).value();
}

Images readFlat(const Name &file, const std::string &folder) {
  Images images = readFile(file, folder, Rows::BottomFirst);
  if (images && images.value().size() != 1)
    return TextureError{file.span, file.text + ": has the faces of a cube map; 'cube " + file.text +
                                       "' is one"};
  return images;
}

Images readCube(const TextureSource &source, const std::string &folder) {
  std::vector<Image> faces;
  for (const Name &file : source.files) {
    Images images = readFile(file, folder, Rows::TopFirst);
    if (!images)
      return images;
    if (images.value().size() != 6 / source.files.size())
      return TextureError{file.span, file.text + (images.value().size() == 1
                                                      ? ": has no faces of a cube map"
                                                      : ": is a whole cube map, and not a face")};
    for (Image &image : images.value()) {
      faces.push_back(std::move(image));
      if (faces.back().width != faces.front().width || faces.back().height != faces.back().width)
        return TextureError{file.span, file.text + ": the faces of a cube are squares of one size"};
    }
  }
  return faces;
}

/// Makes one image from the generator's arguments alone.
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
    return readFlat(source.files.front(), folder);
  case Generator::Cube:
    return readCube(source, folder);
  case Generator::Normalize:
    return makeNormalize(width);
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
