#include "util/defaults/folders.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <dirent.h>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>

namespace arbiter::defaults {

namespace {

constexpr const char *kSystem = "/etc/arbiter/defaults.d";
constexpr const char *kInConfiguration = "/arbiter/defaults.d";

std::vector<Folder> named(std::string_view list) {
  std::vector<Folder> folders;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(':'), list.size());
    if (end != 0)
      folders.push_back({std::string(list.substr(0, end))});
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return folders;
}

bool isFile(std::string_view name) { return !name.starts_with(".") && name.ends_with(".toml"); }

/// True if a file belongs to neither root nor the user. Such a file is ignored, as its text would
/// affect every program of the user.
bool isForeign(const std::string &path) {
  struct stat status = {};
  return ::stat(path.c_str(), &status) == 0 && status.st_uid != 0 && status.st_uid != ::geteuid();
}

void readFolder(const Folder &folder, std::vector<File> &files) {
  DIR *const stream = ::opendir(folder.path.c_str());
  if (stream == nullptr) {
    // HOME may belong to another user whose folders are closed, as in a program started by `su`.
    if (errno != ENOENT && errno != ENOTDIR && !(folder.users && errno == EACCES))
      files.push_back({{}, {folder.path + ": " + std::strerror(errno)}});
    return;
  }
  std::vector<std::string> names;
  while (const dirent *const each = ::readdir(stream))
    if (isFile(each->d_name))
      names.emplace_back(each->d_name);
  ::closedir(stream);
  std::sort(names.begin(), names.end());
  for (const std::string &name : names) {
    const std::string path = folder.path + "/" + name;
    if (folder.users && isForeign(path))
      files.push_back({{}, {path + ": belongs to another user; left out"}});
    else
      files.push_back(readFile(path));
  }
}

} // namespace

std::vector<Folder> folders(const std::string &shipped,
                            const std::function<const char *(const char *)> &environment) {
  const char *const set = environment(info(Env::Defaults).name);
  const std::string_view choice = set == nullptr || !isUsable(set) ? "" : set;
  if (choice == "0")
    return {};
  if (!choice.empty() && choice != "1")
    return named(choice);
  std::vector<Folder> folders;
  if (!shipped.empty())
    folders.push_back({shipped});
  folders.push_back({kSystem});
  const char *const configuration = environment("XDG_CONFIG_HOME");
  const char *const home = environment("HOME");
  if (configuration != nullptr && *configuration == '/')
    folders.push_back({std::string(configuration) + kInConfiguration, true});
  else if (home != nullptr && *home == '/')
    folders.push_back({std::string(home) + "/.config" + kInConfiguration, true});
  return folders;
}

std::vector<File> readFolders(const std::vector<Folder> &folders) {
  std::vector<File> files;
  for (const Folder &folder : folders)
    readFolder(folder, files);
  return files;
}

} // namespace arbiter::defaults
