#pragma once
#include <memory>
#include <string>
#include <vector>

#include "apps/tools/advise/advise.h"
#include "apps/tools/lsp/text_map.h"
#include "fp_compiler/file_programs.h"
#include "fp_compiler/front/token.h"
#include "fp_compiler/hw/native.h"
#include "fp_compiler/hw/profile.h"

namespace arbiter::tools::lsp {

/// The analysis of one program in one version of a text. It refers to the text.
struct Analysis {
  fp::FileProgram program;
  bool isFirst = true; ///< true for the first program of the text
  fp::ir::Language language = fp::ir::Language::ArbFragment;
  fp::ir::NvOption nv = fp::ir::NvOption::None; ///< the option that the text names and the profile
                                                ///< has
  /// The NVIDIA language that the header names, if the profile has it.
  fp::ir::NativeLanguage ownLanguage = fp::ir::NativeLanguage::None;
  fp::Limits limits;
  std::vector<fp::Token> tokens; ///< without EndOfText; also set if parsing failed
  fp::Inspection inspection;
  /// The native counts of a valid program. Empty for ATI's and nvparse's languages, which have no
  /// model.
  fp::hw::NativeReport native;
};

/// A text that is open in an editor.
class Document {
public:
  Document(std::string uri, std::string languageId, std::string text, Encoding encoding);
  Document(const Document &) = delete;
  Document &operator=(const Document &) = delete;

  /// Applies one element of contentChanges: a range and its new text, or a whole text.
  /// \returns false if it is neither; the text is then unchanged
  bool change(const Json &change);
  /// Discards the analyses because the profile has changed.
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
  /// Returns the analyses of the text's programs in their order; at least one. They are computed at
  /// the first call after a change or forget(), with the given profile.
  [[nodiscard]] const std::vector<Analysis> &analyses(const fp::hw::Profile &profile);
  /// Returns the analysis of the program that contains a byte. Between programs it is the previous
  /// one, before all of them the first.
  [[nodiscard]] const Analysis &analysis(const fp::hw::Profile &profile, std::uint32_t offset = 0);

  /// Returns the adviser's results, computed at the first call because they cost far more than the
  /// analyses.
  [[nodiscard]] const std::vector<advise::Advice> &advice(const fp::hw::Profile &profile);

  std::int64_t version = 0;
  bool changed = true; ///< true if changed since its diagnostics were published

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
  std::vector<Analysis> m_analyses; ///< empty: not computed yet
  std::unique_ptr<std::vector<advise::Advice>> m_advice;
};

} // namespace arbiter::tools::lsp
