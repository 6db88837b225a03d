#include "interposer/process.h"

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>
#include <string_view>

#include <dlfcn.h>
#include <sys/auxv.h>
#include <unistd.h>

#include "interposer/first.h"
#include "util/defaults/choice.h"
#include "util/flags.h"
#include "util/loader_path.h"
#include "util/log.h"
#include "util/unwinder.h"

namespace arbiter::interposer {

namespace {

constexpr const char *kEglSelection = "__EGL_VENDOR_LIBRARY_FILENAMES";
/// Child processes find the selection already changed; these variables hold the previous one.
constexpr const char *kSavedGlx = "ARBITER_SAVED_GLX_VENDOR";
constexpr const char *kSavedEgl = "ARBITER_SAVED_EGL_VENDORS";
/// The ICD files beside the library, in the build tree and installed: one names it by path, one by
/// name.
constexpr const char *kIcdByPath = "/arbiter/10_arbiter.json";
constexpr const char *kIcdByName = "/arbiter/11_arbiter.json";

char *g_savedGlx = nullptr;
char *g_savedEgl = nullptr;

char *copy(const char *text) { return text && *text ? strdup(text) : nullptr; }

bool holds(const std::string &file, const std::string &text) {
  char buffer[4096];
  FILE *const stream = std::fopen(file.c_str(), "re");
  if (!stream)
    return false;
  const std::size_t bytes = std::fread(buffer, 1, sizeof buffer, stream);
  std::fclose(stream);
  return std::string_view(buffer, bytes).find(text) != std::string_view::npos;
}

/// Returns this library's path without symbolic links; "" if it cannot be found.
std::string ownPath() {
  Dl_info self;
  if (!dladdr(reinterpret_cast<const void *>(&ownPath), &self) || !self.dli_fname)
    return {};
  char *const real = realpath(self.dli_fname, nullptr);
  std::string library = real ? real : "";
  free(real);
  return library;
}

/// Returns the ICD file that leads to this library; "" if there is none beside it. The file with a
/// path also serves child processes that lose LD_PRELOAD. In an installation that was moved only
/// the one with a name is right.
std::string ownIcdFile() {
  const std::string library = ownPath();
  if (library.empty())
    return {};
  const std::string folder = library.substr(0, library.rfind('/'));
  if (holds(folder + kIcdByPath, '"' + library + '"') ||
      holds(folder + kIcdByPath, '"' + forEveryWidth(library, ARBITER_LOADER_LIB) + '"'))
    return folder + kIcdByPath;
  return access((folder + kIcdByName).c_str(), R_OK) == 0 ? folder + kIcdByName : std::string();
}

/// Returns the folder of the defaults that came with this library. It is beside it in the build
/// tree, else in the installation's share/. The path is relative to the library, as an installation
/// may be moved as a whole.
std::string shippedDefaults() {
  const std::string library = ownPath();
  if (library.empty())
    return {};
  const std::string folder = library.substr(0, library.rfind('/'));
  std::string beside = folder + "/arbiter/defaults.d";
  if (access(beside.c_str(), R_OK) == 0)
    return beside;
  const std::string installed = ARBITER_DEFAULTS_FROM_LIBRARY;
  return installed.front() == '/' ? installed : folder + "/" + installed;
}

bool endsWith(const char *text, const char *end) {
  const std::size_t length = std::strlen(text), endLength = std::strlen(end);
  return length >= endLength && std::strcmp(text + length - endLength, end) == 0;
}

void save(const char *variable, const char *value) {
  if (value)
    setenv(variable, value, 1);
  else
    unsetenv(variable);
}

/// Selects the layer as vendor, once: in the constructor, or in a vendor's main that runs before
/// it. libglvnd reads both variables at its first use. If an application's own libraries call GL in
/// constructors, that is before this library's constructor. `arbiter run` sets the variables from
/// outside. libGLX reads its variable already in its constructor; its value was replaced before
/// that (first.cpp).
void selectArbiter() {
  static bool s_done = false;
  if (s_done || !layerAllowed())
    return;
  s_done = true;
  const char *const glx = getenv(kGlxSelection);
  const char *const egl = getenv(kEglSelection);
  const char *const replaced = arbiterReplacedVendor();
  const bool glxOurs = glx && !replaced && std::strcmp(glx, kVendorName) == 0;
  const bool eglOurs = egl && (endsWith(egl, kIcdByPath) || endsWith(egl, kIcdByName));
  g_savedGlx = copy(glxOurs ? getenv(kSavedGlx) : replaced ? replaced : glx);
  g_savedEgl = copy(eglOurs ? getenv(kSavedEgl) : egl);
  // Without preload, another library selected the layer as a vendor. Other threads may be reading
  // the environment by now, so it stays as it is.
  const char *const preload = getenv("LD_PRELOAD");
  if (!preload || !std::strstr(preload, kLibrary))
    return;
  if (!glxOurs) {
    save(kSavedGlx, g_savedGlx);
    setenv(kGlxSelection, kVendorName, 1);
  }
  const std::string icd = eglOurs ? std::string() : ownIcdFile();
  if (!icd.empty()) {
    save(kSavedEgl, g_savedEgl);
    setenv(kEglSelection, icd.c_str(), 1);
  } else if (!eglOurs) {
    logWarn("interposer", "no EGL ICD file lies beside the library (arbiter/10_arbiter.json): "
                          "EGL applications run without the layer");
  }
}

[[gnu::constructor]] void constructed() {
  try {
    prepareUnwinder();
    selectArbiter();
  } catch (const std::exception &) { // out of memory even now: the process runs without the layer
  }
}

} // namespace

bool layerAllowed() { return getauxval(AT_SECURE) == 0; }

const char *savedGlxVendor() {
  selectArbiter();
  return g_savedGlx;
}

const char *savedEglVendors() {
  selectArbiter();
  return g_savedEgl;
}

const defaults::Choice &ownDefaults() {
  const defaults::Choice *const known = defaults::ownChoiceIfRead();
  return known ? *known : defaults::ownChoice(shippedDefaults());
}

void fatal(const char *format, ...) {
  std::fputs("arbiter: ", stderr);
  va_list arguments;
  va_start(arguments, format);
  std::vfprintf(stderr, format, arguments);
  va_end(arguments);
  std::fputc('\n', stderr);
  std::abort();
}

} // namespace arbiter::interposer

namespace arbiter {

// flags.h declares both. The first query reads the files; settings() asks at the first use of GL.

const char *fallbackValue(const char *name) {
  for (const defaults::Setting &setting : interposer::ownDefaults().settings)
    if (std::strcmp(info(setting.key->variable).name, name) == 0)
      return setting.value->text.c_str();
  return nullptr;
}

void reportFallbacks() {
  for (const defaults::File &file : interposer::ownDefaults().files)
    for (const std::string &error : file.errors)
      logWarn("defaults", "%s; the rest holds", error.c_str());
  for (const defaults::Setting &setting : interposer::ownDefaults().settings)
    if (setting.used)
      logInfo("defaults", "%s=%s for %s (%s)", info(setting.key->variable).name,
              setting.value->text.c_str(), setting.entry->title.c_str(), setting.place().c_str());
}

} // namespace arbiter
