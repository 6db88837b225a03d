#include "apps/builder/view/window/pick.h"

#include <QCoreApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>

namespace arbiter::builder {

namespace {

/// A search field that passes the keys for moving to the list.
class Search : public QLineEdit {
public:
  explicit Search(QListWidget &list) : m_list(list) {}

protected:
  void keyPressEvent(QKeyEvent *event) override {
    switch (event->key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
      QCoreApplication::sendEvent(&m_list, event);
      return;
    default:
      QLineEdit::keyPressEvent(event);
    }
  }

private:
  QListWidget &m_list;
};

} // namespace

int pickFrom(const QStringList &items, const QString &title, QWidget *parent) {
  QDialog dialog(parent);
  dialog.setWindowTitle(title);
  auto *layout = new QVBoxLayout(&dialog);
  auto *list = new QListWidget;
  auto *search = new Search(*list);
  search->setAccessibleName(title);
  layout->addWidget(search);
  layout->addWidget(list);
  const auto fill = [&] {
    list->clear();
    for (int i = 0; i < items.size(); ++i) {
      if (!items[i].contains(search->text(), Qt::CaseInsensitive))
        continue;
      auto *item = new QListWidgetItem(items[i], list);
      item->setData(Qt::UserRole, i);
    }
    list->setCurrentRow(0);
  };
  fill();
  QObject::connect(search, &QLineEdit::textChanged, &dialog, fill);
  QObject::connect(search, &QLineEdit::returnPressed, &dialog, &QDialog::accept);
  QObject::connect(list, &QListWidget::itemActivated, &dialog, &QDialog::accept);
  dialog.resize(420, 360);
  if (dialog.exec() != QDialog::Accepted || !list->currentItem())
    return -1;
  return list->currentItem()->data(Qt::UserRole).toInt();
}

} // namespace arbiter::builder
