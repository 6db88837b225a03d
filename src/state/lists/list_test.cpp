// Tests what the host gets of display lists, in which order.
#include <algorithm>

#include <gtest/gtest.h>

#include "state/host_draw/linking/host_assembly.h"
#include "state/lists/list_compiler.h"
#include "state/mirror/dirty_bits.h"
#include "state/raster_draw/commands.h"
#include "state/raster_draw/context_state.h"
#include "state/testing/current_context.h"
#include "state/testing/keeping_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

constexpr GLuint kTop = DisplayListTable::kTop;
std::string newList(GLuint name, GLenum mode = GL_COMPILE) {
  return "NewList " + std::to_string(name) + " " + std::to_string(mode);
}

TEST(Lists, WithoutTheProgramApiListsAreTheHosts) {
  FakeHost host;
  const CurrentContext context(host);
  host.calls.clear();
  handlers::NewList(*context, 1, GL_COMPILE);
  handlers::CallList(*context, 2);
  handlers::PushAttrib(*context, GL_ALL_ATTRIB_BITS);
  handlers::PopAttrib(*context);
  handlers::EndList(*context);
  EXPECT_EQ(host.calls, (std::vector<std::string>{newList(1), "CallList 2", "EndList"}));
  EXPECT_TRUE(context->group->lists.empty());
}

TEST(Lists, ACommandCutsTheList) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kKeepingText);
  host.calls.clear();
  handlers::NewList(*context, 1, GL_COMPILE);
  handlers::Begin(*context, GL_POINTS);
  handlers::End(*context);
  handlers::ProgramEnvParameter4fARB(*context, kFragment, 0, 1, 0, 0, 1);
  handlers::Begin(*context, GL_LINES);
  handlers::End(*context);
  handlers::EndList(*context);
  EXPECT_EQ(host.calls, (std::vector<std::string>{newList(1), "Begin 0", "EndList", newList(kTop),
                                                  "Begin 1", "EndList"}));
  EXPECT_EQ(context->row(Target::Fragment).env[0][0], 0.0f) << "COMPILE executed";
  EXPECT_FALSE(context->insideBeginEnd) << "a recorded Begin opens nothing";
  host.calls.clear();
  handlers::CallList(*context, 1);
  EXPECT_EQ(context->row(Target::Fragment).env[0][0], 1.0f);
  EXPECT_EQ(host.count("CallList"), 2);
  EXPECT_LT(std::find(host.calls.begin(), host.calls.end(), "CallList 1"),
            std::find(host.calls.begin(), host.calls.end(), "CallList " + std::to_string(kTop)));
}

TEST(Lists, NothingOfOursIsEverRecorded) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kKeepingText);
  handlers::ProgramEnvParameter4fARB(*context, kFragment, 0, 1, 1, 1, 1);
  for (const GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE}) {
    handlers::NewList(*context, 1, mode);
    EXPECT_TRUE(draw(*context));
    handlers::ProgramEnvParameter4fARB(*context, kFragment, 0, 2, 2, 2, GLfloat(mode));
    EXPECT_TRUE(draw(*context));
    load(*context, "!!ARBfp1.0\nADD result.color, program.env[0], 1;\nEND");
    EXPECT_TRUE(draw(*context));
    handlers::restoreApplicationProgram(*context);
    EXPECT_TRUE(draw(*context));
    handlers::EndList(*context);
    load(*context, kKeepingText);
  }
  EXPECT_TRUE(host.recorded.empty()) << host.recorded.front();
}

TEST(Lists, CompileAndExecuteBindsBeforeTheHostRecords) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kKeepingText);
  host.calls.clear();
  handlers::NewList(*context, 1, GL_COMPILE_AND_EXECUTE);
  ASSERT_FALSE(host.calls.empty());
  EXPECT_EQ(host.calls.back(), newList(1, GL_COMPILE_AND_EXECUTE));
  EXPECT_NE(host.currentProgram, 0u);
  EXPECT_EQ(handlers::GetError(*context), GLenum(GL_NO_ERROR));
  handlers::EndList(*context);
}

