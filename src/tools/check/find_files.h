#pragma once
#include <span>
#include <string>
#include <vector>

/// Which files `arbiter check` and `arbiter report` look at.
namespace arbiter::tools {

struct FoundFiles {
  std::vector<std::string> paths;
  /// "path: reason": a folder that cannot be listed, or that has no program in it; a file that is
  /// named twice, which `paths` has once.
  std::vector<std::string> faults;
  bool folders = false; ///< at least one operand was a folder
};

/// The operands in their order, each folder as the programs in it, in the order of their bytes.
/// Folders are searched with their subfolders; names that begin with a full stop are left out, and
/// symbolic links to folders are not followed. A file there is looked at if its text has a program
/// (fp::programsOf()), or if its name is one of assembly, as .fp, .vfp or .arbvp, and its text is
/// not one of another language, as GLSL and Cg. An operand that is no folder is taken as it is; "-"
/// is standard input.
[[nodiscard]] FoundFiles findFiles(std::span<const std::string> operands);

} // namespace arbiter::tools
