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

/// What a process puts into the folder of ARBITER_CAPTURE: each program text in a file of its own
/// as it is loaded (HASH.fp, .vp, .atifs) with its GLSL beside it, and one record of how they are
/// used, process-PID-START.json, written anew from time to time. Every file appears whole or not at
/// all, so that a process that is killed loses a second of figures and no text. `arbiter capture`
/// merges the records.
namespace arbiter::state {

/// ARBITER_CAPTURE_SCHEMA of GL/arbiter.h: grows when a member changes its meaning or goes.
inline constexpr int kCaptureSchema = 1;

/// One stretch of draws with a program.
struct ProgramUse {
  Target target = Target::Fragment;
  std::shared_ptr<const CompiledProgram> program;
  std::uint32_t context = 0; ///< serial
  std::uint64_t frame = 0;   ///< of the context
  std::array<DrawsBy, 2> draws;
  const std::vector<Vec4> *values = nullptr; ///< of the program's GLSL uniforms; null: unknown
  const std::vector<TextureUse> *textures = nullptr;
};

/// The record of this process. Any thread may call; each call locks.
class CaptureRecord {
public:
  /// Null unless ARBITER_CAPTURE names a folder. Never destroyed.
  [[nodiscard]] static CaptureRecord *instance();

  void contextMade();
  /// A program string was given to the compiler; `compiled` is null where it was refused. Writes
  /// the text's file.
  /// \param message errors, or warnings of a program that loaded
  void loaded(std::uint32_t context, Target target, std::string_view text,
              const fp::CheckResult &result, const std::string &message,
              const CompiledProgram *compiled);
  void used(const ProgramUse &use);
  /// A frame ended: writes the record if that has not been done for a second.
  void frameEnded();
  /// At exit.
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
  std::uint64_t m_bytes = 0;    ///< of texts written
  bool m_dirty = false;
  bool m_complained = false;
};

} // namespace arbiter::state