TEST(Lists, SegmentNamesAreReusedAndNamesInUseArePassedOver) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kKeepingText);
  host.lists.insert(kTop); // the application's own
  const auto compile = [&] {
    handlers::NewList(*context, 1, GL_COMPILE);
    handlers::ProgramEnvParameter4fARB(*context, kFragment, 0, 1, 0, 0, 1);
    handlers::Begin(*context, GL_POINTS);
    handlers::End(*context);
    handlers::EndList(*context);
  };
  for (int i = 0; i < 10; ++i)
    compile();
  EXPECT_EQ(host.lists, (std::set<GLuint>{1, kTop, *std::next(host.lists.begin())}))
      << "segments of replaced lists pile up";
  EXPECT_EQ(host.lists.size(), 3u);
  handlers::DeleteLists(*context, 1, 1);
  EXPECT_EQ(host.lists, (std::set<GLuint>{kTop}));
  EXPECT_TRUE(context->group->lists.empty());
}

TEST(Lists, RecursionEnds) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kKeepingText);
  handlers::NewList(*context, 1, GL_COMPILE);
  handlers::CallList(*context, 1);
  handlers::EndList(*context);
  host.calls.clear();
  handlers::CallList(*context, 1);
  EXPECT_EQ(host.count("CallList 1"), ListCompiler::kMaxDepth);
  EXPECT_EQ(context->listDepth, 0);
}

TEST(Lists, CallListsDecodesEveryType) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kKeepingText);
  handlers::NewList(*context, 300, GL_COMPILE);
  handlers::Disable(*context, kFragment);
  handlers::EndList(*context);
  host.integers[GL_LIST_BASE] = 44;
  const auto calls = [&](GLenum type, const void *names) {
    handlers::Enable(*context, kFragment);
    handlers::CallLists(*context, 1, type, names);
    return !context->row(Target::Fragment).enabled;
  };
  const GLubyte twoBytes[] = {1, 0}, fourBytes[] = {0, 0, 1, 0}, threeBytes[] = {0, 1, 0};
  const GLshort shorts[] = {256};
  const GLint ints[] = {256};
  const GLfloat floats[] = {256.75f};
  const GLbyte bytes[] = {-100};
  EXPECT_TRUE(calls(GL_2_BYTES, twoBytes));
  EXPECT_TRUE(calls(GL_3_BYTES, threeBytes));
  EXPECT_TRUE(calls(GL_4_BYTES, fourBytes));
  EXPECT_TRUE(calls(GL_SHORT, shorts));
  EXPECT_TRUE(calls(GL_UNSIGNED_INT, ints));
  EXPECT_TRUE(calls(GL_FLOAT, floats));
  EXPECT_FALSE(calls(GL_BYTE, bytes));
  host.integers[GL_LIST_BASE] = 400;
  EXPECT_TRUE(calls(GL_BYTE, bytes));
}

TEST(Lists, APrimitiveLeftOpenIsFollowed) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kKeepingText);
  handlers::NewList(*context, 1, GL_COMPILE);
  handlers::Begin(*context, GL_LINES);
  handlers::EndList(*context);
  handlers::NewList(*context, 2, GL_COMPILE);
  handlers::End(*context);
  handlers::EndList(*context);
  handlers::NewList(*context, 3, GL_COMPILE);
  handlers::ProgramEnvParameter4fARB(*context, kFragment, 0, 1, 0, 0, 1);
  handlers::EndList(*context);
  EXPECT_FALSE(context->insideBeginEnd) << "nothing was executed yet";
  handlers::CallList(*context, 1);
  EXPECT_TRUE(context->insideBeginEnd);
  handlers::CallList(*context, 3);
  EXPECT_EQ(context->row(Target::Fragment).env[0][0], 0.0f) << "between Begin and End";
  handlers::CallList(*context, 2);
  EXPECT_FALSE(context->insideBeginEnd);
  EXPECT_EQ(handlers::GetError(*context), GLenum(GL_INVALID_OPERATION));
}

