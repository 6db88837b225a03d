#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "apps/tools/doctor/elf_file.h"

/// Finds a program's libraries in the order of ld.so.
namespace arbiter::tools::doctor {

/// The rule by which a library was found.
enum class FoundBy { Nothing, Path, Rpath, Environment, Runpath, System };

struct Library {
  std::string name; ///< the requested name
  std::string path; ///< the file; empty: not found
  FoundBy by = FoundBy::Nothing;
};

class Libraries {
public:
  /// \param root a folder that replaces "/"; empty: this system
  /// \param environment returns LD_LIBRARY_PATH's value, or null if it is unset; ignored for
  /// another system
  Libraries(std::string root, const std::function<const char *(const char *)> &environment);

  /// Returns the library that `user` gets for `name`, with the same width and machine.
  /// \param origin the folder that $ORIGIN stands for
  [[nodiscard]] Library find(const std::string &name, const ElfFile &user,
                             const std::string &origin) const;

  /// A library that the loader loads with a program.
  struct Loaded {
    Library library;
    std::optional<ElfFile> elf; ///< nothing if the file was not found
  };
  /// Returns all libraries that the program needs, directly or indirectly by DT_NEEDED. They are in
  /// loading order, each once.
  [[nodiscard]] std::vector<Loaded> closure(const std::string &program, const ElfFile &elf) const;

private:
  [[nodiscard]] Library search(const std::vector<std::string> &folders, const std::string &name,
                               const ElfFile &user, FoundBy by) const;
  [[nodiscard]] std::vector<std::string> systemFolders(const ElfFile &user) const;

  std::string m_root;
  std::vector<std::string> m_environment;
  std::vector<std::string> m_configured; ///< folders of ld.so.conf
};

/// True if the library dispatches calls to a vendor's library, as libglvnd does. The layer can then
/// be the vendor.
[[nodiscard]] bool isGlvnd(const ElfFile &elf);

} // namespace arbiter::tools::doctor
