// usage: gallery_test ARBITER FOLDER bare|host|swrast
// Draws every document of the gallery by `arbiter draw`, and compares each pixel with what the
// compiler's interpreter makes of the same document.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <set>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

#include "reference.h"

extern char **environ;

namespace gallery {

namespace {

namespace fs = std::filesystem;

/// How far the two pictures may be apart.
struct Case {
  const char *file;
  int frame;
  const char *size; ///< nullptr: the document's own
  int levels;       ///< of 255, in red, green, blue and alpha
  double outliers;  ///< fraction of the pixels that may be farther apart
};

// Filtering weights have 8 bits on common hosts: up to 1/256 of an edge, on each axis. Outliers are
// pixels on silhouettes and on edges of shadows, whose sample falls to the other side.
constexpr Case kCases[] = {
    {"blur.fp", 0, "128x128", 4, 0},
    {"brightness_contrast.fp", 0, "128x128", 4, 0},
    {"cartoon.fp", 0, "128x128", 4, 0.004},
    {"edges.fp", 0, "128x128", 12, 0},
    {"fur.fp", 0, "128x128", 4, 0.02},
    {"gooch.fp", 30, "128x128", 4, 0.004},
    {"life.fp", 6, nullptr, 0, 0},
    {"life_reduced.fp", 6, nullptr, 0, 0},
    {"light_map.fp", 0, "128x128", 5, 0.004},
    {"lighting_1_normals.fp", 0, "128x128", 5, 0.004},
    {"lighting_2_diffuse.fp", 20, "128x128", 4, 0.004},
    {"lighting_3_bumps.fp", 20, "128x128", 6, 0.01},
    {"lighting_4_all.fp", 20, "128x128", 8, 0.01},
    {"pass_through.fp", 0, "128x128", 4, 0},
    {"particles.fp", 50, "128x128", 6, 0.004},
    {"reflection.fp", 0, "128x128", 5, 0.01},
    {"shadow_map.fp", 0, "128x128", 4, 0.01},
    {"shadow_volume.fp", 0, "128x128", 4, 0.01},
    {"skinning.fp", 40, "128x128", 5, 0.006},
    {"twirl.fp", 10, "128x128", 6, 0},
};

struct Difference {
  int largest = 0;
  std::size_t beyond = 0; ///< pixels beyond the case's levels
};

Difference compare(const scene::Picture &drawn, const scene::Picture &reference, int levels) {
  Difference difference;
  for (std::size_t i = 0; i < reference.bytes.size(); i += 4) {
    int worst = 0;
    for (std::size_t k = i; k < i + 4; ++k)
      worst = std::max(worst, std::abs(int(drawn.bytes[k]) - int(reference.bytes[k])));
    difference.largest = std::max(difference.largest, worst);
    difference.beyond += worst > levels;
  }
  return difference;
}

/// \returns the exit code.
int run(const std::vector<std::string> &words) {
  std::vector<char *> argv;
  for (const std::string &word : words)
    argv.push_back(const_cast<char *>(word.c_str()));
  argv.push_back(nullptr);
  ::pid_t child = 0;
  int status = 0;
  if (::posix_spawn(&child, argv[0], nullptr, nullptr, argv.data(), environ) != 0 ||
      ::waitpid(child, &status, 0) < 0)
    return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

class Gallery {
public:
  Gallery(std::string arbiter, fs::path folder, const std::string &way)
      : m_arbiter(std::move(arbiter)), m_folder(std::move(folder)),
        m_options(way == "bare" ? std::vector<std::string>{"--bare"}
                                : std::vector<std::string>{"--backend", way}),
        m_output((fs::temp_directory_path() / ("gallery-" + std::to_string(::getpid()) + ".png"))
                     .string()) {}
  Gallery(const Gallery &) = delete;
  Gallery &operator=(const Gallery &) = delete;
  ~Gallery() { std::remove(m_output.c_str()); }

  bool check(const Case &each) {
    const auto drawn = draw(each, each.frame);
    const auto reference = interpret(each, each.frame);
    if (!drawn || !reference)
      return false;
    const Difference difference = compare(*drawn, *reference, each.levels);
    const double pixels = double(reference->bytes.size()) / 4;
    const bool good = double(difference.beyond) <= each.outliers * pixels && isAPicture(*reference);
    std::printf("%-26s largest difference %3d of %d, beyond it %zu pixels of %.0f%s\n", each.file,
                difference.largest, each.levels, difference.beyond, each.outliers * pixels,
                good ? "" : "  FAILED");
    if (!good)
      keep(each, *drawn, *reference);
    return good;
  }

  /// The test can fail: another frame of an animation is another picture.
  bool seesADifference() {
    const Case &twirl = kCases[std::size(kCases) - 1];
    const auto drawn = draw(twirl, twirl.frame);
    const auto reference = interpret(twirl, twirl.frame + 30);
    if (!drawn || !reference || compare(*drawn, *reference, twirl.levels).beyond > 0)
      return drawn && reference;
    std::printf("two frames of %s look the same\n", twirl.file);
    return false;
  }

private:
  std::optional<scene::Picture> draw(const Case &each, int frame) const {
    std::vector<std::string> words = {
        m_arbiter, "draw",  (m_folder / each.file).string(), "--frame", std::to_string(frame),
        "-o",      m_output};
    words.insert(words.end(), m_options.begin(), m_options.end());
    if (each.size != nullptr)
      words.insert(words.end(), {"--size", each.size});
    if (const int code = run(words); code != 0) {
      std::printf("%s: arbiter draw ended with %d\n", each.file, code);
      return std::nullopt;
    }
    auto picture = scene::readPng(m_output);
    return picture ? std::optional(std::move(picture).value()) : std::nullopt;
  }

  std::optional<scene::Picture> interpret(const Case &each, int frame) const {
    auto loaded = scene::loadDocument((m_folder / each.file).string());
    if (!loaded || !loaded.value().ok()) {
      std::printf("%s is no document\n", each.file);
      return std::nullopt;
    }
    scene::Document &document = loaded.value();
    int width = 0, height = 0;
    if (each.size != nullptr && std::sscanf(each.size, "%dx%d", &width, &height) == 2) {
      document.files[0].panel.width.value = width;
      document.files[0].panel.height.value = height;
    }
    Reference reference(document);
    for (int i = document.hasFeedback() ? 0 : frame; i <= frame; ++i)
      reference.draw(i);
    return reference.picture();
  }

  /// More than one colour: an empty picture would prove nothing.
  static bool isAPicture(const scene::Picture &picture) {
    std::set<std::uint32_t> colours;
    for (std::size_t i = 0; i < picture.bytes.size(); i += 4) {
      std::uint32_t colour = 0;
      std::memcpy(&colour, &picture.bytes[i], 4);
      colours.insert(colour);
    }
    return colours.size() > 1;
  }

  static void keep(const Case &each, const scene::Picture &drawn, const scene::Picture &reference) {
    const char *const folder = std::getenv("GALLERY_KEEP");
    if (folder == nullptr)
      return;
    const std::string stem = std::string(folder) + "/" + fs::path(each.file).stem().string();
    (void)scene::writePng(stem + "-drawn.png", drawn);
    (void)scene::writePng(stem + "-reference.png", reference);
  }

  std::string m_arbiter;
  fs::path m_folder;
  std::vector<std::string> m_options;
  std::string m_output;
};

/// Every document has a case. Files of further passes are no documents of their own.
bool allHaveCases(const fs::path &folder) {
  std::set<std::string> known;
  for (const Case &each : kCases) {
    known.insert(each.file);
    if (const auto document = scene::loadDocument((folder / each.file).string()))
      for (const scene::ProgramFile &file : document.value().files)
        known.insert(fs::path(file.name).filename().string());
  }
  bool good = true;
  for (const auto &entry : fs::directory_iterator(folder))
    if (const auto name = entry.path().filename().string();
        entry.path().extension() == ".fp" && !known.contains(name)) {
      std::printf("%s has no case here\n", name.c_str());
      good = false;
    }
  return good;
}

} // namespace

} // namespace gallery

int main(int argc, char **argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: %s ARBITER FOLDER bare|host|swrast [DOCUMENT]\n", argv[0]);
    return 2;
  }
  gallery::Gallery gallery(argv[1], argv[2], argv[3]);
  bool good = gallery::allHaveCases(argv[2]);
  for (const gallery::Case &each : gallery::kCases)
    if (argc < 5 || std::strcmp(argv[4], each.file) == 0)
      good = gallery.check(each) && good;
  if (argc < 5)
    good = gallery.seesADifference() && good;
  return good ? 0 : 1;
}
