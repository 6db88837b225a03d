#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "fp_compiler/front/nvparse/text.h"
#include "state/objects/target.h"
#include "util/hash.h"

/// Represents register combiners and texture shaders as texts while programs are captured or
/// replaced. A state is written as a text of nvparse, and the text's hash identifies it, as for
/// programs.
namespace arbiter::state {

struct ProgramContext;

/// The text of a state, and its replacement.
struct StateText {
  std::string text;
  Hash128 hash;                              ///< hash of `text`
  std::string replacement;                   ///< empty: there is no replacement
  std::optional<fp::nvparse::Text> replaced; ///< the parsed `replacement`
  /// Generations of the folder and of clients' edits when the replacement was last looked up.
  std::uint64_t folderSeen = 0, editsSeen = 0;

  [[nodiscard]] std::string key() const { return text + '\0' + replacement; }
};

/// A context's texts of states; null if nothing needs them (state_texts.h).
class StateTexts {
public:
  StateTexts() = default;
  StateTexts(const StateTexts &) = delete;
  StateTexts &operator=(const StateTexts &) = delete;
  virtual ~StateTexts() = default;

  /// Returns the text of a state, without its values, which the application may change. Valid until
  /// the next call.
  [[nodiscard]] virtual const StateText &of(const ProgramContext &context, Target target,
                                            const fp::nvparse::Text &state) = 0;
  /// Reports to the capture that a program was made of that text or its replacement.
  virtual void noteProgram(const ProgramContext &context, const StateText &text,
                           const CompiledProgram &compiled) = 0;
  /// True once after each change of a text that may be a replacement.
  [[nodiscard]] virtual bool changed() = 0;
};

} // namespace arbiter::state
