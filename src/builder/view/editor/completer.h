#pragma once
#include <QJsonArray>
#include <QListWidget>

namespace arbiter::builder {

class CodeEditor;

/// The list of what may stand at the cursor, as the language server says; narrowed by what is
/// typed.
class Completer : public QListWidget {
public:
  explicit Completer(CodeEditor &editor);

  /// Shows CompletionItem[] for the word that begins at an offset of the text.
  void show(const QJsonArray &items, qsizetype wordBegin);
  /// The word has changed: hides what no longer fits, and the list if nothing does.
  void narrow();
  /// Arrow keys, Return, Tab and Escape. \returns false if the key is not the list's
  bool takeKey(int key);
  /// The item puts its text into the editor.
  void accept();

private:
  void place();
  [[nodiscard]] QString typed() const;
  void select(int by);

  CodeEditor &m_editor;
  qsizetype m_wordBegin = 0;
};

} // namespace arbiter::builder
