#pragma once
#include <QHash>
#include <QImage>
#include <QJsonObject>
#include <QObject>
#include <QSocketNotifier>
#include <functional>
#include <memory>

namespace arbiter::control {
class Client;
}

namespace arbiter::builder {

/// A client of the control protocol (docs/write/control.md, src/control) in Qt's event loop, with
/// Qt's JSON. It disconnects from a server that sends invalid messages.
class ControlClient : public QObject {
  Q_OBJECT
public:
  /// Takes a connected socket. \param descriptor owned by the client
  explicit ControlClient(int descriptor, QObject *parent = nullptr);
  ~ControlClient() override;
  /// Connects to a socket's path, whose server must belong to the same user; nullptr with a reason.
  [[nodiscard]] static std::unique_ptr<ControlClient> connectTo(const QString &path, QString &why);

  /// Receives \p result or \p error; both are empty if the server is gone.
  using Answer = std::function<void(const QJsonObject &result, const QJsonObject &error)>;
  void call(const QString &method, const QJsonObject &params, const Answer &answer = {});
  void notify(const QString &method, const QJsonObject &params);
  [[nodiscard]] bool isOpen() const { return m_client != nullptr; }
  void close();

  /// Reads what has arrived, without waiting. It emits pictures before events, and events before
  /// answers.
  void read();

Q_SIGNALS:
  void notified(const QString &method, const QJsonObject &params);
  /// Delivers a copy of the newest picture, the top row first; the picture itself has been
  /// released.
  void frame(const QImage &image, const QJsonObject &params);
  void closed();

private:
  void takeFrame();
  void watchWriting();

  std::unique_ptr<control::Client> m_client; ///< null: closed
  QSocketNotifier m_readable;
  QSocketNotifier m_writable;
  QHash<quint64, Answer> m_waiting;
};

} // namespace arbiter::builder
