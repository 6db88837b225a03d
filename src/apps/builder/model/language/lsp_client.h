#pragma once
#include <QHash>
#include <QJsonObject>
#include <QObject>
#include <QProcess>
#include <QTimer>
#include <functional>

#include "apps/builder/model/language/lsp_messages.h"
#include "apps/builder/model/language/problem.h"

namespace arbiter::builder {

/// Serves one text by a language server, `arbiter lsp`, in a process of its own. A server that ends
/// or stops answering is restarted with the newest text. If one text ends it repeatedly, the server
/// does not get that text again until it changes.
class LspClient : public QObject {
  Q_OBJECT
public:
  /// \param program the command `arbiter`
  explicit LspClient(QString program, QObject *parent = nullptr);
  ~LspClient() override;

  /// Starts the server if it does not run.
  void start();
  /// Sends a text with its name ("file:///.../twirl.fp") and a revision, which must increase.
  void setText(const QString &uri, const QString &text, qint64 revision);
  /// Sets the profile that counts are for; empty: the server's own.
  void setProfile(const QString &profile);

  /// Receives the result of a request, or null after an error or the server's end. If `anyRevision`
  /// is false, it is not called when the text changed meanwhile.
  using Answer = std::function<void(const QJsonValue &result)>;
  /// Sends a request about a place in the text. \p parameters gets textDocument, and position if at
  /// >= 0.
  void request(const QString &method, qsizetype at, QJsonObject parameters, Answer answer);

  [[nodiscard]] bool isReady() const { return m_ready; }
  [[nodiscard]] qint64 processId() const { return m_process ? m_process->processId() : 0; }
  [[nodiscard]] QString uri() const { return m_uri; }
  /// Returns the types of semantic tokens, by number.
  [[nodiscard]] const QStringList &tokenTypes() const { return m_tokenTypes; }
  [[nodiscard]] bool offers(const QString &capability) const {
    return m_capabilities.contains(capability);
  }
  void setPatience(int milliseconds) { m_watchdog.setInterval(milliseconds); }

Q_SIGNALS:
  /// Delivers the server's diagnostics of the text of that revision, if it still is the newest.
  void diagnosed(qint64 revision, const QList<arbiter::builder::Problem> &problems);
  void ready();
  /// Reports that the server does not run or does not answer; the text tells what is done about it.
  void troubled(const QString &message);

private:
  struct Waiting {
    qint64 revision = 0;
    Answer answer;
  };

  void read();
  void receive(const QJsonObject &message);
  void initialized(const QJsonObject &result);
  void published(const QJsonObject &params);
  void send(QJsonObject message);
  void notify(const QString &method, const QJsonObject &params);
  void call(const QString &method, const QJsonObject &params, Answer answer, qint64 revision);
  void sendText();
  void ended(const QString &why);
  void sendProfile();
  [[nodiscard]] QJsonObject textDocument() const { return {{"uri", m_uri}}; }

  QString m_program;
  QString m_profile;
  QProcess *m_process = nullptr;
  LspMessages m_messages;
  QJsonObject m_capabilities;
  QStringList m_tokenTypes;
  bool m_ready = false;

  QString m_uri, m_openUri; ///< the wanted text's, and that of the one that the server has open
  QString m_text;
  qint64 m_revision = -1;
  qint64 m_sentRevision = -1;
  qint64 m_heldRevision = -1; ///< the text that ended the server too often
  int m_deaths = 0;           ///< since a text was last answered

  int m_nextId = 1;
  QHash<int, Waiting> m_waiting;
  QTimer m_watchdog;
  QTimer m_restart;
};

} // namespace arbiter::builder
