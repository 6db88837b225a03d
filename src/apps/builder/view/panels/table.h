#pragma once
#include <QHeaderView>
#include <QTableWidget>

namespace arbiter::builder {

/// A read-only table with the keys of a list.
class Table : public QTableWidget {
public:
  explicit Table(const QStringList &columns, QWidget *parent = nullptr) : QTableWidget(parent) {
    setColumnCount(int(columns.size()));
    setHorizontalHeaderLabels(columns);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    setSelectionBehavior(SelectRows);
    setSelectionMode(SingleSelection);
    setEditTriggers(NoEditTriggers);
    setShowGrid(false);
    setAlternatingRowColors(true);
    setTabKeyNavigation(false); // Tab leaves the table
    setWordWrap(false);
  }

  QTableWidgetItem *put(int row, int column, const QString &text) {
    auto *cell = new QTableWidgetItem(text);
    setItem(row, column, cell);
    return cell;
  }
};

} // namespace arbiter::builder
