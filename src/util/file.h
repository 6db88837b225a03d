#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace arbiter {

/// How openPrivate() treats what the file already holds.
enum class OpenMode { Append, Truncate };

/// Opens a regular file for writing on behalf of whatever process we live in: a symbolic link is
/// refused (O_NOFOLLOW), a pipe or device is refused, the descriptor does not leak into child
/// processes (O_CLOEXEC), and a new file is readable by its owner only (0600).
/// \returns a descriptor, or -1 with errno set.
[[nodiscard]] int openPrivate(const char *path, OpenMode mode) noexcept;

/// Writes all bytes, going on after an interrupted or partial write. errno is set on failure.
bool writeAll(int descriptor, std::string_view bytes) noexcept;

/// Replaces the content of a file opened by openPrivate().
/// \returns false with errno set, and the file perhaps short, if it cannot be written.
bool writePrivateFile(const char *path, std::string_view bytes) noexcept;

/// Gives the file `path` new content in one step, mode 0600: a reader, or a process that is killed
/// meanwhile, leaves the old content or the new. What is there and is no regular file stays.
/// \returns false with errno set.
bool replacePrivateFile(const std::string &path, std::string_view bytes);

/// The same where `path` does not exist; a file that is there stays as it is, which is a success.
bool createPrivateFile(const std::string &path, std::string_view bytes);

/// What a file is, so that a change of it shows without reading it.
struct FileState {
  std::int64_t modified = 0; ///< ns
  std::int64_t changed = 0;  ///< ns
  std::uint64_t size = 0;
  std::uint64_t inode = 0;
  bool exists = false; ///< as a regular file, perhaps through symbolic links
  bool operator==(const FileState &) const = default;
};
[[nodiscard]] FileState stateOf(const char *path) noexcept;

/// The bytes of a regular file of at most `limit` bytes. A pipe or device is refused, the
/// descriptor does not leak into child processes.
/// \returns false with errno set (EFBIG: longer).
bool readFile(const char *path, std::size_t limit, std::string &bytes);

/// The path with each "%p" replaced by the process id, so that child processes that inherit a
/// setting do not write over each other. "%%" is a percent sign.
[[nodiscard]] std::string expandPid(std::string_view path);

} // namespace arbiter
