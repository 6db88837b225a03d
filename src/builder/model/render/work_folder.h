#pragma once
#include <QString>

#include "builder/model/render/renderer.h"

namespace arbiter::builder {

/// Lays out a document that is not saved for a command that reads files: its text under its name in
/// \p folder, and beside it links to what lies beside the document.
/// \returns the path of the text
QString layOut(const Scene &scene, const QString &folder);

} // namespace arbiter::builder
