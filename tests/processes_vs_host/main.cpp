// foreign ROW: runs one row of the matrix of foreign processes. run.py says what is compared.
#include "rows.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>

#include <sys/time.h>

namespace foreign {

int someMilliseconds() {
  const char *const seed = std::getenv("FOREIGN_SEED");
  std::srand(seed ? unsigned(std::atoi(seed)) : 1);
  return 1 + std::rand() % 120;
}

void alarmAfter(int milliseconds, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  sigaction(SIGALRM, &action, nullptr);
  itimerval timer = {};
  timer.it_value.tv_usec = 1000 * milliseconds;
  setitimer(ITIMER_REAL, &timer, nullptr);
}

namespace {

const char *g_wanted = nullptr;
bool g_list = false;
void (*g_run)() = nullptr;

void add(Row row) {
  if (g_list)
    std::printf("%s\n", row.name);
  else if (std::strcmp(row.name, g_wanted) == 0)
    g_run = row.run;
}

} // namespace

} // namespace foreign

int main(int count, char **arguments) {
  using namespace foreign;
  g_list = count != 2;
  g_wanted = g_list ? "" : arguments[1];
  for (void (*const rows)(void (*)(Row)) : {endRows, surroundingRows, forkRows, threadRows})
    rows(add);
  if (watchedRows)
    watchedRows(add);
  if (g_list)
    return 0;
  if (!g_run) {
    std::fprintf(stderr, "foreign: no row %s\n", g_wanted);
    return 2;
  }
  g_run();
  return 0;
}
