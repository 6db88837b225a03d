#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// What a program is told by: its file, and under Wine and the like the Windows program that it
/// runs.
namespace arbiter::defaults {

struct Program {
  std::string path; ///< of the file that runs, absolute, without symbolic links; empty: not known
  std::string name; ///< the path's last part
  std::string windows; ///< the .exe's last part; empty: none
  /// The .exe's path in this file system; empty where it is not found.
  std::string windowsPath;

  /// The file that `path` and `xxh128` of an entry mean: the Windows program's, else the program's.
  [[nodiscard]] const std::string &file() const { return windowsPath.empty() ? path : windowsPath; }
};

/// What is told of a process, or of a command before it is one.
struct Facts {
  std::string executable;         ///< its path, absolute, without symbolic links
  std::vector<std::string> words; ///< of its command line, the first too
  /// A variable's value; null: not set.
  std::function<const char *(const char *)> environment;
  std::string mapped; ///< a file like /proc/self/maps, which names what is loaded; empty: none
};

/// The process that this is.
[[nodiscard]] Facts ownFacts();

/// Where the executable is a loader that was given the program's own file (ld-linux, box64), that
/// file is the program. The Windows program is the first word that ends in .exe: of a process's own
/// name, which Wine sets, or behind a loader's or Wine's.
[[nodiscard]] Program programOf(const Facts &facts);

/// Whether an executable's name is Wine's: wine, wine-stable, wine64-preloader. Not winetricks.
[[nodiscard]] bool isWine(std::string_view name);
/// Whether it is Wine's, or one that runs other machines' (box64, qemu-i386), or any
/// (ld-linux-x86-64.so.2).
[[nodiscard]] bool isLoader(std::string_view name);

/// The 128-bit XXH3 of a file as 32 hexadecimal digits; empty if it cannot be read.
[[nodiscard]] std::string hashOfFile(const std::string &path);

/// A pattern's `*` stands for any bytes, `?` for one; all else for itself.
/// \param anyCase ASCII letters are equal in either case, as file names are on Windows
[[nodiscard]] bool matches(std::string_view pattern, std::string_view text, bool anyCase = false);

} // namespace arbiter::defaults
