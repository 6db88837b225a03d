#pragma once
#include <QColor>
#include <QIcon>

class QApplication;

namespace arbiter::builder {

enum class Scheme { System, Light, Dark };

/// Colors that Qt's palette lacks. Texts have a contrast of at least 4.5 on the editor's
/// background, in both schemes; view/window/window_test.cpp checks it.
struct Colors {
  bool dark = false;
  QColor background, text, dim; ///< of the editor
  QColor line;                  ///< the cursor's line
  QColor traced;                ///< the debugger's line
  QColor error, warning, note;
  QColor opcode, keyword, option, binding, name, parameter, number, comment, panel;
  QColor good, amber; ///< gauges within the limit and near it; `error` is over it
};

[[nodiscard]] const Colors &colors();

/// Sets style, palette and colors. System is dark if the desktop's palette is.
void applyScheme(QApplication &application, Scheme scheme);
[[nodiscard]] Scheme schemeNamed(const QString &name);

/// Returns the contrast ratio of two colors, 1 to 21 (WCAG 2.1, 1.4.3).
[[nodiscard]] double contrast(const QColor &a, const QColor &b);

/// Returns the application's icon, drawn like data/arbiter-builder.svg.
[[nodiscard]] QIcon applicationIcon();

} // namespace arbiter::builder
