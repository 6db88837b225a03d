#include "apps/builder/model/language/lsp_client.h"

#include <QCoreApplication>

#include "apps/builder/model/text/edit.h"

namespace arbiter::builder {

namespace {

constexpr int kAnswerMilliseconds = 10000;
constexpr int kRestartMilliseconds = 50;
constexpr int kMaxDeaths = 3;
/// If the server has more unread bytes than this, texts wait, and a newer text replaces a waiting
/// one.
constexpr qint64 kMaxUnread = 1 << 16;

} // namespace

LspClient::LspClient(QString program, QObject *parent)
    : QObject(parent), m_program(std::move(program)) {
  m_watchdog.setSingleShot(true);
  m_watchdog.setInterval(kAnswerMilliseconds);
  connect(&m_watchdog, &QTimer::timeout, this,
          [this] { ended(tr("the language server does not answer")); });
  m_restart.setSingleShot(true);
  m_restart.setInterval(kRestartMilliseconds);
  connect(&m_restart, &QTimer::timeout, this, &LspClient::start);
}

LspClient::~LspClient() {
  if (!m_process)
    return;
  m_process->disconnect(this);
  m_process->closeWriteChannel(); // the server ends at the end of its input
  if (!m_process->waitForFinished(200)) {
    m_process->kill();
    m_process->waitForFinished(1000);
  }
}

void LspClient::start() {
  if (m_process)
    return;
  m_process = new QProcess(this);
  m_messages.clear();
  connect(m_process, &QProcess::readyReadStandardOutput, this, &LspClient::read);
  connect(m_process, &QProcess::bytesWritten, this, &LspClient::sendText);
  connect(m_process, &QProcess::finished, this, [this] { ended(tr("the language server ended")); });
  connect(m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart)
      ended(tr("%1 cannot be started: problems are not shown").arg(m_program));
  });
  m_process->setProcessChannelMode(QProcess::SeparateChannels);
  m_process->setStandardErrorFile(QProcess::nullDevice());
  m_process->start(m_program, {QStringLiteral("lsp")});
  QJsonObject options;
  if (!m_profile.isEmpty())
    options[u"profile"] = m_profile;
  call(
      QStringLiteral("initialize"),
      {{"processId", QCoreApplication::applicationPid()},
       {"rootUri", QJsonValue()},
       {"capabilities", QJsonObject()},
       {"initializationOptions", options}},
      [this](const QJsonValue &result) { initialized(result.toObject()); }, -1);
  m_watchdog.start();
}

void LspClient::initialized(const QJsonObject &result) {
  m_capabilities = result[u"capabilities"].toObject();
  m_tokenTypes.clear();
  const QJsonValue legend = m_capabilities[u"semanticTokensProvider"][u"legend"];
  for (const QJsonValue type : legend[u"tokenTypes"].toArray())
    m_tokenTypes.append(type.toString());
  m_ready = true;
  m_watchdog.stop();
  notify(QStringLiteral("initialized"), {});
  Q_EMIT ready();
  sendText();
}

void LspClient::setText(const QString &uri, const QString &text, qint64 revision) {
  m_uri = uri;
  m_text = text;
  m_revision = revision;
  if (m_heldRevision >= 0 && m_heldRevision != revision) {
    m_heldRevision = -1;
    m_deaths = 0;
    start();
  }
  sendText();
}

void LspClient::sendText() {
  if (!m_ready || !m_process || m_revision == m_sentRevision || m_revision < 0 ||
      m_process->bytesToWrite() > kMaxUnread)
    return;
  if (m_openUri != m_uri) {
    if (!m_openUri.isEmpty())
      notify(QStringLiteral("textDocument/didClose"),
             {{"textDocument", QJsonObject{{"uri", m_openUri}}}});
    m_openUri = m_uri;
    notify(QStringLiteral("textDocument/didOpen"),
           {{"textDocument", QJsonObject{{"uri", m_uri},
                                         {"languageId", "arbprogram"},
                                         {"version", m_revision},
                                         {"text", m_text}}}});
  } else {
    notify(QStringLiteral("textDocument/didChange"),
           {{"textDocument", QJsonObject{{"uri", m_uri}, {"version", m_revision}}},
            {"contentChanges", QJsonArray{QJsonObject{{"text", m_text}}}}});
  }
  m_sentRevision = m_revision;
  if (!m_watchdog.isActive())
    m_watchdog.start();
}

