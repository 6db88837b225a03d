#pragma once
#include <algorithm>
#include <cstdint>
#include <cstdio>

#include <epoxy/gl.h>

#include "client_options.h"
#include "fp_compiler/testing/random.h"
#include "open_context.h"

/// Issues random sequences of commands and compares each command's error, and the state after each
/// sequence, with a model. Some sequences are in display lists, some between PushAttrib and
/// PopAttrib.
///
/// `Commands` has the types Command and Model, and these:
/// - kExtension, which must be offered, and kMaxUnits of textures;
/// - kListsRaise: the errors of a list are those of its commands, raised when it is called;
/// - random(generator, units), a command; issue(command), which calls GL;
/// - apply(model, command, units), which returns the command's error;
/// - queried(units), GL's state; print(command).
template <typename Commands> class CommandSequences {
public:
  /// Runs a client, whose options are the seeds. Ends with a line of JSON.
  static int main(int argc, char **argv) {
    Seeds seeds;
    if (const auto status = parseOptions(
            argc, argv, "Issues random commands and compares errors and state.", seeds))
      return *status;
    if (!openContextWith(Commands::kExtension))
      return kSkipped;
    CommandSequences sequences;
    int different = 0;
    for (std::uint64_t seed = seeds.first; seed < seeds.last(); ++seed)
      different += sequences.run(seed) ? 0 : 1;
    std::printf("{\"sequences\": %d, \"different\": %d, \"commands\": %ld, \"errors\": %ld, "
                "\"in_lists\": %ld, \"saved\": %ld}\n",
                seeds.count, different, long(seeds.count) * kCommands, sequences.m_errors,
                sequences.m_listed, sequences.m_saved);
    return different == 0 ? 0 : 1;
  }

private:
  static constexpr int kCommands = 100; ///< in a sequence

  CommandSequences() {
    glGetIntegerv(GL_MAX_TEXTURE_UNITS, &m_units);
    m_units = std::min(m_units, GLint(Commands::kMaxUnits));
  }

  static GLenum takeError() {
    const GLenum error = glGetError();
    while (glGetError() != GL_NO_ERROR) {
    }
    return error;
  }

  static bool isExpected(std::uint64_t seed, int at, const typename Commands::Command &command,
                         GLenum expected) {
    const GLenum got = takeError();
    if (got == expected)
      return true;
    std::printf("seed %llu, command %d: error 0x%04X, expected 0x%04X; ",
                static_cast<unsigned long long>(seed), at, got, expected);
    Commands::print(command);
    return false;
  }

  bool agrees(std::uint64_t seed, const char *when) const {
    if (Commands::queried(m_units) == m_model)
      return true;
    std::printf("seed %llu: the state %s is another than the model's\n",
                static_cast<unsigned long long>(seed), when);
    return false;
  }

  /// Runs one sequence; the state continues from the previous one.
  bool run(std::uint64_t seed) {
    arbiter::fp::testing::Random random(seed);
    const typename Commands::Model before = m_model;
    const bool saves = random.chance(25), lists = random.chance(25);
    if (saves)
      glPushAttrib(GL_TEXTURE_BIT);
    const GLuint list = lists ? glGenLists(1) : 0;
    if (lists)
      glNewList(list, GL_COMPILE);
    GLenum firstError = GL_NO_ERROR;
    bool same = true;
    for (int i = 0; i < kCommands; ++i) {
      const typename Commands::Command command = Commands::random(random, m_units);
      const GLenum error = Commands::apply(m_model, command, m_units);
      Commands::issue(command);
      m_errors += error != GL_NO_ERROR ? 1 : 0;
      if (firstError == GL_NO_ERROR)
        firstError = error;
      if (!lists || Commands::kListsRaise)
        same = isExpected(seed, i, command, lists ? GLenum(GL_NO_ERROR) : error) && same;
    }
    if (lists) {
      glEndList();
      if (!Commands::kListsRaise)
        (void)takeError();
      glCallList(list);
      if (Commands::kListsRaise)
        same = isExpected(seed, kCommands, {}, firstError) && same;
      else
        (void)takeError();
      glDeleteLists(list, 1);
      m_listed += kCommands;
    }
    same = agrees(seed, "behind the sequence") && same;
    if (saves) {
      glPopAttrib();
      m_model = before;
      ++m_saved;
      same = agrees(seed, "behind PopAttrib") && same;
    }
    return same;
  }

  typename Commands::Model m_model;
  GLint m_units = 0;
  long m_errors = 0, m_listed = 0, m_saved = 0;
};
