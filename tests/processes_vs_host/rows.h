#pragma once

/// The rows of the matrix of foreign processes: each is something that processes do without the
/// layer's knowledge. Each draws, and prints or ends in a way that is compared with the run on the
/// bare host.
namespace foreign {

struct Row {
  const char *name;
  void (*run)(); ///< returning makes main exit with 0
};

// Each of these adds the rows of one source.
void endRows(void (*add)(Row));
void surroundingRows(void (*add)(Row));
void forkRows(void (*add)(Row));
void threadRows(void (*add)(Row));
/// Defined only in the program with its own malloc (foreign_watched).
[[gnu::weak]] void watchedRows(void (*add)(Row));

/// Returns milliseconds by FOREIGN_SEED, so that asynchronous events come at any point of a frame.
int someMilliseconds();
/// Calls the handler of SIGALRM after that time, once.
void alarmAfter(int milliseconds, void (*handler)(int));

} // namespace foreign
