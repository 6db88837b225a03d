// The window's program: arbiter-builder [FILE|FOLDER]. `arbiter builder` starts it.
#include <GL/arbiter.h>
#include <QApplication>
#include <QCommandLineParser>
#include <QRegularExpression>
#include <QSettings>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <optional>
#include <string_view>

#include "apps/builder/view/theme.h"
#include "apps/builder/view/window/main_window.h"
#include "apps/builder/view/window/screenshot.h"
#include "util/text/exit_codes.h"

namespace {

using namespace arbiter::builder;

constexpr int kLeastSide = 320, kMaxSide = 8192; ///< of a screenshot

int fail(const QString &text) {
  std::fprintf(stderr, "arbiter-builder: %s\n", text.toLocal8Bit().constData());
  return arbiter::kExitUsage;
}

/// The options of the command line.
struct Options {
  QCommandLineOption scheme{QStringLiteral("colors"), QObject::tr("system, light or dark"),
                            QStringLiteral("SCHEME")};
  QCommandLineOption shot{QStringLiteral("screenshot"),
                          QObject::tr("write a picture of the window when it has drawn, and end"),
                          QStringLiteral("PNG")};
  QCommandLineOption size{QStringLiteral("size"),
                          QObject::tr("the window's size for a picture; 1280x800 without"),
                          QStringLiteral("WxH")};
  QCommandLineOption small{QStringLiteral("small"),
                           QObject::tr("a picture of few colours, for a page")};
  QCommandLineOption panel{QStringLiteral("panel"),
                           QObject::tr("the panel to bring to the front: %1")
                               .arg(MainWindow::panelNames().join(QStringLiteral(", "))),
                           QStringLiteral("NAME")};
  QCommandLineOption edit{
      QStringLiteral("edit"),
      QObject::tr("for a picture: replace a piece of the text when it is drawn"),
      QStringLiteral("FROM=>TO")};
  QCommandLineOption pixel{QStringLiteral("pixel"), QObject::tr("the pixel to debug"),
                           QStringLiteral("X,Y")};
  QCommandLineOption watch{
      QStringLiteral("watch"),
      QObject::tr("for a picture, with --pixel: the line whose register is shown as A"),
      QStringLiteral("LINE")};
  QCommandLineOption attach{QStringLiteral("attach"),
                            QObject::tr("for a picture: the process to attach to"),
                            QStringLiteral("PID")};

  QCommandLineOption version{{QStringLiteral("V"), QStringLiteral("version")},
                             QObject::tr("say which version this is, and end")};

  void addTo(QCommandLineParser &parser) const {
    parser.addOptions({scheme, shot, size, small, panel, edit, pixel, watch, attach, version});
  }
};

/// Parses "1024x700"; returns nothing if it is invalid or no size of a window.
std::optional<QSize> sizeOf(const QString &text) {
  static const QRegularExpression kSize(QStringLiteral("^(\\d{1,5})x(\\d{1,5})$"));
  const QRegularExpressionMatch match = kSize.match(text);
  const QSize size(match.captured(1).toInt(), match.captured(2).toInt());
  const bool fits = std::min(size.width(), size.height()) >= kLeastSide &&
                    std::max(size.width(), size.height()) <= kMaxSide;
  return match.hasMatch() && fits ? std::optional(size) : std::nullopt;
}

/// True if there is a display. Qt would abort without one, but a screenshot needs none.
bool hasDisplay(int argc, char **argv) {
  if (!qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") ||
      !qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
    return true;
  const bool shoots = std::any_of(argv + 1, argv + argc, [](const char *word) {
    return std::string_view(word).starts_with("--screenshot");
  });
  if (shoots)
    qputenv("QT_QPA_PLATFORM", "offscreen");
  return shoots;
}

/// Returns the panel of that name, in any case; nothing if there is none.
std::optional<QString> panelOf(const QString &name) {
  for (const QString &each : MainWindow::panelNames())
    if (each.compare(name, Qt::CaseInsensitive) == 0)
      return each;
  return std::nullopt;
}

int show(MainWindow &window, const QCommandLineParser &parser, const Options &options) {
  const QStringList &documents = parser.positionalArguments();
  const bool shooting = parser.isSet(options.shot);
  const auto size = sizeOf(parser.value(options.size));
  if (parser.isSet(options.size) && !size)
    return fail(QObject::tr("--size %1: a size is WxH, from %2x%2 to %3x%3")
                    .arg(parser.value(options.size))
                    .arg(kLeastSide)
                    .arg(kMaxSide));
  const auto panel = panelOf(parser.value(options.panel));
  if (parser.isSet(options.panel) && !panel)
    return fail(
        QObject::tr("--panel %1: the panels are %2")
            .arg(parser.value(options.panel), MainWindow::panelNames().join(QStringLiteral(", "))));
  if (!shooting)
    window.restoreLayout();
  if (size)
    window.resize(*size);
  if (!documents.isEmpty() && !window.openNamed(documents.constFirst()) && shooting)
    return fail(window.lastNotice());
  window.bench().start(); // its processes start while the window is laid out
  window.show();
  window.showPanel(panel                 ? *panel
                   : documents.isEmpty() ? QObject::tr("Gallery")
                                         : QObject::tr("Program"));
  if (shooting)
    takeScreenshot(window,
                   {parser.value(options.shot), parser.value(options.edit),
                    parser.value(options.pixel), parser.value(options.watch).toInt(),
                    parser.value(options.attach).toLongLong(), parser.isSet(options.small)});
  else
    QMetaObject::invokeMethod(&window, &MainWindow::offerRecovery, Qt::QueuedConnection);
  return QApplication::exec();
}

} // namespace

int main(int argc, char **argv) {
  std::signal(SIGPIPE, SIG_IGN); // makes writing to an ended child an error
  if (!hasDisplay(argc, argv))
    return fail(QStringLiteral("there is no display: neither DISPLAY nor WAYLAND_DISPLAY is set"));
  QApplication application(argc, argv);
  QApplication::setApplicationName(QStringLiteral("arbiter-builder"));
  QApplication::setOrganizationName(QStringLiteral("arbiter"));
  QApplication::setDesktopFileName(QStringLiteral("arbiter-builder"));
  QCommandLineParser parser;
  parser.setApplicationDescription(
      QObject::tr("Write, see and step through ARB fragment and vertex programs."));
  parser.addHelpOption();
  parser.addPositionalArgument(QStringLiteral("document"), QObject::tr("a program, or a folder"),
                               QStringLiteral("[FILE|FOLDER]"));
  const Options options;
  options.addTo(parser);
  if (!parser.parse(QApplication::arguments()))
    return fail(parser.errorText());
  if (parser.isSet(QStringLiteral("help")))
    parser.showHelp();
  if (parser.isSet(options.version)) {
    std::puts("arbiter-builder " ARBITER_VERSION_TEXT);
    return arbiter::kExitOk;
  }
  if (parser.positionalArguments().size() > 1)
    return fail(QObject::tr("one document at a time"));
  const QSettings settings;
  const QString colors = parser.isSet(options.scheme)
                             ? parser.value(options.scheme)
                             : settings.value(QStringLiteral("scheme")).toString();
  applyScheme(application, schemeNamed(colors));
  MainWindow window(Places::standard());
  return show(window, parser, options);
}