TEST(Lists, PushesCutOnlyWhereACommandOfOursIsBeforeThePop) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kKeepingText);
  handlers::NewList(*context, 1, GL_COMPILE);
  handlers::PushAttrib(*context, GL_ENABLE_BIT);
  handlers::PopAttrib(*context);
  handlers::EndList(*context);
  EXPECT_TRUE(context->group->lists.empty()) << "a balanced pair stays the host's";
  handlers::NewList(*context, 2, GL_COMPILE);
  handlers::PushAttrib(*context, GL_ENABLE_BIT);
  handlers::PushAttrib(*context, GL_LIGHTING_BIT);
  handlers::Disable(*context, kFragment);
  handlers::PopAttrib(*context);
  handlers::PopAttrib(*context);
  handlers::EndList(*context);
  handlers::NewList(*context, 3, GL_COMPILE);
  handlers::PushAttrib(*context, GL_ENABLE_BIT);
  handlers::EndList(*context);
  EXPECT_EQ(context->attribStack.depth(), 0u);
  handlers::CallList(*context, 2);
  EXPECT_TRUE(context->row(Target::Fragment).enabled);
  EXPECT_EQ(context->attribStack.depth(), 0u);
  handlers::CallList(*context, 3);
  EXPECT_EQ(context->attribStack.depth(), 1u) << "pushed by a list, to be popped by others";
  handlers::Disable(*context, kFragment);
  handlers::PopAttrib(*context);
  EXPECT_TRUE(context->row(Target::Fragment).enabled);
}

TEST(Lists, TheHostRefusesDrawsWhileTheProgramIsNotValid) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kKeepingText);
  handlers::BindProgramARB(*context, kFragment, 0);
  host.calls.clear();
  handlers::CallList(*context, 1);
  const std::string enable = "Enable " + std::to_string(kFragment);
  const auto called = std::find(host.calls.begin(), host.calls.end(), "CallList 1");
  EXPECT_NE(std::find(host.calls.begin(), called, enable), called);
  EXPECT_FALSE(context->hostSide.assembly->active()) << "left enabled on the host";
  EXPECT_EQ(host.currentProgram, 0u);
}

TEST(Lists, FeedbackCopiesAreCountedWhenExecuted) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kKeepingText);
  handlers::NewList(*context, 1, GL_COMPILE);
  handlers::CopyTexSubImage2D(*context, GL_TEXTURE_2D, 0, 0, 0, 0, 0, 8, 8);
  handlers::EndList(*context);
  EXPECT_EQ(context->counters.feedback.copies(), 0u);
  handlers::CallList(*context, 1);
  handlers::CallList(*context, 1);
  EXPECT_EQ(context->counters.feedback.copies(), 2u);
  handlers::CopyTextureSubImage2DEXT(*context, 7, GL_TEXTURE_2D, 0, 0, 0, 0, 0, 8, 8);
  handlers::CopyTextureSubImage2D(*context, 7, 0, 0, 0, 0, 0, 8, 8);
  handlers::CopyMultiTexSubImage2DEXT(*context, GL_TEXTURE0, GL_TEXTURE_2D, 0, 0, 0, 0, 0, 8, 8);
  EXPECT_EQ(context->counters.feedback.copies(), 5u);
}

TEST(Lists, PrimitivesAreKeptFromTheHost) {
  FakeHost host;
  KeepingContext context(host);
  handlers::NewList(*context, 1, GL_COMPILE);
  point(*context);
  point(*context);
  EXPECT_TRUE(host.calls.empty()) << host.calls.front();
  EXPECT_FALSE(context->insideBeginEnd);
  handlers::EndList(*context);
  EXPECT_EQ(host.calls, (std::vector<std::string>{newList(1), "EndList"})) << "the name alone";
  const auto list = context->group->lists.find(1);
  ASSERT_TRUE(list);
  ASSERT_EQ(list->items.size(), 1u) << "points go together";
  EXPECT_EQ(list->items[0].geometry->count, 2u);

  context.leaveToHost(host);
  const std::string top = std::to_string(kTop);
  for (int i = 0; i < 2; ++i)
    handlers::CallList(*context, 1);
  EXPECT_EQ(host.count(newList(kTop)), 1) << "made once";
  EXPECT_EQ(host.count("CallList " + top), 2);
  handlers::DeleteLists(*context, 1, 1);
  EXPECT_TRUE(host.lists.empty()) << "what it was drawn with is deleted too";
}

