#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "state/objects/program_object.h"

namespace arbiter::state {

/// The register combiners and texture shaders that the process has drawn with, as texts for control
/// clients. No GL object holds such a state. Any thread may call it; never freed.
class DrawnStates {
public:
  [[nodiscard]] static DrawnStates &instance();

  /// Adds a state.
  /// \param state its target, text, hash, counts and replacement; it has no code
  /// \returns true if it was not known
  bool note(std::shared_ptr<const CompiledProgram> state);
  /// Returns all states, by the names of their text files.
  [[nodiscard]] std::map<std::string, std::shared_ptr<const CompiledProgram>> all();

private:
  /// An application that keeps on making new states makes the list start again here.
  static constexpr std::size_t kMax = 4096;
  std::mutex m_mutex;
  std::map<std::string, std::shared_ptr<const CompiledProgram>> m_states;
};

} // namespace arbiter::state
