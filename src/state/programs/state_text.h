#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "fp_compiler/front/nvparse/text.h"
#include "state/objects/target.h"
#include "util/hash.h"

/// Register combiners and texture shaders as texts, where programs are captured or replaced: a
/// state is written as a text of nvparse's, whose hash is its name as a program's text's is.
namespace arbiter::state {

class Context;

/// The text of a state, and what stands in for it.
struct StateText {
  std::string text;
  Hash128 hash;                              ///< of `text`
  std::string replacement;                   ///< empty: nothing stands in
  std::optional<fp::nvparse::Text> replaced; ///< what `replacement` says
  /// Of the folder and of clients' edits, when it was last looked for.
  std::uint64_t folderSeen = 0, editsSeen = 0;

  [[nodiscard]] std::string key() const { return text + '\0' + replacement; }
};

/// A context's; there is none where none is asked for (state_texts.h).
class StateTexts {
public:
  StateTexts() = default;
  StateTexts(const StateTexts &) = delete;
  StateTexts &operator=(const StateTexts &) = delete;
  virtual ~StateTexts() = default;

  /// The text of a state without values, which are the application's to change. Valid until the
  /// next call.
  [[nodiscard]] virtual const StateText &of(const Context &context, Target target,
                                            const fp::nvparse::Text &state) = 0;
  /// A program was made of that text, or of what stands in for it: the capture's record gets it.
  virtual void noteProgram(const Context &context, const StateText &text,
                           const CompiledProgram &compiled) = 0;
  /// True once after each change of a text that may stand in.
  [[nodiscard]] virtual bool changed() = 0;
};

} // namespace arbiter::state