TEST(Lists, WhatIsSetBehindTheLastVertexIsCurrentThoughTheHostDraws) {
  for (const bool behind : {false, true}) {
    FakeHost host;
    KeepingContext context(host);
    handlers::NewList(*context, 1, GL_COMPILE);
    handlers::Begin(*context, GL_POINTS);
    context->recorder->set(kColor, 1, 0, 0, 1);
    context->recorder->vertex(1, 2, 0, 1);
    if (behind)
      context->recorder->set(kColor, 0, 1, 0, 1);
    handlers::End(*context);
    handlers::EndList(*context);
    context.leaveToHost(host);
    handlers::CallList(*context, 1);
    const auto called =
        std::find(host.calls.begin(), host.calls.end(), "CallList " + std::to_string(kTop));
    ASSERT_NE(called, host.calls.end());
    const auto after = std::count_if(called, host.calls.end(), [](const std::string &call) {
      return call.starts_with("Color4fv");
    });
    EXPECT_EQ(after, behind ? 1 : 0);
  }
}

TEST(Lists, PrimitivesThatAreExecutedTooAreDrawnOutsideOfTheHostsLists) {
  FakeHost host;
  KeepingContext context(host);
  handlers::NewList(*context, 1, GL_COMPILE_AND_EXECUTE);
  handlers::Begin(*context, GL_POINTS);
  EXPECT_TRUE(context->insideBeginEnd);
  ASSERT_NE(context->recorder, nullptr);
  context->recorder->vertex(1, 2, 0, 1);
  handlers::End(*context);
  EXPECT_FALSE(context->insideBeginEnd);
  EXPECT_EQ(host.count("Begin 0"), 1) << "drawn at once";
  handlers::Enable(*context, GL_BLEND);
  point(*context);
  handlers::EndList(*context);
  EXPECT_EQ(host.count("Begin 0"), 2);
  EXPECT_EQ(std::count(host.recorded.begin(), host.recorded.end(), "Begin 0"), 0);
  const auto list = context->group->lists.find(1);
  ASSERT_TRUE(list);
  ASSERT_EQ(list->items.size(), 3u);
  EXPECT_EQ(list->items[0].geometry->count, 1u);
  EXPECT_FALSE(list->items[1].effects.pixels);
  EXPECT_EQ(list->items[1].effects.dirty, dirty::kPixelOps);
  EXPECT_EQ(list->items[2].geometry->count, 1u);
}

TEST(Lists, APrimitiveThatIsExecutedAndInterruptedIsTheHosts) {
  FakeHost host;
  KeepingContext context(host);
  handlers::NewList(*context, 1, GL_COMPILE_AND_EXECUTE);
  handlers::Begin(*context, GL_LINES);
  ASSERT_NE(context->recorder, nullptr);
  context->recorder->vertex(1, 2, 0, 1);
  handlers::Enable(*context, GL_BLEND); // an error, for the host to raise
  EXPECT_TRUE(context->insideBeginEnd);
  EXPECT_EQ(context->recorder, nullptr);
  EXPECT_EQ(context->host, host.table());
  handlers::BindProgramARB(*context, kFragment, 0);
  EXPECT_EQ(handlers::GetError(*context), GLenum(GL_NO_ERROR)) << "inside Begin/End";
  handlers::End(*context);
  EXPECT_FALSE(context->insideBeginEnd);
  EXPECT_EQ(handlers::GetError(*context), GLenum(GL_INVALID_OPERATION));
  handlers::EndList(*context);
  const auto list = context->group->lists.find(1);
  ASSERT_TRUE(list);
  ASSERT_EQ(list->items.size(), 1u);
  EXPECT_EQ(list->items[0].hostList, 1u);
  EXPECT_TRUE(list->items[0].effects.pixels);
}

