#pragma once
#include <QString>

namespace arbiter::builder {

class MainWindow;

/// Writes a picture of the window into a PNG as soon as the document is drawn, the problems are
/// known and, if \p pixel ("X,Y") is not empty, that pixel is traced; then ends the application. It
/// ends with code 1 after 30 s in any case, with what is there.
/// \param small 32 shades a channel, well packed
void takeScreenshot(MainWindow &window, const QString &png, const QString &pixel, bool small);

} // namespace arbiter::builder
