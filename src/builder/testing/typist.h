#pragma once
#include <QElapsedTimer>
#include <QTest>
#include <QTimer>
#include <QWidget>

namespace arbiter::builder::testing {

/// Types comment lines into a widget, a key a turn, for as long as events are served.
class Typist {
public:
  Typist(QWidget &into, int milliseconds) : m_into(into) {
    QObject::connect(&m_timer, &QTimer::timeout, &into, [this] { key(); });
    m_timer.start(milliseconds);
  }
  Typist(const Typist &) = delete;
  Typist &operator=(const Typist &) = delete;

  /// Ends a line that has begun: what follows is a program again.
  void stop() {
    m_timer.stop();
    while (!m_typed.isEmpty() && !m_typed.endsWith(u'\n'))
      key();
  }
  [[nodiscard]] const QString &typed() const { return m_typed; }
  /// Milliseconds that the slowest key took.
  [[nodiscard]] double slowest() const { return m_slowest; }

  /// What so many keys type.
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

/// The process that a test kills: the window, with a text that is typed for ever; a line on
/// standard output a character, when its key is through.
/// \param journals the folder of its journal
[[nodiscard]] int typeForEver(const QString &journals);

} // namespace arbiter::builder::testing
