#include "apps/tools/doctor/libraries.h"

#include <algorithm>
#include <elf.h>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <utility>

namespace arbiter::tools::doctor {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> split(const std::string &list, char between) {
  std::vector<std::string> parts;
  std::stringstream stream(list);
  for (std::string part; std::getline(stream, part, between);)
    if (!part.empty())
      parts.push_back(part);
  return parts;
}

void readConfiguration(const std::string &root, const fs::path &file,
                       std::vector<std::string> &folders, int depth) {
  std::ifstream stream(root + file.string());
  for (std::string line; std::getline(stream, line);) {
    line.resize(std::min(line.find('#'), line.size()));
    std::stringstream words(line);
    std::string word, pattern;
    if (!(words >> word))
      continue;
    if (word != "include") {
      folders.push_back(word);
      continue;
    }
    std::error_code error;
    if (!(words >> pattern) || depth > 3)
      continue;
    // The only pattern that distributions use is FOLDER/*.conf.
    std::set<std::string> names;
    for (const auto &each :
         fs::directory_iterator(root + fs::path(pattern).parent_path().string(), error))
      if (each.path().extension() == ".conf")
        names.insert(each.path().filename());
    for (const std::string &name : names)
      readConfiguration(root, fs::path(pattern).parent_path() / name, folders, depth + 1);
  }
}

/// Returns the name of Debian's library folder for the file's machine.
std::string tripletOf(const ElfFile &user) {
  switch (user.machine) {
  case EM_X86_64:
    return "x86_64-linux-gnu";
  case EM_386:
    return "i386-linux-gnu";
  case EM_AARCH64:
    return "aarch64-linux-gnu";
  default:
    return "arm-linux-gnueabihf";
  }
}

std::string replaced(std::string text, const std::string &what, const std::string &by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

/// Returns a folder with $ORIGIN, $LIB and $PLATFORM replaced.
std::string expanded(std::string folder, const ElfFile &user, const std::string &origin) {
  for (const auto &[what, by] :
       {std::pair<std::string, std::string>{"ORIGIN", origin},
        {"LIB", "lib/" + tripletOf(user)},
        {"PLATFORM", machineName(user.machine) == "i386" ? "i686" : "x86_64"}}) {
    folder = replaced(folder, "${" + what + "}", by);
    folder = replaced(folder, "$" + what, by);
  }
  return folder;
}

} // namespace

Libraries::Libraries(std::string root, const std::function<const char *(const char *)> &environment)
    : m_root(std::move(root)) {
  const char *const path = m_root.empty() ? environment("LD_LIBRARY_PATH") : nullptr;
  if (path != nullptr)
    m_environment = split(replaced(path, ";", ":"), ':');
  readConfiguration(m_root, "/etc/ld.so.conf", m_configured, 0);
}

std::vector<std::string> Libraries::systemFolders(const ElfFile &user) const {
  std::vector<std::string> folders = m_configured;
  const std::string triplet = tripletOf(user);
  for (const char *const base : {"/lib/", "/usr/lib/"})
    folders.push_back(base + triplet);
  for (const char *const each : {user.bits == 32 ? "/lib32" : "/lib64",
                                 user.bits == 32 ? "/usr/lib32" : "/usr/lib64", "/lib", "/usr/lib"})
    folders.emplace_back(each);
  for (std::string &each : folders)
    each.insert(0, m_root);
  return folders;
}

Library Libraries::search(const std::vector<std::string> &folders, const std::string &name,
                          const ElfFile &user, FoundBy by) const {
  for (const std::string &folder : folders) {
    const std::string path = (fs::path(folder) / name).string();
    std::error_code error;
    if (!fs::is_regular_file(path, error))
      continue;
    const std::optional<ElfFile> elf = readElf(path);
    if (elf && elf->bits == user.bits && elf->machine == user.machine)
      return {name, path, by};
  }
  return {name, {}, FoundBy::Nothing};
}

Library Libraries::find(const std::string &name, const ElfFile &user,
                        const std::string &origin) const {
  if (name.find('/') != std::string::npos) {
    std::error_code error;
    const std::string path = expanded(name, user, origin);
    return fs::is_regular_file(path, error) ? Library{name, path, FoundBy::Path}
                                            : Library{name, {}, FoundBy::Nothing};
  }
  const auto folders = [&](std::vector<std::string> each) {
    for (std::string &folder : each)
      folder = expanded(folder, user, origin);
    return each;
  };
  // The older DT_RPATH is searched before the environment, and is ignored if DT_RUNPATH exists.
  Library found{name, {}, FoundBy::Nothing};
  if (user.runpath.empty())
    found = search(folders(user.rpath), name, user, FoundBy::Rpath);
  if (found.path.empty())
    found = search(m_environment, name, user, FoundBy::Environment);
  if (found.path.empty())
    found = search(folders(user.runpath), name, user, FoundBy::Runpath);
  if (found.path.empty())
    found = search(systemFolders(user), name, user, FoundBy::System);
  return found;
}

std::vector<Libraries::Loaded> Libraries::closure(const std::string &program,
                                                  const ElfFile &elf) const {
  std::vector<Loaded> loaded;
  std::set<std::string> seen;
  const auto load = [&](const ElfFile &user, const std::string &origin) {
    for (const std::string &name : user.needed) {
      if (!seen.insert(name).second)
        continue;
      // A program's DT_RPATH also applies to its libraries.
      ElfFile by = user;
      by.rpath.insert(by.rpath.end(), elf.rpath.begin(), elf.rpath.end());
      Library library = find(name, by, origin);
      std::optional<ElfFile> file;
      if (!library.path.empty())
        file = readElf(library.path);
      loaded.push_back({std::move(library), std::move(file)});
    }
  };
  const auto folderOf = [](const std::string &path) {
    return fs::path(path).parent_path().string();
  };
  load(elf, folderOf(program));
  for (std::size_t i = 0; i < loaded.size(); ++i)
    if (loaded[i].elf) {
      const ElfFile user = *loaded[i].elf; // a copy: load() makes `loaded` grow
      load(user, folderOf(loaded[i].library.path));
    }
  return loaded;
}

bool isGlvnd(const ElfFile &elf) {
  return elf.needs("libGLdispatch.so.0") || elf.needs("libGLX.so.0") ||
         elf.soname == "libGLdispatch.so.0";
}

} // namespace arbiter::tools::doctor
