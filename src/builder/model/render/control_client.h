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

/// The client of docs/write/control.md (src/control) in Qt's event loop, with Qt's JSON. A side
/// that sends what cannot be understood is hung up on.
class ControlClient : public QObject {
  Q_OBJECT
public:
  /// \param descriptor owned from here on
  explicit ControlClient(int descriptor, QObject *parent = nullptr);
  ~ControlClient() override;
  /// Connects to a socket's path, whose other end must be of the same user; nullptr with a reason.
  [[nodiscard]] static std::unique_ptr<ControlClient> connectTo(const QString &path, QString &why);

  /// \p result or \p error is what came; both empty when the other side is gone.
  using Answer = std::function<void(const QJsonObject &result, const QJsonObject &error)>;
  void call(const QString &method, const QJsonObject &params, Answer answer = {});
  void notify(const QString &method, const QJsonObject &params);
  [[nodiscard]] bool isOpen() const { return m_client != nullptr; }
  void close();

  /// Takes what has come, without waiting. Pictures are told before events, and those before
  /// answers.
  void read();

Q_SIGNALS:
  void event(const QString &method, const QJsonObject &params);
  /// A copy of the newest picture, the top row first; it has been released.
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
