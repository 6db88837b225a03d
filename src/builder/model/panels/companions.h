#pragma once
#include <QString>
#include <QStringList>

namespace arbiter::builder {

/// The files beside a document that it names, and those that its other programs name: images, a
/// mesh, programs of vertices and further passes, a profile. Relative names, each once. \param
/// folder where the document looks for them
[[nodiscard]] QStringList companionsOf(const QString &text, const QString &name,
                                       const QString &folder);

/// Copies those that \p to has not; what it has stays as it is. \returns the names of the copies;
/// those that could not be made are in \p failed
QStringList copyCompanions(const QStringList &names, const QString &from, const QString &to,
                           QStringList &failed);

} // namespace arbiter::builder
