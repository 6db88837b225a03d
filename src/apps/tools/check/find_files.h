#pragma once
#include <span>
#include <string>
#include <vector>

/// Finds the files for `arbiter check` and `arbiter report`.
namespace arbiter::tools {

struct FoundFiles {
  std::vector<std::string> paths;
  /// Faults, each as "path: reason". A folder cannot be listed or contains no program, or a file is
  /// named twice; such a file is in `paths` once.
  std::vector<std::string> faults;
  bool folders = false; ///< true if an operand was a folder
};

/// Returns the operands in order; a folder is replaced by its programs, sorted by the bytes of
/// their paths. Subfolders are searched, without names that begin with a dot and without symbolic
/// links to folders.
/// A file in a folder counts if its text has a program (fp::programsOf()), or if its name is one of
/// assembly alone, such as .arbvp. Names such as .fp are shared with other languages; they count if
/// the text is not in GLSL, Cg or HLSL. Other operands are returned unchanged; "-" is standard
/// input.
[[nodiscard]] FoundFiles findFiles(std::span<const std::string> operands);

} // namespace arbiter::tools
