#pragma once
#include <QString>
#include <QStringList>

namespace arbiter::builder {

/// Returns the files that a document and its other programs name: images, a mesh, vertex programs,
/// further passes, a profile. Names are relative, each once. \param folder where the document looks
/// for them
[[nodiscard]] QStringList companionsOf(const QString &text, const QString &name,
                                       const QString &folder);

/// Copies the files that \p to does not have, and overwrites none. \returns the names of the
/// copies; \p failed gets the names of the others
QStringList copyCompanions(const QStringList &names, const QString &from, const QString &to,
                           QStringList &failed);

} // namespace arbiter::builder
