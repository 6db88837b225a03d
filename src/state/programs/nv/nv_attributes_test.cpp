// Checks NV_vertex_program's commands for vertex attributes and their arrays (2.14.1.1, 2.14.3).
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "fp_compiler/ir/ir.h"
#include "state/objects/linked_program.h"
#include "state/testing/nv_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

TEST(NvAttributes, AreTheConventionalOnesByNumber) {
  NvHost host;
  const CurrentContext context(host);
  const char *const expected[] = {
      "Vertex4fv 0",         "VertexAttrib4fv 1",  "Normal3fv 0",        "Color4fv 0",
      "SecondaryColor3fv 0", "FogCoordfv 0",       "VertexAttrib4fv 6",  "VertexAttrib4fv 7",
      "MultiTexCoord4fv 0",  "MultiTexCoord4fv 1", "MultiTexCoord4fv 2", "MultiTexCoord4fv 3",
      "MultiTexCoord4fv 4",  "MultiTexCoord4fv 5", "MultiTexCoord4fv 6", "MultiTexCoord4fv 7"};
  for (GLuint i = 0; i < 16; ++i) {
    host.calls.clear();
    handlers::VertexAttrib4fNV(*context, i, 1, 2, 3, 4);
    // has more components than the conventional attribute
    const bool wider = i == 2 || i == 4 || i == 5;
    ASSERT_EQ(host.calls.size(), wider ? 2u : 1u);
    EXPECT_EQ(host.calls[0].substr(0, std::string(expected[i]).size()), expected[i]);
    EXPECT_NE(host.calls[0].find(" 1000"), std::string::npos);
    if (wider) {
      EXPECT_EQ(host.calls[1], "VertexAttrib4fv " + std::to_string(i) + " 1000 2000 3000 4000");
    }
  }
}

TEST(NvAttributes, MissingComponentsAreZeroAndOne) {
  NvHost host;
  const CurrentContext context(host);
  const GLshort shorts[] = {1, 2, 3, 4};
  const GLdouble doubles[] = {1, 2, 3, 4};
  const GLubyte bytes[] = {255, 0, 51, 255};
  handlers::VertexAttrib1fNV(*context, 8, 1);
  handlers::VertexAttrib2svNV(*context, 8, shorts);
  handlers::VertexAttrib3dvNV(*context, 8, doubles);
  handlers::VertexAttrib4ubNV(*context, 8, 255, 0, 51, 255);
  handlers::VertexAttrib4ubvNV(*context, 8, bytes);
  handlers::VertexAttrib1sNV(*context, 8, -1);
  EXPECT_EQ(host.calls[host.calls.size() - 6], "MultiTexCoord4fv 0 1000 0 0 1000");
  EXPECT_EQ(host.calls[host.calls.size() - 5], "MultiTexCoord4fv 0 1000 2000 0 1000");
  EXPECT_EQ(host.calls[host.calls.size() - 4], "MultiTexCoord4fv 0 1000 2000 3000 1000");
  EXPECT_EQ(host.calls[host.calls.size() - 3], "MultiTexCoord4fv 0 1000 0 200 1000");
  EXPECT_EQ(host.calls[host.calls.size() - 2], "MultiTexCoord4fv 0 1000 0 200 1000");
  EXPECT_EQ(host.calls[host.calls.size() - 1], "MultiTexCoord4fv 0 -1000 0 0 1000");
}

TEST(NvAttributes, SeveralAreSetFromTheLastOne) {
  NvHost host;
  const CurrentContext context(host);
  const GLfloat values[] = {1, 2, 3, 4, 5, 6};
  host.calls.clear();
  handlers::VertexAttribs2fvNV(*context, 0, 3, values);
  ASSERT_EQ(host.calls.size(), 4u);
  EXPECT_EQ(host.calls[0], "Normal3fv 0 5000 6000 0");
  EXPECT_EQ(host.calls[2], "VertexAttrib4fv 1 3000 4000 0 1000");
  EXPECT_EQ(host.calls[3], "Vertex4fv 0 1000 2000 0 1000") << "the vertex comes after the others";
}

TEST(NvAttributes, Errors) {
  NvHost host;
  const CurrentContext context(host);
  const GLfloat values[16] = {};
  host.calls.clear();
  handlers::VertexAttrib4fNV(*context, 15, 1, 2, 3, 4);
  EXPECT_EQ(error(*context), kNoError);
  handlers::VertexAttrib4fNV(*context, 16, 1, 2, 3, 4);
  EXPECT_EQ(error(*context), kValue);
  handlers::VertexAttribs4fvNV(*context, 14, 4, values);
  EXPECT_EQ(error(*context), kValue);
  handlers::VertexAttribs4fvNV(*context, 0, -1, values);
  EXPECT_EQ(error(*context), kValue);
  handlers::VertexAttribs4fvNV(*context, ~0u, 1, values);
  EXPECT_EQ(error(*context), kValue);
  EXPECT_EQ(host.calls.size(), 1u);
}

