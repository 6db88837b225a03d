#pragma once
#include <QPlainTextEdit>
#include <QWidget>
#include <functional>

#include "apps/builder/model/workbench.h"
#include "apps/builder/view/panels/table.h"

class QLabel;
class QPushButton;

namespace arbiter::builder {

/// Shows the compiler's code for the profile's card (`arbiter compile --emit native`), or another
/// output of the compiler.
class NativePanel : public QWidget {
public:
  explicit NativePanel(Workbench &bench);

  void refresh();

protected:
  void showEvent(QShowEvent *event) override;

private:
  Workbench &m_bench;
  ToolRun m_tool;
  QPlainTextEdit *m_text;
  QString m_emit = QStringLiteral("native");
};

/// Lists advice on making the program cheaper (`arbiter check --advise --json`), each with its
/// saving; Return applies it.
class AdvicePanel : public QWidget {
public:
  explicit AdvicePanel(Workbench &bench);

  void refresh();
  /// Loads the command's document. \returns the number of proposals
  int take(const QJsonObject &json);

protected:
  void showEvent(QShowEvent *event) override;

private:
  struct Proposal {
    QString title, saves, why;
    int line = 1;
    QList<Edit> edits; ///< the last one first
  };
  void apply(int row);

  Workbench &m_bench;
  ToolRun m_tool;
  QLabel *m_summary;
  Table *m_table;
  QList<Proposal> m_proposals;
  qint64 m_revision = -1; ///< the revision that the proposals are for
};

/// Measures how fast the document is drawn.
class BenchPanel : public QWidget {
public:
  explicit BenchPanel(Workbench &bench);

  void run();

private:
  Workbench &m_bench;
  QPushButton *m_run;
  Table *m_table;
};

} // namespace arbiter::builder
