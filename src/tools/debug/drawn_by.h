#pragma once
#include <string>

namespace arbiter::tools::debug {

/// A file that the layer writes its statistics to, by which one learns who drew: the rasterizer
/// leaves to the host what it has no code for. It is removed with the object.
class DrawnBy {
public:
  DrawnBy();
  DrawnBy(const DrawnBy &) = delete;
  DrawnBy &operator=(const DrawnBy &) = delete;
  ~DrawnBy();

  /// Empty where none could be made.
  [[nodiscard]] const std::string &path() const { return m_path; }
  /// "the rasterizer left 3 of 5 draws to the host: numerics"; empty if it drew all, or nothing was
  /// written. To be called when the process that drew has ended.
  [[nodiscard]] std::string note() const;

private:
  std::string m_path;
};

/// note() of a text of statistics.
[[nodiscard]] std::string drawnByNote(const std::string &statistics);

} // namespace arbiter::tools::debug
