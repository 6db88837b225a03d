#pragma once
#include <QHash>
#include <QRegularExpression>
#include <QSyntaxHighlighter>

#include "apps/builder/model/panels/words.h"

namespace arbiter::builder {

/// These tell whether a character may begin, or be within, an identifier.
[[nodiscard]] inline bool beginsWord(QChar c) { return c.isLetter() || c == u'_' || c == u'$'; }
[[nodiscard]] inline bool inWord(QChar c) { return beginsWord(c) || c.isDigit(); }

/// Colors a program's words by the compiler's tables. Words in no table are names.
class Highlighter : public QSyntaxHighlighter {
public:
  explicit Highlighter(QTextDocument *document);

  /// Updates the colors after they have changed.
  void refresh();

protected:
  void highlightBlock(const QString &text) override;

private:
  void panelLine(const QString &text, qsizetype begin);
  [[nodiscard]] qsizetype word(const QString &text, qsizetype begin);
  [[nodiscard]] qsizetype number(const QString &text, qsizetype begin);

  QHash<QString, WordKind> m_words;
  QHash<QString, WordKind> m_panel;
};

} // namespace arbiter::builder
