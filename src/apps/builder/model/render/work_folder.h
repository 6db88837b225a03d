#pragma once
#include <QString>

#include "apps/builder/model/render/renderer.h"

namespace arbiter::builder {

/// Writes an unsaved document for a command that reads files: its text under its name in \p folder,
/// with links to the files beside the document.
/// \returns the path of the text
QString layOut(const Scene &scene, const QString &folder);

} // namespace arbiter::builder
