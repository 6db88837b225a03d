#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "fp_compiler/compiler.h"

/// What a capture folder holds: the texts and the records that the layer left there, one record a
/// process, merged into one row a program.
namespace arbiter::tools {

/// The languages of program texts, by the file name's extension.
struct CaptureTarget {
  const char *word;      ///< in records: "fragment"
  const char *extension; ///< of a text's file: ".fp"
  fp::ir::Language language;
};

struct CapturedParameter {
  std::string name; ///< as a program spells it: "program.env[3]", "state.fog.color"
  std::array<double, 4> value{};
};

/// The texture of an image unit that a program samples.
struct CapturedTexture {
  unsigned unit = 0;
  std::string target;                        ///< "2D", as a program spells it
  unsigned name = 0;                         ///< of the texture object; 0: the default one
  unsigned width = 0, height = 0, depth = 0; ///< texels; 0: no image
  std::string format;
  std::vector<std::string> enabled; ///< fixed-function targets enabled on the unit
};

/// One program text, whatever contexts and processes loaded it.
struct CapturedProgram {
  std::string hash;
  const CaptureTarget *target = nullptr;
  std::string text;      ///< as its file is now
  bool edited = false;   ///< the file no longer is what the application loaded
  bool recorded = false; ///< false: no record names it, as its process was killed at once
  bool replaced = false; ///< another text was loaded in its place
  std::uint64_t loads = 0, frames = 0, draws = 0;
  std::set<std::uint64_t> processes;
  std::set<std::string> contexts;               ///< "process.context"
  std::map<std::string, std::uint64_t> drawsBy; ///< draws by path, as in the statistics
  std::vector<std::string> options;
  std::int64_t lastUse = -1; ///< ns since the epoch; of parameters and textures
  std::vector<CapturedParameter> parameters;
  std::vector<CapturedTexture> textures;
  bool counted = false;
  fp::ResourceCounts counts, nativeCounts;
  bool underNativeLimits = false;
  std::int64_t errorPosition = -1;
  std::string error, warning;
  std::string glsl; ///< what the host was given, or would be

  [[nodiscard]] std::string file() const { return hash + target->extension; }
  [[nodiscard]] bool valid() const { return counted; }
  /// The path of its draws; of several each with its number, most draws first: "rasterizer 120,
  /// host-glsl 3".
  [[nodiscard]] std::string path() const;
};

struct CapturedProcess {
  std::uint64_t id = 0;
  std::string command, profile;
  std::uint64_t frames = 0, contexts = 0, notListed = 0;
  bool complete = false; ///< it ended by exit(), so that nothing is missing
};

struct CaptureIndex {
  std::string profile; ///< effective in the last process
  std::vector<CapturedProcess> processes;
  std::vector<CapturedProgram> programs; ///< most draws first
  std::vector<std::string> faults;       ///< files that could not be used, with the reason
};

[[nodiscard]] const CaptureTarget *findCaptureTarget(std::string_view word);
/// The target of a text's file name ("<32 hexadecimal digits>.fp"), or null.
[[nodiscard]] const CaptureTarget *captureTargetOf(const std::string &fileName);

/// The texts of a folder that are no longer what their names say.
[[nodiscard]] std::vector<std::string> editedTexts(const std::string &folder);

/// Reads a folder. A record that is damaged is reported and left out; what it would have said of a
/// program is worked out from the text as far as that is possible.
[[nodiscard]] CaptureIndex readCapture(const std::string &folder);

/// index.json (ARBITER_CAPTURE_SCHEMA).
[[nodiscard]] std::string indexJson(const CaptureIndex &index);

} // namespace arbiter::tools
