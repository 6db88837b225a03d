#include <QApplication>
#include <QStandardPaths>
#include <csignal>
#include <gtest/gtest.h>

#include "builder/view/theme.h"

int main(int argc, char **argv) {
  std::signal(SIGPIPE, SIG_IGN);
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
    qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  QStandardPaths::setTestModeEnabled(true);
  arbiter::builder::applyScheme(application, arbiter::builder::Scheme::Light);
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
