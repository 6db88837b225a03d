// usage: gallery_test ARBITER FOLDER WAYS [DOCUMENT]
// Draws every document of the gallery by `arbiter draw`, and compares each pixel with the
// compiler's interpreter. WAYS are some of bare,host,swrast: the bare host, and the back ends of
// the layer. GALLERY_KEEP names a folder for the pictures and their references.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
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

/// The allowed difference of the two pictures.
struct Case {
  const char *file;
  int frame;
  const char *size; ///< nullptr: the document's own
  int levels;       ///< of 255, in red, green, blue and alpha
  double outliers;  ///< the fraction of pixels that may differ more
  /// Whether the bare host can draw it: common ones lack ATI_text_fragment_shader
  bool bare = true;
};

// Filtering weights have 8 bits on common hosts, so that the error is up to 1/256 of an edge on
// each axis. Outliers are pixels on silhouettes and on edges of shadows, whose sample falls to the
// other side.
constexpr Case kCases[] = {
    {"ati_bumps.fp", 20, "96x96", 4, 0.002, false},
    {"blur.fp", 0, "96x96", 2, 0},
    {"brightness_contrast.fp", 0, "96x96", 3, 0},
    {"cartoon.fp", 0, "96x96", 2, 0.002},
    {"edges.fp", 0, "96x96", 6, 0},
    {"fur.fp", 0, "96x96", 2, 0.012},
    {"gooch.fp", 30, "96x96", 2, 0.001},
    {"life.fp", 6, nullptr, 0, 0},
    {"life_reduced.fp", 6, nullptr, 0, 0},
    {"light_map.fp", 0, "96x96", 3, 0.001},
    {"lighting_1_normals.fp", 0, "96x96", 4, 0.001},
    {"lighting_2_diffuse.fp", 20, "96x96", 2, 0.001},
    {"lighting_3_bumps.fp", 20, "96x96", 4, 0.001},
    {"lighting_4_all.fp", 20, "96x96", 4, 0.002},
    {"pass_through.fp", 0, "96x96", 2, 0},
    {"particles.fp", 50, "96x96", 4, 0.001},
    {"reflection.fp", 0, "96x96", 3, 0.001},
    {"shadow_map.fp", 0, "96x96", 2, 0.002},
    {"shadow_volume.fp", 0, "96x96", 2, 0.002},
    {"skinning.fp", 40, "96x96", 3, 0.001},
    {"twirl.fp", 10, "96x96", 2, 0.001},
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

/// Runs a command. \returns the exit code.
int run(const std::vector<std::string> &words) {
  std::vector<char *> argv;
  for (const std::string &word : words)
    argv.push_back(const_cast<char *>(word.c_str()));
  argv.push_back(nullptr);
  // The command's output is discarded.
  ::posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  ::pid_t child = 0;
  int status = -1;
  const bool ended = ::posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ) == 0 &&
                     ::waitpid(child, &status, 0) >= 0;
  ::posix_spawn_file_actions_destroy(&actions);
  return ended && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Splits "bare,host" into words.
std::vector<std::string> waysOf(const std::string &list) {
  std::vector<std::string> ways;
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t comma = std::min(list.find(',', at), list.size());
    ways.push_back(list.substr(at, comma - at));
    at = comma + 1;
  }
  return ways;
}

class Gallery {
public:
  Gallery(std::string arbiter, fs::path folder, const std::string &ways)
      : m_arbiter(std::move(arbiter)), m_folder(std::move(folder)), m_ways(waysOf(ways)),
        m_output((fs::temp_directory_path() / ("gallery-" + std::to_string(::getpid()) + ".png"))
                     .string()) {}
  Gallery(const Gallery &) = delete;
  Gallery &operator=(const Gallery &) = delete;
  ~Gallery() { std::remove(m_output.c_str()); }

  bool check(const Case &each) {
    const auto reference = interpret(each, each.frame);
    bool good = reference && isAPicture(*reference);
    for (const std::string &way : m_ways)
      if (each.bare || way != "bare")
        good = reference && checkWay(each, way, *reference) && good;
    return good;
  }

  /// Checks that the test can fail: another frame of an animation is another picture.
  bool seesADifference() {
    const Case &twirl = kCases[std::size(kCases) - 1];
    const auto drawn = draw(twirl, m_ways.front());
    const auto reference = interpret(twirl, twirl.frame + 30);
    if (!drawn || !reference || compare(*drawn, *reference, twirl.levels).beyond > 0)
      return drawn && reference;
    std::printf("two frames of %s look the same\n", twirl.file);
    return false;
  }

private:
  bool checkWay(const Case &each, const std::string &way, const scene::Picture &reference) const {
    const auto drawn = draw(each, way);
    if (!drawn || drawn->bytes.size() != reference.bytes.size())
      return false;
    const Difference difference = compare(*drawn, reference, each.levels);
    const double most = each.outliers * double(reference.bytes.size()) / 4;
    const bool good = double(difference.beyond) <= most;
    std::printf("%-24s %-6s largest difference %3d of %2d, beyond it %4zu pixels of %3.0f%s\n",
                each.file, way.c_str(), difference.largest, each.levels, difference.beyond, most,
                good ? "" : "  FAILED");
    keep(each, way, *drawn, reference);
    return good;
  }

  std::optional<scene::Picture> draw(const Case &each, const std::string &way) const {
    std::vector<std::string> words = {
        m_arbiter, "draw",  (m_folder / each.file).string(), "--frame", std::to_string(each.frame),
        "-o",      m_output};
    if (way == "bare")
      words.emplace_back("--bare");
    else
      words.insert(words.end(), {"--backend", way});
    if (each.size != nullptr)
      words.insert(words.end(), {"--size", each.size});
    if (const int code = run(words); code != 0) {
      std::printf("%s: arbiter draw (%s) ended with %d\n", each.file, way.c_str(), code);
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

  /// True if the picture has several colors: an empty one would prove nothing.
  static bool isAPicture(const scene::Picture &picture) {
    std::set<std::uint32_t> colors;
    for (std::size_t i = 0; i < picture.bytes.size(); i += 4) {
      std::uint32_t color = 0;
      std::memcpy(&color, &picture.bytes[i], 4);
      colors.insert(color);
    }
    return colors.size() > 1;
  }

  static void keep(const Case &each, const std::string &way, const scene::Picture &drawn,
                   const scene::Picture &reference) {
    const char *const folder = std::getenv("GALLERY_KEEP");
    if (folder == nullptr)
      return;
    const std::string stem = std::string(folder) + "/" + fs::path(each.file).stem().string();
    (void)scene::writePng(stem + "-" + way + ".png", drawn);
    (void)scene::writePng(stem + "-reference.png", reference);
  }

  std::string m_arbiter;
  fs::path m_folder;
  std::vector<std::string> m_ways;
  std::string m_output;
};

/// True if every document has a case. Files of further passes are not documents.
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
    std::fprintf(stderr, "usage: %s ARBITER FOLDER WAYS [DOCUMENT]\n", argv[0]);
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
