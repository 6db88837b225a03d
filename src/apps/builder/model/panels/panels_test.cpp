#include <QJsonDocument>
#include <cmath>

#include "apps/builder/model/panels/parameters.h"
#include "apps/builder/model/panels/textures.h"
#include "apps/builder/model/panels/trace.h"
#include "apps/builder/model/panels/words.h"
#include "apps/builder/testing/model_test.h"

namespace arbiter::builder {

namespace {

const QString kText = QString::fromUtf8("!!ARBfp1.0\n"
                                        "# gr\xc3\xb6\xc3\x9f"
                                        "er\n"
                                        "#@ local[0].x \"amount\" = 0.5 in 0..2 animate sine 5s\n"
                                        "#@ local[1] \"tint\" = 1 0.5 0.25 1 color\n"
                                        "#@ texture 0 = checker 64 64 cells 4, nearest, edge\n"
                                        "MOV result.color, program.local[0];\nEND\n");

} // namespace

TEST(Parameters, AreReadWithTheirPlaces) {
  Document document;
  document.open(kText);
  Parameters parameters(document);
  ASSERT_EQ(parameters.lines().size(), 2);
  const ParameterLine &amount = parameters.lines()[0];
  EXPECT_EQ(amount.label, QStringLiteral("amount"));
  EXPECT_EQ(amount.high, 2);
  EXPECT_TRUE(amount.animation.startsWith(QStringLiteral("sine")));
  ASSERT_EQ(amount.components.size(), 1);
  EXPECT_EQ(kText.mid(amount.components[0].at, amount.components[0].length), QStringLiteral("0.5"))
      << "letters of two bytes stand before it";
  EXPECT_TRUE(parameters.lines()[1].color);
}

TEST(Parameters, ADragChangesNoTextAndItsReleaseOneNumber) {
  Document document;
  document.open(kText);
  Parameters parameters(document);
  for (double value : {0.6, 0.7, 1.25})
    parameters.drag(0, 0, value);
  EXPECT_EQ(document.text(), kText);
  QString expected = kText;
  expected.replace(QStringLiteral("= 0.5 in"), QStringLiteral("= 1.25 in"));
  EXPECT_EQ(parameters.liveText(), expected);
  parameters.release();
  EXPECT_EQ(document.text(), expected);
  EXPECT_EQ(document.undoName(), QStringLiteral("move amount"));
  document.undo();
  EXPECT_EQ(document.text(), kText);
  EXPECT_FALSE(document.canUndo());
}

TEST(Parameters, AColorIsOneStep) {
  Document document;
  document.open(kText);
  Parameters parameters(document);
  parameters.set(1, {0.125, 1, 0.75});
  EXPECT_TRUE(document.text().contains(QStringLiteral("= 0.125 1 0.75 1 color")));
  document.undo();
  EXPECT_EQ(document.text(), kText);
}

TEST(Parameters, ATextThatChangesMeanwhileLetsGo) {
  Document document;
  document.open(kText);
  Parameters parameters(document);
  parameters.drag(0, 0, 1.5);
  document.replace(0, 0, QStringLiteral("x"), Origin::Typing);
  EXPECT_FALSE(parameters.isHeld());
  parameters.release();
  EXPECT_EQ(document.text(), u'x' + kText);
  parameters.drag(99, 0, 1);
  parameters.drag(0, 99, 1);
  EXPECT_FALSE(parameters.isHeld());
}

TEST(Textures, AreReadAndSet) {
  const QList<TextureLine> lines = texturesOf(kText);
  ASSERT_EQ(lines.size(), 1);
  EXPECT_EQ(lines[0].source, QStringLiteral("checker 64 64 cells 4"));
  EXPECT_EQ(lines[0].filter, QStringLiteral("nearest"));
  const auto applied = [](QString text, const Edit &edit) {
    EXPECT_EQ(text.mid(edit.at, edit.removed.size()), edit.removed);
    return text.replace(edit.at, edit.removed.size(), edit.added);
  };
  const QString other = applied(kText, setTexture(kText, 0, QStringLiteral("noise 32 32")));
  EXPECT_TRUE(other.contains(QStringLiteral("#@ texture 0 = noise 32 32, nearest, edge\n")));
  const QString more = applied(kText, setTexture(kText, 3, QStringLiteral("clouds 64 64")));
  ASSERT_EQ(texturesOf(more).size(), 2);
  EXPECT_EQ(texturesOf(more)[1].unit, 3);
  EXPECT_GT(generators().size(), 8);
}

TEST(Words, AreTheTables) {
  int opcodes = 0;
  for (const Word &word : allWords()) {
    opcodes += word.kind == WordKind::Opcode;
    EXPECT_FALSE(word.word.isEmpty());
    EXPECT_FALSE(word.doc.isEmpty()) << word.word.toStdString();
  }
  EXPECT_EQ(opcodes, fp::ir::kOpcodeCount);
  EXPECT_EQ(searchWords(QStringLiteral("mad"))[0].word, QStringLiteral("MAD"));
  EXPECT_EQ(searchWords(QStringLiteral("mad"))[0].formula, QStringLiteral("a*b + c"));
  EXPECT_EQ(searchWords(QStringLiteral("twirl"))[0].kind, WordKind::Panel);
  EXPECT_TRUE(searchWords(QStringLiteral("no such word")).isEmpty());
}

TEST(Trace, StepsBothWaysAndFindsWhatIsMarked) {
  const QByteArray json = R"({"trace": {"numerics": "host", "second_numerics": "fp24",
    "attributes": [{"name": "fragment.texcoord[0]", "value": [0.5, 0.25, 0, 1]}], "parameters": [],
    "rows": [
     {"line": 3, "text": "RCP t.x, a.x", "opcode": "RCP", "destination": "t.x", "register": "t", "mask": "x",
      "value": ["inf", 0, 0, 0], "operands": [{"text": "a.x", "value": [0, 0, 0, 0]}],
      "flags": ["inf"], "error": 0},
     {"line": 4, "text": "MUL t, t, 0", "opcode": "MUL", "destination": "t", "register": "t", "mask": "xyzw",
      "value": ["nan", 0, 0, 0], "operands": [], "flags": ["nan"], "error": "nan"},
     {"line": 6, "text": "MOV result.color, t", "opcode": "MOV", "destination": "o", "register": "result.color",
      "mask": "xyzw", "value": [1, 0.5, 0, 1], "second": [1, 0.499, 0, 1], "operands": [],
      "flags": [], "error": 0.001}],
    "results": [], "discarded": false},
    "verdict": {"line": "swrast drew ff8000ff: equal", "equal": true}})";
  Trace trace;
  ASSERT_TRUE(trace.take(QJsonDocument::fromJson(json).object()));
  EXPECT_EQ(trace.rows().size(), 3);
  EXPECT_EQ(trace.current(), 0);
  EXPECT_TRUE(std::isinf(trace.rows()[0].value.value[0]));
  EXPECT_EQ(trace.rows()[0].value.text(QStringLiteral("x")), QStringLiteral("inf"));
  EXPECT_EQ(trace.rows()[2].value.color(), QColor::fromRgbF(1, 0.5F, 0));
  EXPECT_EQ(trace.rows()[0].value.color(), QColor(Qt::black));
  trace.step(1);
  trace.step(1);
  trace.step(1);
  EXPECT_EQ(trace.current(), 2);
  const auto registers = trace.registers();
  ASSERT_EQ(registers.size(), 2);
  EXPECT_EQ(registers[0].first, QStringLiteral("result.color"));
  EXPECT_EQ(registers[1].first, QStringLiteral("t")) << "spelt with a mask and without";
  EXPECT_TRUE(std::isnan(registers[1].second.value[0])) << "the last value that it had";
  trace.step(-2);
  EXPECT_EQ(trace.registers().size(), 1);
  EXPECT_TRUE(trace.nextFlag(QStringLiteral("nan")));
  EXPECT_EQ(trace.current(), 1);
  EXPECT_FALSE(trace.nextFlag(QStringLiteral("over-one")));
  trace.runToLine(5);
  EXPECT_EQ(trace.current(), 2);
  EXPECT_TRUE(trace.isEqual());
  EXPECT_FALSE(trace.take({}));
  EXPECT_EQ(trace.rows().size(), 3) << "what is no trace took one away";
}

} // namespace arbiter::builder
