#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What the loader of programs would make of a file.
namespace arbiter::tools::doctor {

struct ElfFile {
  int bits = 0;              ///< 32 or 64
  std::uint16_t machine = 0; ///< EM_X86_64, ...
  bool executable = false;   ///< a program (ET_EXEC, ET_DYN)
  std::string interpreter;   ///< the loader; empty: statically linked, or a library
  std::string soname;
  std::vector<std::string> needed;
  std::vector<std::string> rpath;   ///< folders, as they stand in the file
  std::vector<std::string> runpath; ///< likewise
  std::vector<std::string> imports; ///< names that it wants from others
  std::vector<std::string> exports; ///< functions that others may call

  [[nodiscard]] bool needs(std::string_view library) const;
};

/// Nothing if it is no ELF file, or a broken one.
[[nodiscard]] std::optional<ElfFile> readElf(const std::string &path);

/// "x86-64", "i386", "AArch64"; a number for others.
[[nodiscard]] std::string machineName(std::uint16_t machine);

/// Texts in a file that may name a library: printable, ended by a NUL, with ".so" in them, and one
/// of the words in their last part.
[[nodiscard]] std::vector<std::string> libraryNames(const std::string &path,
                                                    const std::vector<std::string_view> &words);

} // namespace arbiter::tools::doctor
