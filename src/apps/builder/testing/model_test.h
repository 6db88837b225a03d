#pragma once
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QTemporaryDir>
#include <QTimer>
#include <functional>
#include <gtest/gtest.h>

namespace arbiter::builder::testing {

/// Handles events until the condition holds. \returns false after \p milliseconds without it; the
/// default is long, as test machines are busy
inline bool waitFor(const std::function<bool()> &condition, int milliseconds = 60000) {
  QElapsedTimer since;
  since.start();
  while (!condition()) {
    if (since.elapsed() > milliseconds)
      return false;
    QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 20);
  }
  return true;
}

/// Handles events for some time.
inline void serve(int milliseconds) {
  QElapsedTimer since;
  since.start();
  while (since.elapsed() < milliseconds)
    QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
}

} // namespace arbiter::builder::testing
