#pragma once
#include <QString>

#include "builder/model/workbench.h"

class QWidget;

namespace arbiter::builder {

/// The name by which a document may have a file: relative to its folder. One that lies elsewhere is
/// copied there, when the user says so. Empty: it is not, and was complained of.
[[nodiscard]] QString nameBeside(QWidget *parent, Workbench &bench, const QString &path);

/// The same without a question: the file is copied.
/// \returns empty after telling the bench's notice why it could not be
[[nodiscard]] QString copyBeside(Workbench &bench, const QString &path);

} // namespace arbiter::builder
