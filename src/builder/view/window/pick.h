#pragma once
#include <QStringList>

class QWidget;

namespace arbiter::builder {

/// Lets the user choose one of many by typing a part of it; the arrow keys move in the list
/// meanwhile. \returns its number, -1 if none was chosen
[[nodiscard]] int pickFrom(const QStringList &items, const QString &title, QWidget *parent);

} // namespace arbiter::builder
