#pragma once
#include <QStringList>

class QWidget;

namespace arbiter::builder {

/// Lets the user choose an item by typing a part of it; the arrow keys move in the list.
/// \returns its number, -1 if none was chosen
[[nodiscard]] int pickFrom(const QStringList &items, const QString &title, QWidget *parent);

} // namespace arbiter::builder
