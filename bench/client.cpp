// The measured client of bench/run. It takes one command for each line of input, so that a process
// with the layer and one without can take turns.
//   rows                    -> ["name", ...]
//   sample COUNT SEED NAME  -> [nanoseconds, ...]
//   differ PAIR             -> the fraction of pixels that differ within a pair of nv_texts.h
#include "nv_rows.h"
#include "rows.h"

#include "common/surface.h"

#include <cstdio>
#include <iostream>
#include <string>

namespace {

std::vector<bench::Row> allRows() {
  std::vector<bench::Row> rows = bench::callRows();
  rows.insert(rows.end(), bench::drawRows().begin(), bench::drawRows().end());
  rows.insert(rows.end(), bench::loadRows().begin(), bench::loadRows().end());
  rows.insert(rows.end(), bench::fillRows().begin(), bench::fillRows().end());
  rows.insert(rows.end(), bench::nvRows().begin(), bench::nvRows().end());
  return rows;
}

void printArray(const std::vector<double> &values) {
  const char *comma = "[";
  for (const double value : values) {
    std::printf("%s%.3f", comma, value);
    comma = ", ";
  }
  std::printf("]\n");
}

bool answerSample(const std::vector<bench::Row> &rows, const std::string &order) {
  int count = 0, used = 0;
  unsigned seed = 0;
  if (std::sscanf(order.c_str(), "sample %d %u %n", &count, &seed, &used) != 2 || count < 1)
    return false;
  for (const bench::Row &row : rows) {
    if (row.name == order.substr(std::size_t(used))) {
      printArray(row.sample(count, seed));
      return true;
    }
  }
  return false;
}

} // namespace

int main() {
  const auto surface = demos::makeHeadless(512, 512, false);
  if (!surface || !epoxy_has_gl_extension("GL_ARB_fragment_program"))
    return 77;
  glViewport(0, 0, surface->width(), surface->height());
  GLint alu = 0;
  glGetProgramivARB(GL_FRAGMENT_PROGRAM_ARB, GL_MAX_PROGRAM_ALU_INSTRUCTIONS_ARB, &alu);
  std::printf("{\"renderer\": \"%s\", \"version\": \"%s\", \"max_alu\": %d}\n",
              reinterpret_cast<const char *>(glGetString(GL_RENDERER)),
              reinterpret_cast<const char *>(glGetString(GL_VERSION)), alu);
  std::fflush(stdout);
  const std::vector<bench::Row> rows = allRows();
  for (std::string order; std::getline(std::cin, order);) {
    if (order == "rows") {
      const char *comma = "[";
      for (const bench::Row &row : rows) {
        std::printf("%s\"%s\"", comma, row.name.c_str());
        comma = ", ";
      }
      std::printf("]\n");
    } else if (order.starts_with("differ ")) {
      std::printf("%.6f\n", bench::nvDifference(order.substr(7)));
    } else if (!answerSample(rows, order)) {
      std::fprintf(stderr, "unknown order: %s\n", order.c_str());
      return 1;
    }
    std::fflush(stdout);
    while (const GLenum error = glGetError()) {
      std::fprintf(stderr, "GL error 0x%04x after: %s\n", error, order.c_str());
      return 1;
    }
  }
  return 0;
}
