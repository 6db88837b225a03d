#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tools/doctor/elf_file.h"

/// Where a program's libraries come from, as ld.so looks for them.
namespace arbiter::tools::doctor {

/// By what a library was found.
enum class FoundBy { Nothing, Path, Rpath, Environment, Runpath, System };

struct Library {
  std::string name; ///< as it was asked for
  std::string path; ///< the file; empty: there is none
  FoundBy by = FoundBy::Nothing;
};

class Libraries {
public:
  /// \param root a folder that stands for "/"; empty: this system
  /// \param environment LD_LIBRARY_PATH's value; null: not set. Not read for another system.
  Libraries(std::string root, const std::function<const char *(const char *)> &environment);

  /// What `user` gets where it asks for `name`, for files of its width and machine.
  /// \param origin the folder that $ORIGIN is
  [[nodiscard]] Library find(const std::string &name, const ElfFile &user,
                             const std::string &origin) const;

  /// A library that a program brings with it, in the order of being loaded, each once.
  struct Loaded {
    Library library;
    std::optional<ElfFile> elf; ///< nothing where it was not found
  };
  /// All that come with the program by DT_NEEDED, and what they need.
  [[nodiscard]] std::vector<Loaded> closure(const std::string &program, const ElfFile &elf) const;

private:
  [[nodiscard]] Library search(const std::vector<std::string> &folders, const std::string &name,
                               const ElfFile &user, FoundBy by) const;
  [[nodiscard]] std::vector<std::string> systemFolders(const ElfFile &user) const;

  std::string m_root;
  std::vector<std::string> m_environment;
  std::vector<std::string> m_configured; ///< of ld.so.conf
};

/// It hands calls to a vendor's library, as libglvnd's do: the layer can be that vendor.
[[nodiscard]] bool isGlvnd(const ElfFile &elf);

} // namespace arbiter::tools::doctor
