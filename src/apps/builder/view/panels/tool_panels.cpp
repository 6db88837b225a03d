#include "apps/builder/view/panels/tool_panels.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QFontDatabase>
#include <QLabel>
#include <QPushButton>

#include "apps/builder/model/panels/utf_map.h"

namespace arbiter::builder {

namespace {

QVBoxLayout *columnOf(QWidget *panel) {
  auto *layout = new QVBoxLayout(panel);
  layout->setContentsMargins(6, 4, 6, 4);
  return layout;
}

QString costText(const QJsonValue &cost) {
  return QObject::tr("%1 ALU, %2 TEX, %3 nodes")
      .arg(cost[u"alu"].toInt())
      .arg(cost[u"tex"].toInt())
      .arg(cost[u"nodes"].toInt());
}

} // namespace

NativePanel::NativePanel(Workbench &bench) : m_bench(bench), m_tool(bench.places().arbiter) {
  QVBoxLayout *layout = columnOf(this);
  auto *what = new QComboBox;
  what->setAccessibleName(tr("What the compiler is to show"));
  what->addItem(tr("native: as the card runs it"), QStringLiteral("native"));
  what->addItem(tr("ir: the checked program"), QStringLiteral("ir"));
  what->addItem(tr("glsl: for the host"), QStringLiteral("glsl"));
  what->addItem(tr("assembly: plain text"), QStringLiteral("assembly"));
  what->addItem(tr("machine: the rasterizer's code"), QStringLiteral("machine"));
  m_text = new QPlainTextEdit;
  m_text->setReadOnly(true);
  m_text->setTabChangesFocus(true);
  m_text->setLineWrapMode(QPlainTextEdit::NoWrap);
  m_text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  m_text->setAccessibleName(tr("Output of the compiler"));
  layout->addWidget(what);
  layout->addWidget(m_text, 1);
  connect(what, &QComboBox::currentIndexChanged, this, [this, what] {
    m_emit = what->currentData().toString();
    refresh();
  });
  connect(&bench, &Workbench::reportChanged, this, [this] {
    if (isVisible())
      refresh();
  });
}

void NativePanel::showEvent(QShowEvent *event) {
  QWidget::showEvent(event);
  refresh();
}

void NativePanel::refresh() {
  QStringList words{QStringLiteral("compile"), QStringLiteral("--emit"), m_emit,
                    QStringLiteral("@")};
  if (const QString &profile = m_bench.renderer().options().profile; !profile.isEmpty())
    words << QStringLiteral("--profile") << profile;
  m_tool.run(words, m_bench.scene(), [this](const ToolResult &result) {
    const QString text = QString::fromUtf8(result.output);
    m_text->setPlainText(text.isEmpty() ? result.complaint : text);
  });
}

AdvicePanel::AdvicePanel(Workbench &bench) : m_bench(bench), m_tool(bench.places().arbiter) {
  QVBoxLayout *layout = columnOf(this);
  m_summary = new QLabel;
  m_summary->setWordWrap(true);
  m_table = new Table({tr("Line"), tr("Advice"), tr("Program before"), tr("and after")});
  m_table->setAccessibleName(tr("Advice"));
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  layout->addWidget(m_summary);
  layout->addWidget(m_table, 1);
  connect(m_table, &QTableWidget::cellActivated, this, [this](int row) { apply(row); });
  connect(&bench, &Workbench::reportChanged, this, [this] {
    if (isVisible())
      refresh();
  });
}

void AdvicePanel::showEvent(QShowEvent *event) {
  QWidget::showEvent(event);
  refresh();
}

void AdvicePanel::refresh() {
  QStringList words{QStringLiteral("check"), QStringLiteral("--advise"), QStringLiteral("--json"),
                    QStringLiteral("@")};
  if (const QString &profile = m_bench.renderer().options().profile; !profile.isEmpty())
    words << QStringLiteral("--profile") << profile;
  const qint64 revision = m_bench.document().revision();
  m_tool.run(words, m_bench.scene(), [this, revision](const ToolResult &result) {
    m_revision = revision;
    if (result.json().isEmpty()) {
      m_proposals.clear();
      m_table->setRowCount(0);
      m_summary->setText(result.complaint.isEmpty() ? tr("no advice: the command said nothing")
                                                    : result.complaint);
      return;
    }
    const int count = take(result.json());
    m_summary->setText(count == 0 ? tr("Nothing would make this program cheaper on its card.")
                                  : tr("%n way(s) to make the program cheaper; Return applies one "
                                       "that is a change of the text.",
                                       nullptr, count));
  });
}

int AdvicePanel::take(const QJsonObject &json) {
  m_proposals.clear();
  const QJsonValue file = json[u"files"][0];
  const UtfMap map(m_bench.document().text());
  for (const QJsonValue each : file[u"advice"].toArray()) {
    Proposal proposal;
    proposal.title = each[u"message"].toString();
    if (const QString what = each[u"application"].toString(); !what.isEmpty())
      proposal.title += tr(", if the application %1").arg(what);
    if (const QString what = each[u"condition"].toString(); !what.isEmpty())
      proposal.title += tr(", if %1").arg(what);
    proposal.line = each[u"line"].toInt(1);
    proposal.saves = costText(each[u"before"]);
    proposal.why = costText(each[u"after"]);
    for (const QJsonValue edit : each[u"edits"].toArray()) {
      const qsizetype begin = map.unit(std::uint32_t(edit[u"begin"].toInteger()));
      const qsizetype end = map.unit(std::uint32_t(edit[u"end"].toInteger()));
      proposal.edits.prepend(
          {begin, m_bench.document().text().mid(begin, end - begin), edit[u"text"].toString()});
    }
    m_proposals << proposal;
  }
  m_table->setRowCount(int(m_proposals.size()));
  for (int row = 0; row < m_proposals.size(); ++row) {
    const Proposal &proposal = m_proposals[row];
    m_table->put(row, 0, QString::number(proposal.line));
    m_table->put(row, 1, proposal.title)->setToolTip(proposal.title);
    m_table->put(row, 2, proposal.saves);
    m_table->put(row, 3, proposal.why);
  }
  return int(m_proposals.size());
}

/// Applies an advice. It belongs to one revision: in another its places may be wrong.
void AdvicePanel::apply(int row) {
  if (row < 0 || row >= m_proposals.size() || m_revision != m_bench.document().revision())
    return;
  if (m_proposals[row].edits.isEmpty())
    m_summary->setText(tr("This is the application's to do: it is no change of the text."));
  else
    m_bench.document().apply(m_proposals[row].edits, m_proposals[row].title);
}

BenchPanel::BenchPanel(Workbench &bench) : m_bench(bench) {
  QVBoxLayout *layout = columnOf(this);
  auto *row = new QHBoxLayout;
  m_run = new QPushButton(tr("Draw 200 frames"));
  row->addWidget(m_run);
  row->addStretch();
  m_table = new Table({tr("Revision"), tr("Profile, numerics, back end"), tr("Frames"),
                       tr("ms a frame, median"), tr("Frames a second")});
  m_table->setAccessibleName(tr("Benchmarks"));
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  layout->addLayout(row);
  layout->addWidget(m_table, 1);
  connect(m_run, &QPushButton::clicked, this, [this] { run(); });
  m_run->setObjectName(QStringLiteral("bench-run"));
  connect(&bench.renderer(), &RendererSession::restarted, this,
          [this] { m_run->setEnabled(true); }); // the run ended with the process
  connect(&bench.renderer(), &RendererSession::benched, this,
          [this](int frames, double milliseconds, double median) {
            m_run->setEnabled(true);
            const RenderOptions &options = m_bench.renderer().options();
            m_table->insertRow(0);
            m_table->put(0, 0, QString::number(m_bench.document().revision()));
            m_table->put(0, 1,
                         QStringList{options.profile, options.numerics, options.backend}
                             .join(u' ')
                             .simplified());
            m_table->put(0, 2, QString::number(frames));
            m_table->put(0, 3, QString::number(median, 'f', 3));
            m_table->put(0, 4,
                         milliseconds > 0 ? QString::number(frames * 1000.0 / milliseconds, 'f', 0)
                                          : QString());
          });
}

void BenchPanel::run() {
  constexpr int kFrames = 200;
  if (m_bench.renderer().bench(kFrames))
    m_run->setEnabled(false);
  else
    Q_EMIT m_bench.notice(tr("this renderer draws one frame a process: there is nothing to time"));
}

} // namespace arbiter::builder
