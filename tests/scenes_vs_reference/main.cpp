// scenes [--png FOLDER | --require WAY]: draws each scene in each available way, and compares it
// with plain C++. Ends with a line of JSON, in which unavailable ways are null. The status is 1 if
// a picture differs more than its scene allows, or the required way is unavailable.
// scenes --pace SCENE [SIZE]: draws frames of one scene for a benchmark. The answer to a line "WAY
// COUNT" on standard input is the milliseconds of a frame, and those of all its threads' processor
// time.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <png.h>
#include <sstream>
#include <string>

#include "../combiners_vs_specification/open_context.h"
#include "../combiners_vs_specification/techniques.h"
#include "scenes.h"

namespace scenes {

namespace {

int g_size = 256;
constexpr double kMaxUndecided = 0.1; ///< the fraction of a picture

Picture read() {
  Picture picture(std::size_t(g_size) * std::size_t(g_size) * 4);
  glReadPixels(0, 0, g_size, g_size, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
  return picture;
}

bool isOffered(const Way &way) {
  std::istringstream names(way.needs);
  for (std::string name; names >> name;)
    if (!epoxy_has_gl_extension(name.c_str()))
      return false;
  return true;
}

void write(const std::string &path, const Picture &picture) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = image.height = png_uint_32(g_size);
  image.format = PNG_FORMAT_RGBA;
  Picture opaque = picture; // alpha is a strand's remaining coverage
  for (std::size_t i = 3; i < opaque.size(); i += 4)
    opaque[i] = 255;
  if (!png_image_write_to_file(&image, path.c_str(), 0, opaque.data(), -g_size * 4, nullptr))
    std::fprintf(stderr, "%s: %s\n", path.c_str(), image.message);
}

/// Returns the fraction of decided pixels that differ by more than `steps`.
double apart(const Picture &a, const Picture &b, const Canvas &canvas, int steps) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); i += 4) {
    if (canvas.undecided[i / 4])
      continue;
    int worst = 0;
    for (std::size_t c = 0; c < 3; ++c)
      worst = std::max(worst, std::abs(int(a[i + c]) - int(b[i + c])));
    count += worst > steps ? 1u : 0u;
  }
  return double(count) / double(a.size() / 4);
}

/// Returns the fraction of pixels that differ from the picture's first color: an empty picture
/// proves nothing.
double drawn(const Picture &picture) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < picture.size(); i += 4)
    count += !std::equal(picture.begin(), picture.begin() + 3, picture.begin() + long(i)) ? 1u : 0u;
  return double(count) / double(picture.size() / 4);
}

bool compare(const Scene &scene, const std::string &folder, const std::string &required) {
  scene.prepare();
  const Canvas canvas = scene.reference(g_size);
  const Picture reference = canvas.bytes();
  if (!folder.empty())
    write(folder + "/" + scene.name + "-reference.png", reference);
  const double undecided =
      double(std::count(canvas.undecided.begin(), canvas.undecided.end(), true)) /
      double(canvas.undecided.size());
  bool agrees = drawn(reference) > 0.05 && undecided < kMaxUndecided;
  std::printf("\"%s\": {", scene.name);
  for (const Way &way : scene.ways) {
    if (!isOffered(way)) {
      std::printf("\"%s\": null, ", way.name);
      agrees = agrees && way.name != required;
      continue;
    }
    way.begin();
    way.draw();
    way.draw(); // the first frame makes programs, the second shows that they last
    const Picture picture = read();
    way.end();
    const double off = apart(picture, reference, canvas, scene.steps);
    std::printf("\"%s\": %.5f, ", way.name, off);
    agrees = agrees && off <= scene.outliers;
    if (!folder.empty())
      write(folder + "/" + scene.name + "-" + way.name + ".png", picture);
  }
  std::printf("\"undecided\": %.5f, \"allowed\": %.5f}, ", undecided, scene.outliers);
  return agrees;
}

int compareAll(const std::string &folder, const std::string &required) {
  bool agree = true;
  std::printf("{");
  for (const Scene &scene : {furScene(), shadowScene(), skinningScene()})
    agree = compare(scene, folder, required) && agree;
  const GLenum error = glGetError();
  std::printf("\"error\": %u}\n", error);
  return agree && error == GL_NO_ERROR ? 0 : 1;
}

// --- For a benchmark ---

/// Makes a scene of two ways from a technique of techniques.h. Its textures stay.
template <const techniques::Technique &technique> Scene sceneOf() {
  const auto end = [] { endPrograms(); };
  return {technique.name,
          technique.makeTextures,
          {{"arb", "GL_ARB_fragment_program", technique.byProgram, technique.draw, end},
           {"combiners", "GL_NV_register_combiners", technique.byCombiners, technique.draw, end}},
          nullptr,
          2,
          0};
}

const Way *wayOf(const Scene &scene, const std::string &name) {
  const auto at = std::find_if(scene.ways.begin(), scene.ways.end(),
                               [&](const Way &way) { return name == way.name; });
  return at == scene.ways.end() || !isOffered(*at) ? nullptr : &*at;
}

int pace(const std::string &name) {
  for (const Scene &scene : {furScene(), shadowScene(), skinningScene(),
                             sceneOf<techniques::kGlow>(), sceneOf<techniques::kBumps>()}) {
    if (name != scene.name)
      continue;
    scene.prepare();
    std::string offered;
    for (const Way &way : scene.ways)
      if (isOffered(way))
        offered += std::string(offered.empty() ? "\"" : ", \"") + way.name + "\"";
    std::cout << "[" << offered << "]" << std::endl;
    const Way *current = nullptr;
    std::string wanted;
    for (int count = 0; std::cin >> wanted >> count;) {
      const Way *const way = wayOf(scene, wanted);
      if (!way)
        return 2;
      if (way != current) {
        if (current)
          current->end();
        way->begin();
        current = way;
      }
      const auto begin = std::chrono::steady_clock::now();
      const std::clock_t processor = std::clock();
      for (int i = 0; i < count; ++i) {
        way->draw();
        glFinish();
      }
      const std::chrono::duration<double, std::milli> took =
          std::chrono::steady_clock::now() - begin;
      const double busy = 1000.0 * double(std::clock() - processor) / CLOCKS_PER_SEC;
      std::cout << "[" << took.count() / count << ", " << busy / count << "]" << std::endl;
    }
    return 0;
  }
  return 2;
}

} // namespace

int pictureSize() { return g_size; }

int run(const std::vector<std::string> &arguments) {
  const std::string option = arguments.empty() ? "" : arguments[0];
  const bool paced = option == "--pace" && (arguments.size() == 2 || arguments.size() == 3);
  const bool known = option == "--png" || option == "--require";
  if (!paced && !arguments.empty() && !(known && arguments.size() == 2)) {
    std::fprintf(stderr, "usage: scenes [--png FOLDER | --require WAY | --pace SCENE [SIZE]]\n");
    return 2;
  }
  if (!openContextWith("GL_ARB_vertex_program"))
    return kSkipped;
  if (paced && arguments.size() == 3)
    g_size = std::max(std::atoi(arguments[2].c_str()), 16);
  bindTarget(g_size, g_size);
  if (paced)
    return pace(arguments[1]);
  return compareAll(option == "--png" ? arguments[1] : "",
                    option == "--require" ? arguments[1] : "");
}

} // namespace scenes

int main(int argc, char **argv) { return scenes::run({argv + 1, argv + argc}); }
