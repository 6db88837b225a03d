// arbiter-builder [FILE|FOLDER]: the window. `arbiter builder` starts it.
#include <QApplication>
#include <QCommandLineParser>
#include <QSettings>
#include <csignal>
#include <cstdio>

#include "builder/view/theme.h"
#include "builder/view/window/main_window.h"
#include "builder/view/window/screenshot.h"

namespace {

constexpr int kExitUsage = 1;

int fail(const QString &text) {
  std::fprintf(stderr, "arbiter-builder: %s\n", text.toLocal8Bit().constData());
  return kExitUsage;
}

} // namespace

int main(int argc, char **argv) {
  using namespace arbiter::builder;
  std::signal(SIGPIPE, SIG_IGN); // a child that goes is an error of a write
  if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") &&
      qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) // Qt would abort
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
  const QCommandLineOption scheme(QStringLiteral("colours"), QObject::tr("system, light or dark"),
                                  QStringLiteral("SCHEME"));
  const QCommandLineOption shot(
      QStringLiteral("screenshot"),
      QObject::tr("write a picture of the window when it has drawn, and end"),
      QStringLiteral("PNG"));
  const QCommandLineOption size(QStringLiteral("size"),
                                QObject::tr("the window's size for a picture; 1280x800 without"),
                                QStringLiteral("WxH"));
  const QCommandLineOption small(QStringLiteral("small"),
                                 QObject::tr("a picture of few colours, for a page"));
  const QCommandLineOption panel(QStringLiteral("panel"),
                                 QObject::tr("the panel to bring to the front"),
                                 QStringLiteral("NAME"));
  const QCommandLineOption pixel(QStringLiteral("pixel"), QObject::tr("the pixel to debug"),
                                 QStringLiteral("X,Y"));
  parser.addOptions({scheme, shot, size, small, panel, pixel});
  if (!parser.parse(QApplication::arguments()))
    return fail(parser.errorText());
  if (parser.isSet(QStringLiteral("help")))
    parser.showHelp();
  if (parser.positionalArguments().size() > 1)
    return fail(QObject::tr("one document at a time"));

  QSettings settings;
  const QString colours = parser.isSet(scheme)
                              ? parser.value(scheme)
                              : settings.value(QStringLiteral("scheme")).toString();
  applyScheme(application, schemeNamed(colours));
  MainWindow window(Places::standard());
  const bool shooting = parser.isSet(shot);
  if (!shooting)
    window.restoreLayout();
  else if (const QStringList sides = parser.value(size).split(u'x'); sides.size() == 2)
    window.resize(sides[0].toInt(), sides[1].toInt());
  if (!parser.positionalArguments().isEmpty())
    window.openNamed(parser.positionalArguments().constFirst());
  window.bench().start(); // first: its processes start while the window is laid out
  window.show();
  window.showPanel(parser.isSet(panel)                      ? parser.value(panel)
                   : parser.positionalArguments().isEmpty() ? QObject::tr("Gallery")
                                                            : QObject::tr("Program"));
  if (shooting)
    takeScreenshot(window, parser.value(shot), parser.value(pixel), parser.isSet(small));
  else
    QMetaObject::invokeMethod(&window, &MainWindow::offerRecovery, Qt::QueuedConnection);
  return QApplication::exec();
}
