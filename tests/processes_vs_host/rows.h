#pragma once

/// The rows of the matrix of foreign processes: each is something that processes do which the layer
/// knows nothing of. Each draws, and prints or ends in a way that the run on the bare host is the
/// reference for.
namespace foreign {

struct Row {
  const char *name;
  void (*run)(); ///< returning is exit(0) by main
};

// Of one source each.
void endRows(void (*add)(Row));
void surroundingRows(void (*add)(Row));
void forkRows(void (*add)(Row));
void threadRows(void (*add)(Row));
/// In the program whose malloc is its own (foreign_watched) only.
[[gnu::weak]] void watchedRows(void (*add)(Row));

/// Milliseconds by FOREIGN_SEED, so that what comes from aside comes at any point of a frame.
int someMilliseconds();
/// Calls the handler of SIGALRM after that time, once.
void alarmAfter(int milliseconds, void (*handler)(int));

} // namespace foreign
