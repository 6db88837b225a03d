#include "apps/builder/model/render/control_client.h"

#include <QFile>
#include <QJsonDocument>
#include <QPointer>
#include <cstring>

#include "control/client.h"

namespace arbiter::builder {

namespace {

using control::Json;

QJsonObject toQt(const Json &json) {
  return QJsonDocument::fromJson(
             QByteArray::fromStdString(json.dump(-1, ' ', false, Json::error_handler_t::replace)))
      .object();
}

Json fromQt(const QJsonObject &object) {
  const QByteArray text = QJsonDocument(object).toJson(QJsonDocument::Compact);
  return Json::parse(text.cbegin(), text.cend(), nullptr, false);
}

} // namespace

ControlClient::ControlClient(int descriptor, QObject *parent)
    : QObject(parent), m_client(std::make_unique<control::Client>(control::Descriptor(descriptor))),
      m_readable(descriptor, QSocketNotifier::Read),
      m_writable(descriptor, QSocketNotifier::Write) {
  m_writable.setEnabled(false);
  connect(&m_readable, &QSocketNotifier::activated, this, &ControlClient::read);
  connect(&m_writable, &QSocketNotifier::activated, this, &ControlClient::read);
}

ControlClient::~ControlClient() { close(); }

std::unique_ptr<ControlClient> ControlClient::connectTo(const QString &path, QString &why) {
  auto connected = control::connectTo(QFile::encodeName(path).toStdString());
  if (!connected) {
    why = QString::fromStdString(connected.error().message);
    return nullptr;
  }
  return std::make_unique<ControlClient>(connected.value().release());
}

void ControlClient::close() {
  if (!m_client)
    return;
  m_readable.setEnabled(false);
  m_writable.setEnabled(false);
  m_client.reset();
  const auto waiting = std::exchange(m_waiting, {});
  for (const Answer &answer : waiting)
    if (answer)
      answer({}, {});
}

void ControlClient::watchWriting() {
  if (m_client)
    m_writable.setEnabled(m_client->wantsToWrite());
}

void ControlClient::call(const QString &method, const QJsonObject &params, const Answer &answer) {
  if (!m_client) {
    if (answer)
      answer({}, {});
    return;
  }
  m_waiting.insert(m_client->request(method.toStdString(), fromQt(params)), answer);
  watchWriting();
}

void ControlClient::notify(const QString &method, const QJsonObject &params) {
  if (m_client)
    m_client->notify(method.toStdString(), fromQt(params));
  watchWriting();
}

void ControlClient::takeFrame() {
  const auto lent = m_client->nextFrame();
  if (!lent)
    return;
  QImage image(lent->width, lent->height, QImage::Format_RGBA8888);
  for (int y = 0; y < image.height(); ++y)
    std::memcpy(image.scanLine(y), lent->pixels + std::size_t(lent->height - 1 - y) * lent->stride,
                std::size_t(lent->width) * 4);
  m_client->release(*lent);
  Q_EMIT frame(image, toQt(lent->params));
}

void ControlClient::read() {
  if (!m_client)
    return;
  const QPointer<ControlClient> alive(this); // a receiver may close or delete this
  m_client->receive();
  takeFrame();
  while (alive && m_client) {
    const auto next = m_client->nextEvent();
    if (!next)
      break;
    Q_EMIT notified(QString::fromStdString(next->method), toQt(next->params));
  }
  while (alive && m_client) {
    const auto next = m_client->nextAnswer();
    if (!next)
      break;
    const Answer answer = m_waiting.take(next->first);
    if (!answer)
      continue;
    if (next->second)
      answer(toQt(next->second.value()), {});
    else
      answer({}, {{"code", next->second.error().code},
                  {"message", QString::fromStdString(next->second.error().message)},
                  {"data", toQt(next->second.error().data)}});
  }
  if (!alive || !m_client)
    return;
  watchWriting();
  if (!m_client->connected()) {
    close();
    if (alive)
      Q_EMIT closed();
  }
}

} // namespace arbiter::builder
