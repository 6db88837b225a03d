#pragma once
#include <QJsonArray>
#include <QListWidget>

namespace arbiter::builder {

class CodeEditor;

/// Shows the language server's completions at the cursor, narrowed by what is typed.
class Completer : public QListWidget {
public:
  explicit Completer(CodeEditor &editor);

  /// Shows CompletionItem[] for the word that begins at an offset of the text.
  void show(const QJsonArray &items, qsizetype wordBegin);
  /// Hides items that no longer match the word, and the list if none does.
  void narrow();
  /// Handles arrow keys, Return, Tab and Escape. \returns false for other keys
  bool takeKey(int key);
  /// Inserts the item's text into the editor.
  void accept();

private:
  void place();
  [[nodiscard]] QString typed() const;
  void select(int by);

  CodeEditor &m_editor;
  qsizetype m_wordBegin = 0;
};

} // namespace arbiter::builder
