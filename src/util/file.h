#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace arbiter {

/// Selects what openPrivate() does with the file's present content.
enum class OpenMode { Append, Truncate };

/// Opens a regular file for writing in an application's process. It refuses symbolic links
/// (O_NOFOLLOW), pipes and devices. Child processes do not inherit the descriptor (O_CLOEXEC), and
/// only the owner may read a new file (0600).
/// \returns a descriptor, or -1 with errno set.
[[nodiscard]] int openPrivate(const char *path, OpenMode mode) noexcept;

/// Writes all bytes and continues after an interrupted or partial write. It sets errno on failure.
bool writeAll(int descriptor, std::string_view bytes) noexcept;

/// Replaces the content of a file opened by openPrivate().
/// \returns false with errno set if it cannot be written; the file may then be truncated.
bool writePrivateFile(const char *path, std::string_view bytes) noexcept;

/// Replaces the file `path` atomically, with mode 0600. A reader, or the file after a kill, has the
/// old content or the new. It does not replace anything but a regular file.
/// \returns false with errno set.
bool replacePrivateFile(const std::string &path, std::string_view bytes);

/// Creates the file `path` atomically. An existing file stays as it is, which counts as success.
bool createPrivateFile(const std::string &path, std::string_view bytes);

/// The state of a file, which shows a change without reading the file.
struct FileState {
  std::int64_t modified = 0; ///< ns
  std::int64_t changed = 0;  ///< ns
  std::uint64_t size = 0;
  std::uint64_t inode = 0;
  bool exists = false; ///< as a regular file, perhaps through symbolic links
  bool operator==(const FileState &) const = default;
};
[[nodiscard]] FileState stateOf(const char *path) noexcept;

/// Reads a regular file of at most `limit` bytes. It refuses pipes and devices. Child processes do
/// not inherit the descriptor.
/// \returns false with errno set (EFBIG: longer).
bool readFile(const char *path, std::size_t limit, std::string &bytes);

/// Returns the path with each "%p" replaced by the process id, so that child processes with the
/// same setting write different files. "%%" is a percent sign.
[[nodiscard]] std::string expandPid(std::string_view path);

} // namespace arbiter
