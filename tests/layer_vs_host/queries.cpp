// Queries around draws with programs, and conditional rendering.
#include "harness.h"

namespace paths {

namespace {

GLuint64 resultOf(GLuint query) {
  GLuint64 result = 0;
  glGetQueryObjectui64v(query, GL_QUERY_RESULT, &result);
  return result;
}

void occlusion(Recorder &r) {
  usePrograms();
  GLuint queries[4] = {};
  glGenQueries(4, queries);
  glBeginQuery(GL_SAMPLES_PASSED, queries[0]);
  gradient(-1, -1, 0, 0);
  load("!!ARBfp1.0\nKIL {-1};\nMOV result.color, 1;\nEND"); // the first use compiles it
  gradient(0, 0, 1, 1);
  load("!!ARBfp1.0\nTEMP t;\nSUB t, fragment.texcoord[0], 0.5;\nKIL t.x;\n"
       "MOV result.color, fragment.color;\nEND");
  gradient(0, -1, 1, 0);
  glEndQuery(GL_SAMPLES_PASSED);
  r.value("samples", double(resultOf(queries[0])));
  glBeginQuery(GL_ANY_SAMPLES_PASSED, queries[1]);
  load("!!ARBfp1.0\nKIL {-1};\nMOV result.color, 1;\nEND");
  gradient(-1, -1, 1, 1);
  glEndQuery(GL_ANY_SAMPLES_PASSED);
  r.value("none of them", double(resultOf(queries[1])));
  glBeginQuery(GL_ANY_SAMPLES_PASSED, queries[2]);
  load(kGreen);
  gradient(-0.1f, 0.5f, 0.1f, 0.7f);
  glEndQuery(GL_ANY_SAMPLES_PASSED);
  r.value("some of them", double(resultOf(queries[2])));
  // A draw that is an error counts nothing.
  glBindProgramARB(kFragment, 0);
  glBeginQuery(GL_SAMPLES_PASSED, queries[3]);
  gradient(-1, -1, 1, 1);
  glEndQuery(GL_SAMPLES_PASSED);
  r.value("invalid", double(resultOf(queries[3])));
  r.errors("invalid");
  r.picture("what passed");
}

void conditional(Recorder &r) {
  const Programs programs = usePrograms();
  GLuint queries[2] = {};
  glGenQueries(2, queries);
  glBeginQuery(GL_SAMPLES_PASSED, queries[0]);
  glProgramEnvParameter4fARB(kVertex, 0, 5, 5, 0, 0);
  gradient();
  glEndQuery(GL_SAMPLES_PASSED);
  glProgramEnvParameter4fARB(kVertex, 0, 0, 0, 0, 0);
  glBeginQuery(GL_SAMPLES_PASSED, queries[1]);
  gradient(-0.1f, -0.1f, 0.1f, 0.1f);
  glEndQuery(GL_SAMPLES_PASSED);
  glBeginConditionalRender(queries[0], GL_QUERY_WAIT);
  gradient(-1, -1, 0, 0);
  load(kGreen); // compiled within the query
  gradient(-1, 0, 0, 1);
  glBegin(GL_QUADS);
  glEnd();
  glEndConditionalRender();
  glBeginConditionalRender(queries[1], GL_QUERY_WAIT);
  gradient(0, -1, 1, 0);
  load(kTintFragments);
  tint(1, 0, 1);
  gradient(0, 0, 1, 1);
  glEndConditionalRender();
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  tint(0, 1, 1);
  gradient(-0.3f, -0.3f, 0.3f, 0.3f);
  glEndList();
  glBeginConditionalRender(queries[0], GL_QUERY_WAIT);
  glCallList(list);
  r.value("bound", programiv(GL_PROGRAM_BINDING_ARB) == GLint(programs.fragment));
  glEndConditionalRender();
  gradient(-0.3f, 0.5f, 0.3f, 0.8f);
  r.errors("conditional");
  r.picture("on condition");
}

void timers(Recorder &r) {
  usePrograms();
  GLuint queries[2] = {};
  glGenQueries(2, queries);
  glBeginQuery(GL_TIME_ELAPSED, queries[0]);
  for (int i = 0; i < 8; ++i) {
    load("!!ARBfp1.0\nADD result.color, fragment.color, " + std::to_string(i) + ";\nEND");
    gradient();
  }
  glEndQuery(GL_TIME_ELAPSED);
  glQueryCounter(queries[1], GL_TIMESTAMP);
  r.value("took time", resultOf(queries[0]) > 0);
  r.value("a time", resultOf(queries[1]) > 0);
  r.errors("timers");
  r.picture("drawn");
}

void primitives(Recorder &r) {
  usePrograms();
  GLuint query = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_PRIMITIVES_GENERATED, query);
  gradient();
  glBegin(GL_TRIANGLES);
  for (int i = 0; i < 9; ++i)
    glVertex2f(float(i % 3) - 1, float(i / 3) - 1);
  glEnd();
  glEndQuery(GL_PRIMITIVES_GENERATED);
  const GLuint64 before = resultOf(query);
  glBeginQuery(GL_PRIMITIVES_GENERATED, query);
  glDisable(kVertex);
  glDisable(kFragment);
  gradient();
  glEnable(kVertex);
  glEnable(kFragment);
  glRectf(-1, -1, 1, 1);
  glEndQuery(GL_PRIMITIVES_GENERATED);
  r.value("by programs", double(before));
  r.value("mixed", double(resultOf(query)));
  r.errors("primitives");
}

} // namespace

const std::vector<Case> kQueryCases = {
    {"query-occlusion", occlusion},
    {"query-conditional", conditional},
    {"query-timers", timers},
    {"query-primitives", primitives},
};

} // namespace paths
