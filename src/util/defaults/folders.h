#pragma once
#include <functional>
#include <string>
#include <vector>

#include "util/defaults/entry.h"

/// Where files of defaults lie. The later a folder, the later its entries: they win.
namespace arbiter::defaults {

struct Folder {
  std::string path;
  /// The user's own: a file there that is neither the user's nor root's is not followed.
  bool users = false;
};

/// What is installed with the layer, /etc/arbiter/defaults.d, and the user's
/// ($XDG_CONFIG_HOME or ~/.config)/arbiter/defaults.d; in their place the folders of
/// ARBITER_DEFAULTS, or none where that is 0. Folders that do not exist are listed too.
/// \param shipped the folder that was installed with the layer; empty: none
/// \param environment a variable's value; null: not set
[[nodiscard]] std::vector<Folder>
folders(const std::string &shipped, const std::function<const char *(const char *)> &environment);

/// The files of the folders, in their order; within a folder those named *.toml in the order of the
/// bytes of their names, hidden ones left out. A folder that is not there has none; one that cannot
/// be read is an error of a file without entries.
[[nodiscard]] std::vector<File> readFolders(const std::vector<Folder> &folders);

} // namespace arbiter::defaults
