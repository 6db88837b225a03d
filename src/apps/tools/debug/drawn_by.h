#pragma once
#include <string>

namespace arbiter::tools::debug {

/// Reads from the layer's statistics whether the rasterizer or the host drew. The rasterizer leaves
/// draws to the host if it has no code for them. Owns a temporary file for the statistics.
class DrawnBy {
public:
  DrawnBy();
  DrawnBy(const DrawnBy &) = delete;
  DrawnBy &operator=(const DrawnBy &) = delete;
  ~DrawnBy();

  /// Returns the file's path; empty if no file could be made.
  [[nodiscard]] const std::string &path() const { return m_path; }
  /// Returns "the rasterizer left 3 of 5 draws to the host: numerics". Returns "" if the rasterizer
  /// drew all, or if nothing was written. Requires: the drawing process has ended.
  [[nodiscard]] std::string note() const;

private:
  std::string m_path;
};

/// Returns the note for the text of a statistics file.
[[nodiscard]] std::string drawnByNote(const std::string &statistics);

} // namespace arbiter::tools::debug
