#pragma once
#include <QByteArray>
#include <QHash>
#include <QJsonObject>
#include <QList>
#include <QObject>
#include <QSocketNotifier>
#include <functional>
#include <memory>

namespace arbiter::builder {

/// A connected socket that speaks the protocol of docs/control.md: JSON-RPC 2.0, a message a line,
/// descriptors beside them. A side that sends too long a line, or a descriptor that is not asked
/// for, is hung up on.
class ControlClient : public QObject {
  Q_OBJECT
public:
  static constexpr qsizetype kMaxLine = 4 << 20;

  /// \param descriptor owned from here on
  explicit ControlClient(int descriptor, QObject *parent = nullptr);
  ~ControlClient() override;
  /// Connects to a socket's path, whose other end must be of the same user; nullptr with a reason.
  [[nodiscard]] static std::unique_ptr<ControlClient> connectTo(const QString &path, QString &why);

  /// \p result or \p error is what came; both empty when the other side is gone.
  using Answer = std::function<void(const QJsonObject &result, const QJsonObject &error)>;
  void call(const QString &method, const QJsonObject &params, Answer answer = {});
  void notify(const QString &method, const QJsonObject &params);
  [[nodiscard]] bool isOpen() const { return m_descriptor >= 0; }
  void close();

  /// Takes what has come, without waiting.
  void read();

  /// The descriptor that came with the last event, for the receiver to own; -1 without one.
  [[nodiscard]] int takeDescriptor();

Q_SIGNALS:
  void event(const QString &method, const QJsonObject &params);
  void closed();

private:
  void receive(const QByteArray &line);
  void send(QJsonObject message);
  void flush();
  void hangUp();

  int m_descriptor;
  QSocketNotifier m_readable;
  QSocketNotifier m_writable;
  QByteArray m_in, m_out;
  QList<int> m_descriptors;
  QHash<qint64, Answer> m_waiting;
  qint64 m_nextId = 1;
};

} // namespace arbiter::builder
