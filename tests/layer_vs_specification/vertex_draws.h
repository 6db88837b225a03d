#pragma once
#include <string>

#include "fixture.h"

namespace api {

/// A context in which vertex programs are enabled; its fragments are fixed function's, blue.
class VertexDraws : public ApiTest {
protected:
  void SetUp() override {
    ApiTest::SetUp();
    glEnable(kVertex);
  }
};

inline constexpr char kThrough[] = "!!ARBvp1.0\nMOV result.position, vertex.position;\n"
                                   "MOV result.color, vertex.color;\nEND";
/// Position and colour, with what an application adds before END.
inline std::string through(const std::string &more) {
  return "!!ARBvp1.0\nMOV result.position, vertex.position;\n" + more + "\nEND";
}

} // namespace api
