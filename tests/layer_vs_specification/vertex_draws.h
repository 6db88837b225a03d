#pragma once
#include <string>

#include "fixture.h"

namespace api {

/// Runs tests with vertex programs enabled; fragments are fixed function's, blue.
class VertexDraws : public ApiTest {
protected:
  void SetUp() override {
    ApiTest::SetUp();
    glEnable(kVertex);
  }
};

inline constexpr char kThrough[] = "!!ARBvp1.0\nMOV result.position, vertex.position;\n"
                                   "MOV result.color, vertex.color;\nEND";
/// Returns a program that passes the position on, with more code before END.
inline std::string through(const std::string &more) {
  return "!!ARBvp1.0\nMOV result.position, vertex.position;\n" + more + "\nEND";
}

} // namespace api
