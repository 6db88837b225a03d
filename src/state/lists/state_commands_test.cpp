// Tests state that a list sets between kept primitives.
#include <array>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/handlers.h"
#include "state/lists/known_state.h"
#include "state/lists/list_compiler.h"
#include "state/lists/state_commands.h"
#include "state/mirror/dirty_bits.h"
#include "state/testing/keeping_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

constexpr std::array<GLfloat, 4> kRedMaterial = {1, 0, 0, 1}, kGreenMaterial = {0, 1, 0, 1};

class StateCommands : public ::testing::Test {
protected:
  /// Does what the entry point does. Returns true if the layer keeps the command or leaves it out.
  bool material(const std::array<GLfloat, 4> &value, GLenum pname = GL_DIFFUSE,
                GLenum face = GL_FRONT) {
    return recordMaterial(*m_context, face, pname, value.data());
  }
  void texture(GLuint name) { handlers::BindTexture(*m_context, GL_TEXTURE_2D, name); }
  const std::vector<DisplayList::Item> &compiled(const std::function<void()> &commands) {
    handlers::NewList(*m_context, 1, GL_COMPILE);
    commands();
    handlers::EndList(*m_context);
    m_list = m_context->group->lists.find(1);
    return m_list->items;
  }
  static std::size_t commandsOf(const DisplayList::Item &item) {
    return item.command ? item.command->bytes.size() / sizeof(StateCommand) : 0;
  }

  FakeHost m_host;
  KeepingContext m_context{m_host};
  std::shared_ptr<const DisplayList> m_list;
};

TEST_F(StateCommands, WhatIsSetAlreadyIsLeftOutAndPrimitivesAreOne) {
  const auto &items = compiled([&] {
    for (int i = 0; i < 5; ++i) {
      EXPECT_TRUE(material(kRedMaterial));
      EXPECT_TRUE(material({27.8f}, GL_SHININESS));
      texture(2);
      point(*m_context);
    }
  });
  ASSERT_EQ(items.size(), 2u);
  EXPECT_EQ(commandsOf(items[0]), 3u) << "a run of them is an item";
  using namespace dirty;
  EXPECT_EQ(items[0].effects.dirty, kMaterial | kProgramState | kTextureBindings);
  EXPECT_EQ(items[1].geometry->count, 5u);
  EXPECT_EQ(m_host.count("NewList"), 1) << "the name alone, and no list for each run";
}

TEST_F(StateCommands, WhatChangesIsKept) {
  const auto &items = compiled([&] {
    for (const auto &value : {kRedMaterial, kGreenMaterial, kGreenMaterial}) {
      EXPECT_TRUE(material(value));
      texture(2);
      point(*m_context);
    }
  });
  ASSERT_EQ(items.size(), 4u);
  EXPECT_EQ(commandsOf(items[0]), 2u);
  EXPECT_EQ(commandsOf(items[2]), 1u) << "the texture is bound";
  EXPECT_EQ(items[3].geometry->count, 2u);
}

/// FRONT_AND_BACK and AMBIENT_AND_DIFFUSE name several.
TEST_F(StateCommands, FacesAndParametersOverlap) {
  KnownState known;
  const auto sets = [&](GLenum face, GLenum pname, const std::array<GLfloat, 4> &value) {
    return known.set({.target = face, .pname = pname, .values = value});
  };
  EXPECT_TRUE(sets(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, kRedMaterial));
  for (const GLenum face : {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK})
    for (const GLenum pname : {GL_AMBIENT, GL_DIFFUSE, GL_AMBIENT_AND_DIFFUSE})
      EXPECT_FALSE(sets(face, pname, kRedMaterial));
  EXPECT_TRUE(sets(GL_FRONT, GL_SPECULAR, kRedMaterial));
  EXPECT_TRUE(sets(GL_BACK, GL_DIFFUSE, kGreenMaterial));
  EXPECT_FALSE(sets(GL_FRONT, GL_DIFFUSE, kRedMaterial));
  EXPECT_TRUE(sets(GL_FRONT_AND_BACK, GL_DIFFUSE, kRedMaterial)) << "the back's is another";
}

/// Enable(COLOR_MATERIAL) makes colours set materials. A called list or a popped attribute may set
/// anything.
TEST_F(StateCommands, OtherCommandsMayHaveSetIt) {
  const auto twice = [&](const std::function<void()> &between) {
    const auto &items = compiled([&] {
      EXPECT_TRUE(material(kRedMaterial));
      point(*m_context);
      between();
      point(*m_context);
      EXPECT_TRUE(material(kRedMaterial));
      point(*m_context);
    });
    std::size_t commands = 0;
    for (const DisplayList::Item &item : items)
      commands += item.command && item.command->kind == Command::Kind::State ? 1 : 0;
    return commands;
  };
  EXPECT_EQ(twice([] {}), 1u);
  EXPECT_EQ(twice([&] { handlers::Enable(*m_context, GL_BLEND); }), 2u);
  EXPECT_EQ(twice([&] { handlers::CallList(*m_context, 7); }), 2u);
  EXPECT_EQ(twice([&] { point(*m_context, true); }), 2u);
}

TEST_F(StateCommands, WhatMayBeAnErrorIsTheHosts) {
  handlers::NewList(*m_context, 1, GL_COMPILE);
  EXPECT_FALSE(material({129}, GL_SHININESS));
  EXPECT_FALSE(material(kRedMaterial, GL_COLOR_INDEXES));
  EXPECT_FALSE(material(kRedMaterial, GL_DIFFUSE, GL_LEFT));
  EXPECT_FALSE(recordBindTexture(*m_context, GL_TEXTURE_2D_ARRAY, 1));
  handlers::Begin(*m_context, GL_POINTS);
  EXPECT_FALSE(material(kRedMaterial)) << "within a primitive";
  handlers::End(*m_context);
  handlers::Enable(*m_context, GL_BLEND);
  EXPECT_FALSE(material(kRedMaterial)) << "within a run of commands that the host compiles";
  handlers::EndList(*m_context);
  handlers::NewList(*m_context, 1, GL_COMPILE_AND_EXECUTE);
  EXPECT_FALSE(material(kRedMaterial)) << "and it is executed";
  handlers::EndList(*m_context);
}

TEST_F(StateCommands, TheyAreExecutedInTheirOrder) {
  compiled([&] {
    EXPECT_TRUE(material(kRedMaterial));
    texture(2);
    point(*m_context);
    texture(3);
  });
  m_context.leaveToHost(m_host);
  m_context->dirty = 0;
  handlers::CallList(*m_context, 1);
  std::vector<std::string> seen;
  for (const std::string &call : m_host.calls)
    if (call.starts_with("Materialfv") || call.starts_with("BindTexture") ||
        call.starts_with("CallList"))
      seen.push_back(call.substr(0, call.find(' ')));
  EXPECT_EQ(seen,
            (std::vector<std::string>{"Materialfv", "BindTexture", "CallList", "BindTexture"}));
  EXPECT_NE(m_context->dirty & dirty::kMaterial, 0u);
}

} // namespace
} // namespace arbiter::state
