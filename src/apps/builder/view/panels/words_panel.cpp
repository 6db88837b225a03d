#include "apps/builder/view/panels/words_panel.h"

#include <QBoxLayout>
#include <QFontDatabase>
#include <QLabel>
#include <QLineEdit>

namespace arbiter::builder {

namespace {

QString programsOf(const Word &word) {
  if (word.fragment && word.vertex)
    return QObject::tr("both");
  return word.fragment ? QObject::tr("fragment") : QObject::tr("vertex");
}

} // namespace

WordsPanel::WordsPanel(const std::function<void(const QString &)> &insert) {
  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  m_search = new QLineEdit;
  m_search->setPlaceholderText(tr("Search instructions, bindings, options and #@ words"));
  m_search->setClearButtonEnabled(true);
  m_search->setAccessibleName(tr("Search words"));
  m_table = new Table(
      {tr("Word"), tr("Kind"), tr("Programs"), tr("Meaning"), tr("Formula"), tr("Section")});
  m_table->setAccessibleName(tr("Words"));
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_table->horizontalHeader()->setSectionResizeMode(3, QHeaderView::Stretch);
  m_detail = new QLabel;
  m_detail->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_detail->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  layout->addWidget(m_search);
  layout->addWidget(m_table, 1);
  layout->addWidget(m_detail);
  connect(m_search, &QLineEdit::textChanged, this, [this](const QString &text) { search(text); });
  connect(m_search, &QLineEdit::returnPressed, this, [this] { m_table->setFocus(); });
  connect(m_table, &QTableWidget::currentCellChanged, this, [this] { showDetail(); });
  connect(m_table, &QTableWidget::cellActivated, this, [this, insert](int row) {
    if (row >= 0 && row < m_found.size())
      insert(m_found[row].word);
  });
  search({});
}

void WordsPanel::search(const QString &text) {
  m_found = searchWords(text);
  m_table->setRowCount(int(m_found.size()));
  for (int row = 0; row < m_found.size(); ++row) {
    const Word &word = m_found[row];
    m_table->put(row, 0, word.word);
    m_table->put(row, 1, nameOf(word.kind));
    m_table->put(row, 2, programsOf(word));
    m_table->put(row, 3, word.doc)->setToolTip(word.doc);
    m_table->put(row, 4, word.formula);
    m_table->put(row, 5, word.section);
  }
  if (!m_found.isEmpty())
    m_table->setCurrentCell(0, 0);
  showDetail();
}

void WordsPanel::showDetail() {
  const int row = m_table->currentRow();
  m_detail->setText(row >= 0 && row < m_found.size() ? m_found[row].signature : QString());
}

void WordsPanel::lookUp(const QString &word) {
  m_search->setText(word.endsWith(u"_SAT") ? word.chopped(4) : word);
  m_table->setFocus();
}

} // namespace arbiter::builder
