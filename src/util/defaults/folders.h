#pragma once
#include <functional>
#include <string>
#include <vector>

#include "util/defaults/entry.h"

/// The folders that hold files of defaults. Entries of a later folder win.
namespace arbiter::defaults {

struct Folder {
  std::string path;
  /// True for the user's own folder: a file there that belongs to neither the user nor root is
  /// ignored.
  bool users = false;
};

/// Returns the folder installed with the layer, /etc/arbiter/defaults.d, and the user's
/// ($XDG_CONFIG_HOME or ~/.config)/arbiter/defaults.d. ARBITER_DEFAULTS replaces them with its own
/// folders, or with none if it is 0. Folders that do not exist are listed too.
/// \param shipped the folder that was installed with the layer; empty: none
/// \param environment returns a variable's value; null: not set
[[nodiscard]] std::vector<Folder>
folders(const std::string &shipped, const std::function<const char *(const char *)> &environment);

/// Reads the files of the folders, in their order. Within a folder it reads the files named *.toml
/// in byte order of their names, except hidden ones. A folder that does not exist has no files. One
/// that cannot be read yields an error without entries.
[[nodiscard]] std::vector<File> readFolders(const std::vector<Folder> &folders);

} // namespace arbiter::defaults
