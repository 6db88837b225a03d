#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Reads the parts of an ELF file that the dynamic loader uses.
namespace arbiter::tools::doctor {

struct ElfFile {
  int bits = 0;              ///< 32 or 64
  std::uint16_t machine = 0; ///< EM_X86_64, ...
  bool executable = false;   ///< true for a program (ET_EXEC, ET_DYN)
  std::string interpreter;   ///< the loader; empty: statically linked, or a library
  std::string soname;
  std::vector<std::string> needed;
  std::vector<std::string> rpath;   ///< folders, as written in the file
  std::vector<std::string> runpath; ///< folders, as written in the file
  std::vector<std::string> imports; ///< names of undefined symbols
  std::vector<std::string> exports; ///< names of functions that others may call

  [[nodiscard]] bool needs(std::string_view library) const;
};

/// Reads an ELF file. Returns nothing if the file is another one or damaged.
[[nodiscard]] std::optional<ElfFile> readElf(const std::string &path);

/// Returns a machine's name, such as "x86-64", "i386" or "AArch64", or its number.
[[nodiscard]] std::string machineName(std::uint16_t machine);

/// Returns the strings in a file that may name a library. Such a string is printable, ends with
/// NUL, contains ".so", and has one of the words in its last path component.
[[nodiscard]] std::vector<std::string> libraryNames(const std::string &path,
                                                    const std::vector<std::string_view> &words);

} // namespace arbiter::tools::doctor
