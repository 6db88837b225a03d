#include <QApplication>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <csignal>
#include <gtest/gtest.h>

#include "apps/builder/testing/typist.h"
#include "apps/builder/view/theme.h"

int main(int argc, char **argv) {
  std::signal(SIGPIPE, SIG_IGN);
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
    qputenv("QT_QPA_PLATFORM", "offscreen");
  QTemporaryDir settings; // the user's own settings stay unchanged
  qputenv("XDG_CONFIG_HOME", settings.path().toLocal8Bit());
  QApplication application(argc, argv);
  QStandardPaths::setTestModeEnabled(true);
  arbiter::builder::applyScheme(application, arbiter::builder::Scheme::Light);
  if (argc == 3 && QByteArray(argv[1]) == "--type-into") // Editor.Killed... starts this process
    return arbiter::builder::testing::typeForEver(QString::fromLocal8Bit(argv[2]));
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
