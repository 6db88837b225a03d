#pragma once
#include <QElapsedTimer>
#include <QTest>
#include <QTimer>
#include <QWidget>

namespace arbiter::builder::testing {

/// Types comment lines into a widget, one key for each turn of the event loop, while events are
/// handled.
class Typist {
public:
  Typist(QWidget &into, int milliseconds) : m_into(into) {
    QObject::connect(&m_timer, &QTimer::timeout, &into, [this] { key(); });
    m_timer.start(milliseconds);
  }
  Typist(const Typist &) = delete;
  Typist &operator=(const Typist &) = delete;

  /// Ends an unfinished line, so that the text is a valid program again.
  void stop() {
    m_timer.stop();
    while (!m_typed.isEmpty() && !m_typed.endsWith(u'\n'))
      key();
  }
  [[nodiscard]] const QString &typed() const { return m_typed; }
  /// Returns the milliseconds that the slowest key took.
  [[nodiscard]] double slowest() const { return m_slowest; }

  /// Returns the text that so many keys type.
  [[nodiscard]] static QString text(qsizetype characters) {
    QString all;
    for (int line = 0; all.size() < characters; ++line)
      all += QStringLiteral("# line %1, kept as it is\n").arg(line);
    return all.left(characters);
  }

private:
  void key() {
    const QChar next = text(m_typed.size() + 1).back();
    QElapsedTimer since;
    since.start();
    if (next == u'\n')
      QTest::keyClick(&m_into, Qt::Key_Return);
    else
      QTest::keyClick(&m_into, next.toLatin1());
    m_slowest = std::max(m_slowest, double(since.nsecsElapsed()) / 1e6);
    m_typed += next;
  }

  QWidget &m_into;
  QTimer m_timer;
  QString m_typed;
  double m_slowest = 0;
};

/// Runs the process that a test kills: a window in which a text is typed forever. It writes one
/// line to standard output for each character, after its key has been handled.
/// \param journals the folder of its journal
[[nodiscard]] int typeForEver(const QString &journals);

} // namespace arbiter::builder::testing
