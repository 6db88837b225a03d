#pragma once
#include <QColor>
#include <QIcon>

class QApplication;

namespace arbiter::builder {

enum class Scheme { System, Light, Dark };

/// The colours of what Qt's palette has none for. Texts have a contrast of 4.5 or more on the
/// editor's background, in both schemes; view/window/window_test.cpp counts it.
struct Colours {
  bool dark = false;
  QColor background, text, dim; ///< of the editor
  QColor line;                  ///< the line of the cursor
  QColor traced;                ///< the line that the debugger is at
  QColor error, warning, note;
  QColor opcode, keyword, option, binding, name, parameter, number, comment, panel;
  QColor good, amber; ///< gauges: within, near the limit; over is `error`
};

[[nodiscard]] const Colours &colours();

/// Sets style, palette and colours. System is dark where the desktop's palette is.
void applyScheme(QApplication &application, Scheme scheme);
[[nodiscard]] Scheme schemeNamed(const QString &name);

/// The relative contrast of two colours, 1 to 21 (WCAG 2.1, 1.4.3).
[[nodiscard]] double contrast(const QColor &a, const QColor &b);

/// The application's icon, as data/arbiter-builder.svg draws it.
[[nodiscard]] QIcon applicationIcon();

} // namespace arbiter::builder
