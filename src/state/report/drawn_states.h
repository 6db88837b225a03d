#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "state/objects/program_object.h"

namespace arbiter::state {

/// The register combiners and texture shaders that the process has drawn with, as texts, for
/// clients of control: a state has no object that holds one. Any thread may call; never destroyed.
class DrawnStates {
public:
  [[nodiscard]] static DrawnStates &instance();

  /// \param state its target, text, hash, counts, and what stands in for it; there is no code
  /// \returns true for one that was not known
  bool note(std::shared_ptr<const CompiledProgram> state);
  /// By the names of their texts' files.
  [[nodiscard]] std::map<std::string, std::shared_ptr<const CompiledProgram>> all();

private:
  /// An application that makes others for ever begins again here.
  static constexpr std::size_t kMost = 4096;
  std::mutex m_mutex;
  std::map<std::string, std::shared_ptr<const CompiledProgram>> m_states;
};

} // namespace arbiter::state
