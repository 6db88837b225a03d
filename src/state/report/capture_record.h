#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "state/objects/program_object.h"
#include "state/objects/target.h"
#include "state/report/capture_row.h"

namespace arbiter::fp {
struct CheckResult;
}

/// The capture of a process in the folder of ARBITER_CAPTURE. Each loaded program text has its own
/// file (HASH.fp, .vp, .atifs), with its GLSL beside it. A record of their use,
/// process-PID-START.json, is rewritten from time to time. Files are replaced as a whole, so a
/// killed process loses one second of figures and no text. `arbiter capture` merges the records.
namespace arbiter::state {

/// A run of draws with one program.
struct ProgramUse {
  Target target = Target::Fragment;
  std::shared_ptr<const CompiledProgram> program;
  std::uint32_t context = 0; ///< its serial number
  std::uint64_t frame = 0;   ///< of the context
  std::array<DrawsBy, 2> draws;
  const std::vector<Vec4> *values = nullptr; ///< values of the program's GLSL uniforms; null:
                                             ///< unknown
  const std::vector<TextureUse> *textures = nullptr;
};

/// The record of this process. Any thread may call it; each call takes the lock.
class CaptureRecord {
public:
  /// Returns the record; null unless ARBITER_CAPTURE names a folder. Never freed.
  [[nodiscard]] static CaptureRecord *instance();

  void contextMade();
  /// Records a program string and writes its file; `compiled` is null if it was refused.
  /// \param message errors, or warnings of a program that loaded
  void loaded(std::uint32_t context, Target target, std::string_view text,
              const fp::CheckResult &result, const std::string &message,
              const CompiledProgram *compiled);
  void used(const ProgramUse &use);
  /// Counts a frame, and writes the record if the last write is a second ago.
  void frameEnded();
  /// Writes the final record at exit.
  void finish();

private:
  explicit CaptureRecord(std::string folder);
  void afterFork();
  CaptureRow *rowOf(Target target, const Hash128 &hash);
  void writeFile(const std::string &name, std::string_view text, bool keep);
  void writeGlsl(CaptureRow &row, const CompiledProgram &program);
  void write(bool complete);
  void writeNowAndThen();
  [[nodiscard]] std::string json(bool complete) const;

  std::mutex m_mutex;
  const std::string m_folder;
  pid_t m_process = 0;
  std::string m_path;
  std::unordered_map<std::string, std::unique_ptr<CaptureRow>> m_rows; ///< by file name
  std::vector<const CaptureRow *> m_order;
  std::uint64_t m_notListed = 0;
  std::uint64_t m_contexts = 0;
  std::uint64_t m_frames = 0;
  std::int64_t m_nextWrite = 0; ///< monotonic ns
  std::uint64_t m_bytes = 0;    ///< bytes of texts written
  std::uint64_t m_notWritten = 0;
  std::string m_whyNotWritten; ///< of the first file that was not written
  bool m_dirty = false;
  bool m_complained = false;
};

} // namespace arbiter::state
