#pragma once
#include <cstdint>
#include <map>
#include <string>

#include "util/json.h"
#include "util/result.h"

/// Reads files of statistics (docs/reference/statistics.md) and adds their figures.
namespace arbiter::tools::stats {

struct Figures {
  std::uint64_t files = 0, contexts = 0, frames = 0;
  std::uint64_t programs = 0;                 ///< texts that were loaded, refused ones too
  std::uint64_t overNative = 0;               ///< of those that loaded, over the native limits
  std::uint64_t refused = 0;                  ///< of those, refused by the profile alone
  std::map<std::string, std::uint64_t> draws; ///< by path: "host_glsl"
  std::map<std::string, std::uint64_t> givenToHost; ///< by reason: "not_compiled"

  void add(const Figures &others);
  /// Returns "frames 3  programs 2  rasterizer 120  host_glsl 3", with the words of the figures in
  /// the frame.
  [[nodiscard]] std::string line() const;
  /// Returns "compiling 3  look 1", most first; empty: the rasterizer gave nothing to the host.
  [[nodiscard]] std::string reasonsLine() const;
  /// Writes the members of an object.
  void write(JsonWriter &json) const;
};

struct Report {
  std::string program; ///< the executable's name, or the Windows program's; empty: unknown
  Figures figures;
};

/// Reads a file. It accepts earlier schemas, in which paths had other words.
/// \returns the error as a text: "s.json: is no file of statistics"
[[nodiscard]] Result<Report, std::string> readReport(const std::string &path);

} // namespace arbiter::tools::stats