void LspClient::setProfile(const QString &profile) {
  m_profile = profile;
  if (m_ready)
    sendProfile();
}

void LspClient::sendProfile() {
  notify(QStringLiteral("workspace/didChangeConfiguration"),
         {{"settings", QJsonObject{{"arbiter", QJsonObject{{"profile", m_profile}}}}}});
}

void LspClient::request(const QString &method, qsizetype at, QJsonObject parameters,
                        Answer answer) {
  sendText();
  if (!m_ready || m_sentRevision != m_revision) {
    answer({});
    return;
  }
  parameters[u"textDocument"] = textDocument();
  if (at >= 0) {
    const LineColumn place = placeOf(m_text, at);
    parameters[u"position"] =
        QJsonObject{{"line", place.line - 1}, {"character", place.column - 1}};
  }
  call(method, parameters, std::move(answer), m_revision);
}

void LspClient::call(const QString &method, const QJsonObject &params, Answer answer,
                     qint64 revision) {
  const int id = m_nextId++;
  m_waiting.insert(id, {revision, std::move(answer)});
  send({{"id", id}, {"method", method}, {"params", params}});
}

void LspClient::notify(const QString &method, const QJsonObject &params) {
  send({{"method", method}, {"params", params}});
}

void LspClient::send(QJsonObject message) {
  if (!m_process)
    return;
  message[u"jsonrpc"] = QStringLiteral("2.0");
  m_process->write(LspMessages::frame(message));
}

void LspClient::read() {
  const QList<QJsonObject> all = m_messages.take(m_process->readAllStandardOutput());
  const QProcess *const process = m_process;
  for (const QJsonObject &message : all)
    if (m_process == process)
      receive(message);
  if (m_process == process && m_messages.broken())
    ended(tr("the language server writes what cannot be read"));
}

void LspClient::receive(const QJsonObject &message) {
  if (message[u"method"] == QStringLiteral("textDocument/publishDiagnostics"))
    published(message[u"params"].toObject());
  if (message.contains(u"method"))
    return;
  const auto waiting = m_waiting.find(message[u"id"].toInt(-1));
  if (waiting == m_waiting.end())
    return;
  const Waiting taken = *waiting;
  m_waiting.erase(waiting);
  if (taken.revision < 0 || taken.revision == m_revision)
    taken.answer(message[u"result"]);
}

void LspClient::published(const QJsonObject &params) {
  const qint64 revision = params[u"version"].toInteger(-1);
  if (params[u"uri"].toString() != m_uri)
    return;
  if (revision == m_sentRevision) {
    m_watchdog.stop();
    m_deaths = 0;
  }
  if (revision == m_revision)
    Q_EMIT diagnosed(revision, problemsOf(params[u"diagnostics"].toArray(), m_text));
}

void LspClient::ended(const QString &why) {
  if (!m_process)
    return;
  m_watchdog.stop();
  const bool started = m_process->error() != QProcess::FailedToStart;
  m_process->disconnect(this);
  m_process->kill();
  m_process->deleteLater();
  m_process = nullptr;
  m_ready = false;
  m_openUri.clear();
  m_sentRevision = -1;
  const QHash<int, Waiting> lost = std::exchange(m_waiting, {});
  for (const Waiting &each : lost)
    if (each.revision >= 0)
      each.answer({});
  const bool again = started && ++m_deaths < kMaxDeaths;
  if (again)
    m_restart.start();
  else
    m_heldRevision = m_revision;
  Q_EMIT troubled(again ? tr("%1; it is started anew").arg(why)
                  : started
                      ? tr("%1 by this text; it is started anew when the text changes").arg(why)
                      : why);
}

} // namespace arbiter::builder
