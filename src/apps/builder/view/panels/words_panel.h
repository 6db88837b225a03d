#pragma once
#include <QWidget>
#include <functional>

#include "apps/builder/model/panels/words.h"
#include "apps/builder/view/panels/table.h"

class QLabel;
class QLineEdit;

namespace arbiter::builder {

/// Lists the words of the languages, from the compiler's tables; they can be searched and inserted
/// into the text.
class WordsPanel : public QWidget {
public:
  explicit WordsPanel(const std::function<void(const QString &)> &insert);

  /// Shows the entry of a word.
  void lookUp(const QString &word);

private:
  void search(const QString &text);
  void showDetail();

  QList<Word> m_found;
  QLineEdit *m_search;
  Table *m_table;
  QLabel *m_detail;
};

} // namespace arbiter::builder
