#pragma once
#include <QString>

#include "apps/builder/model/workbench.h"

class QWidget;

namespace arbiter::builder {

/// Returns the name of a file relative to the document's folder. If it lies elsewhere, it asks the
/// user and copies the file there. Returns "" after a refusal or a reported error.
[[nodiscard]] QString nameBeside(QWidget *parent, Workbench &bench, const QString &path);

/// Copies the file without asking, and returns its relative name.
/// \returns "" after reporting the error by the workbench's notice
[[nodiscard]] QString copyBeside(Workbench &bench, const QString &path);

} // namespace arbiter::builder