TEST(NvAttributes, Queries) {
  NvHost host;
  host.floats[GL_CURRENT_COLOR] = {0.5f, 0.25f, 0.125f, 1};
  host.floats[GL_CURRENT_NORMAL] = {1, 2, 3};
  host.floats[GL_CURRENT_FOG_COORD] = {7};
  const CurrentContext context(host);
  const auto get = [&](GLuint index, GLenum pname = GL_CURRENT_ATTRIB_NV) {
    Vec4 value = {-1, -1, -1, -1};
    handlers::GetVertexAttribfvNV(*context, index, pname, value.data());
    return value;
  };
  EXPECT_EQ(get(3), (Vec4{0.5f, 0.25f, 0.125f, 1}));
  EXPECT_EQ(get(2), (Vec4{1, 2, 3, 1}));
  EXPECT_EQ(get(5), (Vec4{7, 0, 0, 1}));
  EXPECT_EQ(error(*context), kNoError);
  GLint size = 0;
  handlers::GetVertexAttribivNV(*context, 0, GL_ATTRIB_ARRAY_SIZE_NV, &size);
  EXPECT_EQ(size, 3) << "of the host's array";
  GLdouble wide[4] = {};
  handlers::GetVertexAttribdvNV(*context, 3, GL_CURRENT_ATTRIB_NV, wide);
  EXPECT_EQ(wide[1], 0.25);
  EXPECT_EQ(error(*context), kNoError);
  get(0);
  EXPECT_EQ(error(*context), kValue) << "attribute 0 has no current value";
  get(16);
  EXPECT_EQ(error(*context), kValue);
  get(1, 0x1234);
  EXPECT_EQ(error(*context), kEnum);
  void *pointer = nullptr;
  handlers::GetVertexAttribPointervNV(*context, 16, GL_ATTRIB_ARRAY_POINTER_NV, &pointer);
  EXPECT_EQ(error(*context), kValue);
  handlers::GetVertexAttribPointervNV(*context, 1, 0x1234, &pointer);
  EXPECT_EQ(error(*context), kEnum);
}

TEST(NvArrays, PointerErrors) {
  NvHost host;
  const CurrentContext context(host);
  const auto point = [&](GLuint index, GLint size, GLenum type, GLsizei stride) {
    handlers::VertexAttribPointerNV(*context, index, size, type, stride, nullptr);
    return error(*context);
  };
  EXPECT_EQ(point(1, 4, GL_FLOAT, 0), kNoError);
  EXPECT_EQ(point(1, 4, GL_UNSIGNED_BYTE, 0), kNoError);
  EXPECT_EQ(point(1, 2, GL_SHORT, 0), kNoError);
  EXPECT_EQ(point(1, 3, GL_DOUBLE, 0), kNoError);
  EXPECT_EQ(point(16, 4, GL_FLOAT, 0), kValue);
  EXPECT_EQ(point(1, 5, GL_FLOAT, 0), kValue);
  EXPECT_EQ(point(1, 0, GL_FLOAT, 0), kValue);
  EXPECT_EQ(point(1, 4, GL_FLOAT, -1), kValue);
  EXPECT_EQ(point(1, 3, GL_UNSIGNED_BYTE, 0), kOperation);
  EXPECT_EQ(point(1, 4, GL_INT, 0), kEnum);
  EXPECT_EQ(point(1, 4, 0x1234, 0), kEnum);
  const std::string prefix = "VertexAttribPointer 1 4 ";
  EXPECT_EQ(host.count(prefix + std::to_string(GL_FLOAT) + " 0 0"), 1);
  EXPECT_EQ(host.count(prefix + std::to_string(GL_UNSIGNED_BYTE) + " 1 0"), 1) << "normalized";
}

TEST(NvArrays, EnablesAreTheHostsGenericOnes) {
  NvHost host;
  const CurrentContext context(host);
  handlers::EnableClientState(*context, GL_VERTEX_ATTRIB_ARRAY0_NV + 3);
  EXPECT_EQ(host.attribArrays, std::set<GLuint>{3});
  EXPECT_TRUE(handlers::IsEnabled(*context, GL_VERTEX_ATTRIB_ARRAY0_NV + 3));
  EXPECT_FALSE(handlers::IsEnabled(*context, GL_VERTEX_ATTRIB_ARRAY0_NV + 4));
  handlers::DisableClientState(*context, GL_VERTEX_ATTRIB_ARRAY0_NV + 3);
  EXPECT_TRUE(host.attribArrays.empty());
  handlers::EnableClientState(*context, GL_NORMAL_ARRAY);
  EXPECT_EQ(host.count("EnableClientState"), 1);
  EXPECT_EQ(error(*context), kNoError);
}

TEST(NvArrays, AProgramReadsThemWhereTheyAreEnabled) {
  NvHost host;
  const CurrentContext context(host);
  loadNv(*context, kNvVertex, 1,
         "!!VP1.0\nMOV R0, v[OPOS];\nADD o[HPOS], R0, v[NRML].xyzx;\nMOV o[COL0], v[3];\nEND");
  handlers::BindProgramNV(*context, kNvVertex, 1);
  handlers::Enable(*context, kNvVertex);
  ASSERT_TRUE(draw(*context));
  const auto reads = [&] {
    LinkedProgram *const program = context->effective.linkedProgram;
    std::set<int> generic;
    for (const fp::ir::Attribute &attribute : program->stages()[0]->compiled->program->attributes)
      if (attribute.kind == fp::ir::AttributeKind::Generic)
        generic.insert(attribute.index);
    return generic;
  };
  EXPECT_EQ(reads(), std::set<int>{});
  handlers::EnableClientState(*context, GL_VERTEX_ATTRIB_ARRAY0_NV + 2);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(reads(), std::set<int>{2});
  host.attribArrays.insert(3); // by a command that the layer does not see
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(reads(), (std::set<int>{2, 3}));
  handlers::Begin(*context, GL_POINTS);
  EXPECT_EQ(reads(), std::set<int>{}) << "between Begin and End there are no arrays";
  handlers::End(*context);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(reads(), (std::set<int>{2, 3}));
  host.attribArrays.clear();
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(reads(), std::set<int>{});
}

} // namespace
} // namespace arbiter::state
