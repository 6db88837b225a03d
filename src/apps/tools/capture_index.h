#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "fp_compiler/compiler.h"

/// Reads a capture folder. The layer writes program texts there, and one record for each process.
/// The records are merged into one row for each program.
namespace arbiter::tools {

/// Maps a target's word in records to its file name extension and language.
struct CaptureTarget {
  const char *word;      ///< as records spell it: "fragment"
  const char *extension; ///< of a text's file: ".fp"
  fp::ir::Language language;
};

struct CapturedParameter {
  std::string name; ///< as a program spells it: "program.env[3]", "state.fog.color"
  std::array<double, 4> value{};
};

/// The texture that is bound to an image unit from which a program samples.
struct CapturedTexture {
  unsigned unit = 0;
  std::string target;                        ///< as a program spells it: "2D"
  unsigned name = 0;                         ///< of the texture object; 0: the default one
  unsigned width = 0, height = 0, depth = 0; ///< texels; 0: no image
  std::string format;
  std::vector<std::string> enabled; ///< fixed-function targets enabled on the unit
};

/// One program text, merged over all contexts and processes that loaded it.
struct CapturedProgram {
  std::string hash;
  const CaptureTarget *target = nullptr;
  std::string text;      ///< the current content of its file
  bool edited = false;   ///< true if the file is no longer what the application loaded
  bool recorded = false; ///< false if no record names it: its process was killed
  bool replaced = false; ///< true if another text was loaded in its place
  std::uint64_t loads = 0, frames = 0, draws = 0;
  std::map<std::uint64_t, std::set<std::uint32_t>> processes; ///< contexts that loaded it, by pid
  std::map<std::string, std::uint64_t> drawsBy; ///< draws by path (the names of the statistics)
  std::vector<std::string> options;
  std::int64_t lastUse = -1; ///< ns since the epoch; parameters and textures date from then
  std::vector<CapturedParameter> parameters;
  std::vector<CapturedTexture> textures;
  bool counted = false;
  fp::ResourceCounts counts, nativeCounts;
  bool underNativeLimits = false;
  std::int64_t errorPosition = -1;
  std::string error, warning;
  std::string glsl; ///< given to the host, or compiled here

  [[nodiscard]] std::size_t contextCount() const;
  [[nodiscard]] std::string file() const { return hash + target->extension; }
  [[nodiscard]] bool valid() const { return counted; }
  /// Returns the path of its draws. Several paths come with their numbers, most draws first:
  /// "rasterizer 120, host_glsl 3".
  [[nodiscard]] std::string path() const;
};

struct CapturedProcess {
  std::uint64_t pid = 0;
  std::string command, profile;
  std::uint64_t frames = 0, contexts = 0;
  std::uint64_t programs = 0;   ///< texts in its record
  std::uint64_t notListed = 0;  ///< loads of texts beyond the limit of the record
  std::uint64_t notWritten = 0; ///< files of texts and GLSL
  std::string whyNotWritten;    ///< of the first: "No space left on device"
  bool complete = false;        ///< true if it ended by exit(), so that nothing is missing
};

struct CaptureIndex {
  std::string profile; ///< the effective profile of the last process
  std::vector<CapturedProcess> processes;
  std::vector<CapturedProgram> programs; ///< most draws first
  std::vector<std::string> faults;       ///< unusable files, with the reason
};

[[nodiscard]] const CaptureTarget *findCaptureTarget(std::string_view word);
/// Returns the target that a text's file name ("<32 hexadecimal digits>.fp") implies, or null.
[[nodiscard]] const CaptureTarget *captureTargetOf(const std::string &fileName);

/// Returns the names of texts whose content no longer matches the hash in their file name.
[[nodiscard]] std::vector<std::string> editedTexts(const std::string &folder);

/// Reads a folder. A damaged record is reported and skipped. Its data about a program is then
/// compiled from the text as far as possible.
[[nodiscard]] CaptureIndex readCapture(const std::string &folder);

/// Returns sentences about what the capture lacks, and how much it holds; none: nothing is known to
/// be missing.
[[nodiscard]] std::vector<std::string> whatIsMissing(const CaptureIndex &index);

/// Returns the content of index.json (ARBITER_CAPTURE_SCHEMA).
[[nodiscard]] std::string indexJson(const CaptureIndex &index);

} // namespace arbiter::tools
