#pragma once
#include <memory>
#include <string>
#include <vector>

#include "fp_compiler/file_programs.h"
#include "fp_compiler/front/token.h"
#include "fp_compiler/hw/native.h"
#include "fp_compiler/hw/profile.h"
#include "tools/advise/advise.h"
#include "tools/lsp/text_map.h"

namespace arbiter::tools::lsp {

/// All that is known of a program of one version of a text. Views the text.
struct Analysis {
  fp::FileProgram program;
  bool isFirst = true; ///< of the text's programs
  fp::ir::Language language = fp::ir::Language::ArbFragment;
  fp::ir::NvOption nv = fp::ir::NvOption::None; ///< that the text asks for and may have
  /// NVIDIA's own language that the header names, if the profile has it.
  fp::ir::NativeLanguage ownLanguage = fp::ir::NativeLanguage::None;
  fp::Limits limits;
  std::vector<fp::Token> tokens; ///< without EndOfText; there also where the parse failed
  fp::Inspection inspection;
  /// Of a program that loads; empty for ATI's languages, whose programs every card that has them
  /// takes.
  fp::hw::NativeReport native;
};

/// A text that an editor has open.
class Document {
public:
  Document(std::string uri, std::string languageId, std::string text, Encoding encoding);
  Document(const Document &) = delete;
  Document &operator=(const Document &) = delete;

  /// One element of contentChanges: a range and its new text, or the whole text anew.
  /// \returns false if it is neither; the text is then as it was.
  bool change(const Json &change);
  /// The limits or the model of another profile hold.
  void forget() {
    m_analyses.clear();
    m_advice.reset();
  }

  [[nodiscard]] const std::string &uri() const { return m_uri; }
  [[nodiscard]] const std::string &text() const { return m_text; }
  [[nodiscard]] std::string_view text(fp::Span span) const {
    return std::string_view(m_text).substr(span.begin, span.end - span.begin);
  }
  [[nodiscard]] const TextMap &map() const { return m_map; }
  /// Returns the analyses of the text's programs, in their order; at least one. They are made when
  /// they are first asked for after a change or forget(), by the profile of that moment.
  [[nodiscard]] const std::vector<Analysis> &analyses(const fp::hw::Profile &profile);
  /// The program that a byte is in; beside all of them the one before it, or the first.
  [[nodiscard]] const Analysis &analysis(const fp::hw::Profile &profile, std::uint32_t offset = 0);

  /// Likewise; made when it is first asked for, as it costs far more than all the rest.
  [[nodiscard]] const std::vector<advise::Advice> &advice(const fp::hw::Profile &profile);

  std::int64_t version = 0;
  bool changed = true; ///< since its diagnostics were published

private:
  [[nodiscard]] std::vector<fp::FileProgram> programs() const;
  [[nodiscard]] Analysis analysed(const fp::FileProgram &program,
                                  const fp::hw::Profile &profile) const;
  void setText(std::string text);

  std::string m_uri;
  std::string m_languageId;
  Encoding m_encoding;
  std::string m_text;
  TextMap m_map;
  std::vector<Analysis> m_analyses; ///< empty: not made yet
  std::unique_ptr<std::vector<advise::Advice>> m_advice;
};

} // namespace arbiter::tools::lsp
