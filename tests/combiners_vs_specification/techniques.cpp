// techniques [--png FOLDER]: draws techniques of games of 2002 with register combiners and with the
// programs of their ARB paths, and compares the pictures. One is a glow that four taps of a
// rectangle texture blur. The other is bump mapping with a normalisation cube map, a specular term
// that a square and a bias sharpen, and an attenuation. Ends with a line of JSON. The status is 1
// if a pixel differs by more than 2 of 255.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <png.h>
#include <string>

#include "open_context.h"
#include "techniques.h"

namespace {

using namespace techniques;

constexpr int kTolerance = 2; ///< in 255ths

Picture read() {
  Picture picture(std::size_t(kSize) * kSize * 4);
  glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
  return picture;
}

/// A way to shade.
enum class Way { Combiners, Program };
void endWay() {
  glDisable(GL_REGISTER_COMBINERS_NV);
  glDisable(GL_FRAGMENT_PROGRAM_ARB);
}

Picture drawnBy(Way way, const Technique &technique) {
  way == Way::Combiners ? technique.byCombiners() : technique.byProgram();
  glClear(GL_COLOR_BUFFER_BIT);
  technique.draw();
  Picture picture = read();
  endWay();
  return picture;
}

void write(const std::string &path, const Picture &picture) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = image.height = kSize;
  image.format = PNG_FORMAT_RGBA;
  // GL's first row is the bottom one.
  if (!png_image_write_to_file(&image, path.c_str(), 0, picture.data(), -kSize * 4, nullptr))
    std::fprintf(stderr, "%s: %s\n", path.c_str(), image.message);
}

int worstOf(const Picture &a, const Picture &b) {
  int worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    worst = std::max(worst, std::abs(int(a[i]) - int(b[i])));
  return worst;
}

int compareAll(const char *folder) {
  bindTarget(kSize, kSize);
  int worstOfAll = 0;
  std::printf("{");
  for (const Technique &technique : {kGlow, kBumps}) {
    technique.makeTextures();
    const Picture combined = drawnBy(Way::Combiners, technique);
    const Picture programmed = drawnBy(Way::Program, technique);
    const int worst = worstOf(combined, programmed);
    const auto lit = std::count_if(combined.begin(), combined.end(),
                                   [](std::uint8_t byte) { return byte > 64 && byte < 255; });
    std::printf("\"%s\": {\"worst_steps\": %d, \"lit\": %ld}, ", technique.name, worst, long(lit));
    worstOfAll = std::max(worstOfAll, lit > 3000 ? worst : 255); // an empty picture proves nothing
    if (folder) {
      write(std::string(folder) + "/" + technique.name + "-combiners.png", combined);
      write(std::string(folder) + "/" + technique.name + "-program.png", programmed);
    }
    for (GLenum unit = 0; unit < 4; ++unit) {
      glActiveTexture(GL_TEXTURE0 + unit);
      for (const GLenum target : {GL_TEXTURE_RECTANGLE, GL_TEXTURE_2D, GL_TEXTURE_CUBE_MAP})
        glDisable(target);
    }
  }
  const GLenum error = glGetError();
  std::printf("\"error\": %u}\n", error);
  return worstOfAll <= kTolerance && error == GL_NO_ERROR ? 0 : 1;
}

} // namespace

int main(int argc, char **argv) {
  const bool writes = argc == 3 && std::string(argv[1]) == "--png";
  if (argc != 1 && !writes) {
    std::fprintf(stderr, "usage: techniques [--png FOLDER]\n");
    return 2;
  }
  if (!openContextWith("GL_NV_register_combiners"))
    return kSkipped;
  return compareAll(writes ? argv[2] : nullptr);
}
