#pragma once
#include <cstdlib>
#include <filesystem>
#include <string>

namespace arbiter::tools {

/// A folder for temporary files. The destructor removes it with all that it has.
class TemporaryFolder {
public:
  explicit TemporaryFolder(const std::string &name) {
    std::error_code error;
    std::string path = (std::filesystem::temp_directory_path(error) / (name + "-XXXXXX")).string();
    if (!error && ::mkdtemp(path.data()) != nullptr)
      m_path = path;
  }
  ~TemporaryFolder() {
    std::error_code error;
    if (!m_path.empty())
      std::filesystem::remove_all(m_path, error);
  }
  TemporaryFolder(const TemporaryFolder &) = delete;
  TemporaryFolder &operator=(const TemporaryFolder &) = delete;

  /// Returns the path; empty, with errno set, if no folder could be made.
  [[nodiscard]] const std::string &path() const { return m_path; }

private:
  std::string m_path;
};

} // namespace arbiter::tools
