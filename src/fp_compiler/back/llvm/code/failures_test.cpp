// Tests of fatal LLVM errors: on a thread of the layer they are exceptions, and on others LLVM
// behaves as usual.
#include "fp_compiler/back/llvm/code/failures.h"

#include <csignal>
#include <new>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <gtest/gtest.h>
#include <llvm/ADT/SmallVector.h>
#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>
#include <llvm/Support/ErrorHandling.h>

#include "fp_compiler/back/llvm/engine/engine.h"
#include "fp_compiler/ir/builder.h"

namespace arbiter::fp::llvm_back {
namespace {

TEST(Failures, AFatalErrorIsAnException) {
  const FailureScope scope;
  try {
    llvm::report_fatal_error("a test", false);
  } catch (const LlvmFailure &failure) {
    EXPECT_STREQ(failure.what(), "a test");
    return;
  }
  FAIL() << "nothing was thrown";
}

TEST(Failures, NoMemoryIsOneToo) {
  const FailureScope scope;
  EXPECT_THROW(llvm::report_bad_alloc_error("a test"), std::bad_alloc);
}

// The exception passes through frames of LLVM, which are compiled without exceptions.
TEST(Failures, AnExceptionPassesThroughLlvm) {
  const FailureScope scope;
  llvm::LLVMContext context;
  llvm::Module module("test", context);
  struct Listener final : llvm::DiagnosticHandler {
    bool handleDiagnostics(const llvm::DiagnosticInfo &) override {
      throw LlvmFailure("from within");
    }
  };
  context.setDiagnosticHandler(std::make_unique<Listener>());
  EXPECT_THROW(context.emitError("a test"), LlvmFailure);
}

/// Returns the exit status and the error output of a child process that runs \p work.
template <typename Work> std::pair<int, std::string> childOf(Work work) {
  int ends[2];
  EXPECT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(ends[1], STDERR_FILENO);
    work();
    ::_exit(77);
  }
  ::close(ends[1]);
  std::string text;
  char buffer[256];
  for (ssize_t count = 0; (count = ::read(ends[0], buffer, sizeof buffer)) > 0;)
    text.append(buffer, std::size_t(count));
  ::close(ends[0]);
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  return {status, text};
}

TEST(Failures, OtherThreadsHaveLlvmsOwnWay) {
  // This thread has a scope, and the handlers are installed.
  const FailureScope scope;
  const auto [exited, said] =
      childOf([] { std::thread([] { llvm::report_fatal_error("theirs", false); }).join(); });
  EXPECT_TRUE(WIFEXITED(exited) && WEXITSTATUS(exited) == 1);
  EXPECT_EQ(said, "LLVM ERROR: theirs\n");
  const auto [aborted, words] =
      childOf([] { std::thread([] { llvm::report_fatal_error("theirs", true); }).join(); });
  EXPECT_TRUE(WIFSIGNALED(aborted) && WTERMSIG(aborted) == SIGABRT);
  EXPECT_EQ(words, "LLVM ERROR: theirs\n");
  const auto [memory, last] =
      childOf([] { std::thread([] { llvm::report_bad_alloc_error("theirs"); }).join(); });
  EXPECT_TRUE(WIFSIGNALED(memory) && WTERMSIG(memory) == SIGABRT);
  EXPECT_EQ(last, "LLVM ERROR: out of memory\n");
}

TEST(Failures, OutsideAScopeItIsLlvmsOwnWayToo) {
  { const FailureScope scope; }
  const auto [status, said] = childOf([] { llvm::report_fatal_error("a test", false); });
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1);
  EXPECT_EQ(said, "LLVM ERROR: a test\n");
}

TEST(Failures, WhatIsKeptOutlivesAnException) {
  static int s_destroyed = 0;
  struct Object {
    ~Object() { ++s_destroyed; }
  };
  { const Kept<Object> object; }
  EXPECT_EQ(s_destroyed, 1);
  EXPECT_FALSE(hasFailed());
  const auto [status, said] = childOf([] {
    try {
      const Kept<Object> object;
      throw std::bad_alloc();
    } catch (const std::bad_alloc &) {
    }
    ::_exit(s_destroyed == 1 && hasFailed() ? 0 : 1);
  });
  EXPECT_EQ(status, 0) << said;
}

// This test comes last, because nothing can be compiled in this process after it.
TEST(FailuresLast, AnEngineMeetsOneAndThenAsksNoMore) {
  const auto engine = makeEngine({});
  ASSERT_NE(engine, nullptr);
  ir::Builder b(ir::Language::ArbVertex);
  b.op(ir::Opcode::Mov, b.result(ir::OutputKind::Position),
       {b.attribute(ir::AttributeKind::Position)});
  const auto prepared = engine->prepareVertex(b.take(), Numerics::Host);
  ASSERT_NE(prepared, nullptr);
  std::string reason;
  EXPECT_NE(engine->compile(*prepared, abi::VertexKey{}, reason), nullptr) << reason;
  noteFailure();
  EXPECT_EQ(engine->compile(*prepared, abi::VertexKey{}, reason), nullptr);
  EXPECT_EQ(reason, "LLVM has failed before in this process");
}

} // namespace
} // namespace arbiter::fp::llvm_back
