#include "apps/builder/view/panels/problems_panel.h"

#include <algorithm>

#include "apps/builder/view/theme.h"

namespace arbiter::builder {

ProblemsPanel::ProblemsPanel(Workbench &bench, std::function<void(qsizetype)> goTo)
    : Table({tr("Place"), tr("Problem"), tr("What to do")}), m_bench(bench) {
  setAccessibleName(tr("Problems"));
  horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  horizontalHeader()->setSectionResizeMode(2, QHeaderView::Stretch);
  connect(&bench, &Workbench::problemsChanged, this, [this] { fill(); });
  const auto go = [this, goTo = std::move(goTo)](int row) {
    if (row >= 0 && row < m_bench.problems().size())
      goTo(m_bench.problems()[row].begin);
  };
  connect(this, &QTableWidget::cellActivated, this, go);
  connect(this, &QTableWidget::cellClicked, this, go);
  fill();
}

int ProblemsPanel::errors() const {
  return int(std::count_if(m_bench.problems().cbegin(), m_bench.problems().cend(),
                           [](const Problem &each) { return each.severity == Severity::Error; }));
}

void ProblemsPanel::fill() {
  const QList<Problem> &problems = m_bench.problems();
  setRowCount(int(problems.size()));
  for (int row = 0; row < problems.size(); ++row) {
    const Problem &problem = problems[row];
    const QString place = QStringLiteral("%1%2:%3")
                              .arg(problem.file.isEmpty() ? QString() : problem.file + u':')
                              .arg(problem.line)
                              .arg(problem.column);
    const Colors &c = colors();
    put(row, 0, place)
        ->setForeground(problem.severity == Severity::Error     ? c.error
                        : problem.severity == Severity::Warning ? c.warning
                                                                : c.note);
    put(row, 1, problem.message)->setToolTip(problem.message);
    put(row, 2, problem.hint)->setToolTip(problem.hint);
  }
}

} // namespace arbiter::builder
