#include "fp_compiler/jit.h"

#include <cstdlib>
#include <dlfcn.h>

#include "fp_compiler/jit_client.h"
#include "fp_compiler/jit_version.h"
#include "util/flags.h"

namespace arbiter::fp::jit {

namespace {
constexpr const char *kLibrary = "libarbiter_jit.so";

/// Returns the folder, with its slash, of the library or program that has this code.
std::string folderOfThis() {
  Dl_info here;
  if (dladdr(reinterpret_cast<const void *>(&folderOfThis), &here) == 0 || !here.dli_fname)
    return {};
  char *const resolved = ::realpath(here.dli_fname, nullptr);
  const std::string path = resolved ? resolved : here.dli_fname;
  std::free(resolved);
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
}

struct Opened {
  const boundary::Interface *library = nullptr;
  std::string reason;
};

Opened openFrom(const std::string &path) {
  // The library's names stay local. LLVM's names come from the copy that Mesa may have mapped
  // already.
  void *const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) {
    const char *const error = dlerror();
    return {nullptr, error ? error : path + " does not load"};
  }
  const auto get = reinterpret_cast<boundary::GetInterface>(dlsym(library, boundary::kSymbol));
  const boundary::Interface *const found = get ? get() : nullptr;
  if (!found)
    return {nullptr, path + " is no library of the layer's"};
  if (found->version != boundary::kVersion)
    return {nullptr, path + " was built with other headers than this"};
  return {found, {}};
}

Opened open(const std::string &asked) {
  if (const std::string &given = settings().jitLibrary; !given.empty())
    return openFrom(given);
  const std::string folder = asked.empty() ? folderOfThis() : asked + "/";
  if (folder.empty())
    return {nullptr, std::string("it is not known where ") + kLibrary + " lies"};
  // An installed library is in the same folder. In the build tree it is in the folder of its
  // sources.
  Opened first;
  for (const char *const sub : {"", "../fp_compiler/back/llvm/"}) {
    Opened opened = openFrom(folder + sub + kLibrary);
    if (opened.library)
      return opened;
    if (first.reason.empty())
      first = std::move(opened);
  }
  return first;
}
} // namespace

std::unique_ptr<Engine> makeEngine(const EngineOptions &options, std::string &reason) {
  // Never closed, because its code may run until the process ends.
  static const Opened *const s_opened = new Opened(open(options.folder));
  if (!s_opened->library) {
    reason = s_opened->reason;
    return nullptr;
  }
  return connect(*s_opened->library, options, reason);
}

} // namespace arbiter::fp::jit
