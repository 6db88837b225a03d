#include "interposer/host_choice.h"

#include <algorithm>
#include <cstdio>

#include <dirent.h>
#include <dlfcn.h>
#include <unistd.h>

#include "interposer/process.h"
#include "interposer/x_server.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::interposer {

namespace {

constexpr const char *kIcdDirectories = "/etc/glvnd/egl_vendor.d:/usr/share/glvnd/egl_vendor.d";

std::vector<std::string> split(const std::string &text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    if (end > begin)
      parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

/// Returns the library of a vendor. \param vendor a name as libglvnd takes it, or the path of a
/// library
std::string vendorLibrary(const char *interface, const std::string &vendor) {
  if (vendor.find('/') != std::string::npos)
    return vendor;
  return std::string("lib") + interface + "_" + vendor + ".so.0";
}

/// True if NVIDIA's device is there. Without it NVIDIA's vendors load, but then fail for every
/// display.
bool nvidiaPresent() { return access("/dev/nvidiactl", R_OK | W_OK) == 0; }

std::string readFile(const std::string &path) {
  std::string text;
  FILE *const file = std::fopen(path.c_str(), "re");
  if (!file)
    return text;
  char buffer[1024];
  for (std::size_t n; text.size() < 65536 && (n = std::fread(buffer, 1, sizeof buffer, file)) > 0;)
    text.append(buffer, n);
  std::fclose(file);
  return text;
}

void addIcd(std::vector<std::string> &libraries, const std::string &path) {
  const std::string library = icdLibraryPath(readFile(path));
  if (!library.empty())
    libraries.push_back(library);
}

std::vector<std::string> icdFiles(const std::string &directory) {
  std::vector<std::string> files;
  DIR *const handle = opendir(directory.c_str());
  if (!handle)
    return files;
  while (const dirent *item = readdir(handle)) {
    const std::string name = item->d_name;
    if (name.size() > 5 && name.compare(name.size() - 5, 5, ".json") == 0)
      files.emplace_back(directory).append("/").append(name);
  }
  closedir(handle);
  std::sort(files.begin(), files.end());
  return files;
}

} // namespace

std::string icdLibraryPath(const std::string &json) {
  std::size_t at = json.find("\"library_path\"");
  if (at == std::string::npos || (at = json.find(':', at)) == std::string::npos ||
      (at = json.find('"', at)) == std::string::npos)
    return {};
  std::string value;
  for (++at; at < json.size() && json[at] != '"'; ++at) {
    if (json[at] == '\\' && at + 1 < json.size())
      ++at;
    value += json[at];
  }
  return value;
}

void sayNoneLoads(const char *api, const std::vector<std::string> &candidates) {
  std::string tried;
  for (const std::string &library : candidates)
    tried += (tried.empty() ? "" : ", ") + library;
  logError("layer", "%s: no driver loads, so that this program runs without the layer; tried %s",
           api, tried.c_str());
}

std::vector<std::string> glxCandidates() {
  std::vector<std::string> names;
  if (const std::string &chosen = settings().hostVendor; !chosen.empty())
    return {vendorLibrary("GLX", chosen)};
  if (const char *saved = savedGlxVendor())
    names.push_back(saved);
  for (const std::string &name : split(serverVendorNames(), ' '))
    names.push_back(name);
  if (nvidiaPresent())
    names.push_back("nvidia");
  names.push_back("mesa");
  for (std::string &name : names)
    name = vendorLibrary("GLX", name);
  return names;
}

std::vector<std::string> eglCandidates() {
  std::vector<std::string> libraries;
  if (const std::string &chosen = settings().hostVendor; !chosen.empty()) {
    if (chosen.size() > 5 && chosen.compare(chosen.size() - 5, 5, ".json") == 0)
      addIcd(libraries, chosen);
    else
      libraries.push_back(vendorLibrary("EGL", chosen));
    return libraries;
  }
  if (const char *saved = savedEglVendors())
    for (const std::string &file : split(saved, ':'))
      addIcd(libraries, file);
  const std::size_t selected = libraries.size();
  const char *const directories = secure_getenv("__EGL_VENDOR_LIBRARY_DIRS");
  for (const std::string &directory : split(directories ? directories : kIcdDirectories, ':'))
    for (const std::string &file : icdFiles(directory))
      addIcd(libraries, file);
  if (!nvidiaPresent())
    std::stable_partition(
        libraries.begin() + std::ptrdiff_t(selected), libraries.end(),
        [](const std::string &library) { return library.find("nvidia") == std::string::npos; });
  if (nvidiaPresent())
    libraries.push_back(vendorLibrary("EGL", "nvidia"));
  libraries.push_back(vendorLibrary("EGL", "mesa"));
  return libraries;
}

void *openHostLibrary(const std::string &name, const char *entry) {
  void *const handle = dlopen(name.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (!handle) {
    const char *const why = dlerror();
    logDebug("layer", "%s does not load: %s", name.c_str(), why ? why : "");
    return nullptr;
  }
  void *const function = dlsym(handle, entry);
  Dl_info found, own;
  if (!function || !dladdr(function, &found) ||
      !dladdr(reinterpret_cast<void *>(&openHostLibrary), &own) ||
      found.dli_fbase == own.dli_fbase) {
    if (!function)
      (void)dlerror();
    dlclose(handle);
    return nullptr;
  }
  return function;
}

void keepLibraryOf(void *function) {
  Dl_info found;
  if (!dladdr(function, &found) || !found.dli_fname ||
      !dlopen(found.dli_fname, RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE))
    logWarn("layer", "libglvnd cannot be kept: GL works until it is closed");
}

} // namespace arbiter::interposer
