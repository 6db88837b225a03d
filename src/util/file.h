#pragma once
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

/// The path with each "%p" replaced by the process id, so that child processes that inherit a
/// setting do not write over each other. "%%" is a percent sign.
[[nodiscard]] std::string expandPid(std::string_view path);

} // namespace arbiter