TEST(Lists, WhatIsBetweenPrimitivesTellsWhatItChanges) {
  FakeHost host;
  const KeepingContext context(host);
  context->dirty = 0;
  handlers::NewList(*context, 1, GL_COMPILE);
  point(*context);
  handlers::Enable(*context, GL_BLEND);
  point(*context);
  handlers::EndList(*context);
  const auto list = context->group->lists.find(1);
  ASSERT_TRUE(list);
  ASSERT_EQ(list->items.size(), 3u);
  EXPECT_EQ(list->items[1].hostList, kTop);
  EXPECT_EQ(list->items[1].effects.dirty, dirty::kPixelOps);
  EXPECT_FALSE(list->items[1].effects.pixels);
}

/// The host would draw lists that are not known to be empty.
TEST(Lists, ThoseOfGenListsAreEmptyUntilTheyAreCompiled) {
  FakeHost host;
  const KeepingContext context(host);
  context->group->lists.noteEmpty(5, 3);
  handlers::NewList(*context, 6, GL_COMPILE);
  point(*context);
  handlers::EndList(*context);
  host.calls.clear();
  handlers::CallList(*context, 5);
  EXPECT_EQ(host.count("CallList"), 0);
  EXPECT_EQ(context->group->lists.find(6)->items.size(), 1u);
  handlers::DeleteLists(*context, 5, 1);
  handlers::CallList(*context, 5);
  EXPECT_EQ(host.count("CallList 5"), 1) << "the host's to say, as of any name";
}

TEST(Lists, RectanglesArePrimitives) {
  FakeHost host;
  const KeepingContext context(host);
  handlers::NewList(*context, 1, GL_COMPILE);
  EXPECT_TRUE(tryRectangle(*context, 1, 2, 3, 4));
  EXPECT_TRUE(tryRectangle(*context, 1, 2, 3, 4));
  handlers::Begin(*context, GL_LINES);
  EXPECT_FALSE(tryRectangle(*context, 1, 2, 3, 4)) << "an error, and the host's";
  handlers::EndList(*context);
  const auto list = context->group->lists.find(1);
  ASSERT_EQ(list->items.size(), 2u);
  EXPECT_EQ(list->items[0].geometry->count, 8u);
  EXPECT_TRUE(list->items[1].geometry->open);
}

TEST(Lists, APrimitiveThatGoesOnElsewhereIsBegunAsTheApplicationWould) {
  FakeHost host;
  KeepingContext context(host);
  handlers::NewList(*context, 1, GL_COMPILE);
  handlers::Begin(*context, GL_LINES);
  ASSERT_NE(context->recorder, nullptr);
  context->recorder->vertex(1, 2, 0, 1);
  handlers::EndList(*context);
  EXPECT_EQ(context->host, host.table());
  EXPECT_EQ(context->recorder, nullptr);
  const auto open = context->group->lists.find(1);
  ASSERT_EQ(open->items.size(), 1u);
  EXPECT_TRUE(open->items[0].geometry->open);
  handlers::NewList(*context, 2, GL_COMPILE); // and one that calls another within it
  handlers::Begin(*context, GL_LINES);
  handlers::CallList(*context, 1);
  handlers::End(*context);
  handlers::EndList(*context);
  const auto nests = context->group->lists.find(2);
  ASSERT_EQ(nests->items.size(), 3u);
  EXPECT_TRUE(nests->items[0].geometry->open);
  EXPECT_TRUE(nests->items[1].command);
  EXPECT_EQ(nests->items[2].primitive, Primitive::Closed);

  context.leaveToHost(host);
  handlers::CallList(*context, 1);
  EXPECT_TRUE(context->insideBeginEnd);
  EXPECT_EQ(host.count("Begin " + std::to_string(GL_LINES)), 1)
      << "the host's lists lose vertices of such primitives";
  handlers::End(*context);
  EXPECT_FALSE(context->insideBeginEnd);
}

} // namespace
} // namespace arbiter::state
