#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// Identifies a program by its file, and under Wine and similar loaders by the Windows program that
/// it runs.
namespace arbiter::defaults {

struct Program {
  std::string path;    ///< of the running file, absolute, without symbolic links; empty: unknown
  std::string name;    ///< the path's last part
  std::string windows; ///< the .exe's last part; empty: none
  /// The .exe's path in this file system; empty if it was not found.
  std::string windowsPath;

  /// Returns the file that an entry's `path` and `xxh128` refer to: the Windows program's if there
  /// is one, else the program's.
  [[nodiscard]] const std::string &file() const { return windowsPath.empty() ? path : windowsPath; }
};

/// The facts that identify a process, or a command that will become one.
struct Facts {
  std::string executable;         ///< its path, absolute, without symbolic links
  std::vector<std::string> words; ///< of its command line, including the first
  /// Returns a variable's value; null: not set.
  std::function<const char *(const char *)> environment;
  std::string mapped; ///< a file like /proc/self/maps, which lists loaded files; empty: none
};

/// Returns the facts of this process.
[[nodiscard]] Facts ownFacts();

/// Identifies the program. If the executable is a loader that was given the program's own file
/// (ld-linux, box64), that file is the program. The Windows program is the first word that ends in
/// .exe, either the process's own name, which Wine sets, or a word behind a loader's or Wine's.
[[nodiscard]] Program programOf(const Facts &facts);

/// True if an executable's name is Wine's (wine, wine-stable, wine64-preloader), but not
/// winetricks.
[[nodiscard]] bool isWine(std::string_view name);
/// True if it is Wine's, or a loader's for other machines (box64, qemu-i386) or for any program
/// (ld-linux-x86-64.so.2).
[[nodiscard]] bool isLoader(std::string_view name);
/// True if it is the C library's loader (ld-linux-x86-64.so.2), by which a program runs as by the
/// kernel.
[[nodiscard]] bool isSystemLoader(std::string_view name);

/// Returns the 128-bit XXH3 of a file as 32 hexadecimal digits, or "" if it cannot be read.
[[nodiscard]] std::string hashOfFile(const std::string &path);

/// Matches a pattern in which `*` stands for any bytes and `?` for one.
/// \param anyCase compares ASCII letters without case, as Windows does for file names
[[nodiscard]] bool matches(std::string_view pattern, std::string_view text, bool anyCase = false);

} // namespace arbiter::defaults
