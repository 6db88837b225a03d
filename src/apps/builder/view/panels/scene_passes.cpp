// The scene panel's list of files: the vertex program and the further passes.
#include <QBoxLayout>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QListWidget>
#include <QPushButton>

#include "apps/builder/model/panels/clauses.h"
#include "apps/builder/view/panels/beside.h"
#include "apps/builder/view/panels/scene_panel.h"

namespace arbiter::builder {

void ScenePanel::addPasses(QFormLayout *form) {
  auto *box = new QWidget;
  auto *layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  m_passes = new QListWidget;
  m_passes->setObjectName(QStringLiteral("scene-passes"));
  m_passes->setAccessibleName(tr("Programs of the document"));
  m_passes->addItem(tr("pass 1: %1").arg(m_bench.file().name()));
  if (!m_settings.vertex.isEmpty())
    m_passes->addItem(tr("its vertices: %1").arg(m_settings.vertex));
  for (qsizetype i = 0; i < m_settings.then.size(); ++i)
    m_passes->addItem(tr("pass %1: %2").arg(i + 2).arg(m_settings.then[i]));
  m_passes->setFixedHeight(m_passes->sizeHintForRow(0) * std::min(m_passes->count() + 1, 5) + 6);
  layout->addWidget(m_passes);
  auto *row = new QHBoxLayout;
  const auto button = [&](const QString &title, const char *name,
                          const std::function<void()> &action) {
    auto *made = new QPushButton(title);
    made->setObjectName(QLatin1StringView(name));
    connect(made, &QPushButton::clicked, this, action);
    row->addWidget(made);
    return made;
  };
  button(tr("Vertices..."), "scene-vertex", [this] { chooseFile(QStringLiteral("vertex")); });
  button(tr("Add pass..."), "scene-then", [this] { chooseFile(QStringLiteral("then")); });
  auto *open = button(tr("Open"), "scene-open", [this] { openPass(); });
  auto *remove = button(tr("Remove"), "scene-remove", [this] { removePass(); });
  row->addStretch();
  layout->addLayout(row);
  const auto enable = [this, open, remove] {
    open->setEnabled(m_passes->currentRow() > 0);
    remove->setEnabled(m_passes->currentRow() > 0);
  };
  connect(m_passes, &QListWidget::currentRowChanged, this, enable);
  connect(m_passes, &QListWidget::itemActivated, this, [this] { openPass(); });
  enable();
  form->addRow(tr("Programs"), box);
}

void ScenePanel::chooseFile(const QString &word) {
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Program"), m_bench.file().folder(),
                                   word == u"vertex" ? tr("Vertex programs (*.vp)")
                                                     : tr("Programs (*.fp *.atifs *.nvrc *.nvts)"));
  const QString name = path.isEmpty() ? QString() : nameBeside(this, m_bench, path);
  if (name.isEmpty())
    return;
  if (word == u"vertex")
    return write(word, quotedName(name));
  m_bench.document().apply({addClause(m_bench.document().text(), word, quotedName(name))},
                           tr("add a pass"));
}

namespace {

/// Returns the clause of a row of the list; none for the first row, which is the text itself.
std::optional<Clause> clauseOfRow(const QString &text, int row) {
  QList<Clause> rows;
  if (const auto vertex = clauseOf(text, QStringLiteral("vertex")))
    rows << *vertex;
  for (const Clause &clause : clausesOf(text))
    if (clause.word == u"then")
      rows << clause;
  return row > 0 && row <= rows.size() ? std::optional(rows[row - 1]) : std::nullopt;
}

} // namespace

void ScenePanel::removePass() {
  const QString &text = m_bench.document().text();
  if (const auto clause = clauseOfRow(text, m_passes->currentRow()))
    m_bench.document().apply({removeClause(text, *clause)}, tr("remove %1").arg(clause->value));
}

void ScenePanel::openPass() {
  const auto clause = clauseOfRow(m_bench.document().text(), m_passes->currentRow());
  if (clause)
    m_open(QDir(m_bench.file().folder()).filePath(QString(clause->value).remove(u'"')));
}

} // namespace arbiter::builder
