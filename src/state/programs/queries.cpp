// Answers GetProgramiv for the program that last loaded. Object 0, and an object without a program,
// answer zero.
#include "state/programs/queries.h"

#include "fp_compiler/nv_limits.h"
#include "state/programs/program_context.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

using Member = std::uint32_t fp::ResourceCounts::*;

struct CountRow {
  GLenum count, maximum, nativeCount, nativeMaximum;
  Member member;
};

constexpr CountRow kRows[] = {
    {GL_PROGRAM_INSTRUCTIONS_ARB, GL_MAX_PROGRAM_INSTRUCTIONS_ARB,
     GL_PROGRAM_NATIVE_INSTRUCTIONS_ARB, GL_MAX_PROGRAM_NATIVE_INSTRUCTIONS_ARB,
     &fp::ResourceCounts::instructions},
    {GL_PROGRAM_ALU_INSTRUCTIONS_ARB, GL_MAX_PROGRAM_ALU_INSTRUCTIONS_ARB,
     GL_PROGRAM_NATIVE_ALU_INSTRUCTIONS_ARB, GL_MAX_PROGRAM_NATIVE_ALU_INSTRUCTIONS_ARB,
     &fp::ResourceCounts::aluInstructions},
    {GL_PROGRAM_TEX_INSTRUCTIONS_ARB, GL_MAX_PROGRAM_TEX_INSTRUCTIONS_ARB,
     GL_PROGRAM_NATIVE_TEX_INSTRUCTIONS_ARB, GL_MAX_PROGRAM_NATIVE_TEX_INSTRUCTIONS_ARB,
     &fp::ResourceCounts::texInstructions},
    {GL_PROGRAM_TEX_INDIRECTIONS_ARB, GL_MAX_PROGRAM_TEX_INDIRECTIONS_ARB,
     GL_PROGRAM_NATIVE_TEX_INDIRECTIONS_ARB, GL_MAX_PROGRAM_NATIVE_TEX_INDIRECTIONS_ARB,
     &fp::ResourceCounts::texIndirections},
    {GL_PROGRAM_TEMPORARIES_ARB, GL_MAX_PROGRAM_TEMPORARIES_ARB, GL_PROGRAM_NATIVE_TEMPORARIES_ARB,
     GL_MAX_PROGRAM_NATIVE_TEMPORARIES_ARB, &fp::ResourceCounts::temporaries},
    {GL_PROGRAM_PARAMETERS_ARB, GL_MAX_PROGRAM_PARAMETERS_ARB, GL_PROGRAM_NATIVE_PARAMETERS_ARB,
     GL_MAX_PROGRAM_NATIVE_PARAMETERS_ARB, &fp::ResourceCounts::parameters},
    {GL_PROGRAM_ADDRESS_REGISTERS_ARB, GL_MAX_PROGRAM_ADDRESS_REGISTERS_ARB,
     GL_PROGRAM_NATIVE_ADDRESS_REGISTERS_ARB, GL_MAX_PROGRAM_NATIVE_ADDRESS_REGISTERS_ARB,
     &fp::ResourceCounts::addressRegisters},
    {GL_PROGRAM_ATTRIBS_ARB, GL_MAX_PROGRAM_ATTRIBS_ARB, GL_PROGRAM_NATIVE_ATTRIBS_ARB,
     GL_MAX_PROGRAM_NATIVE_ATTRIBS_ARB, &fp::ResourceCounts::attribs},
};

/// True for the pnames that ARB_fragment_program adds to GetProgramiv for its own target. For a
/// vertex program the answer is zero, because ARB_vertex_program has no such resources.
bool isFragmentOnly(GLenum pname) {
  return pname >= GL_PROGRAM_ALU_INSTRUCTIONS_ARB &&
         pname <= GL_MAX_PROGRAM_NATIVE_TEX_INDIRECTIONS_ARB;
}

/// True for address registers, which only the vertex language has. Other programs use none and may
/// use none.
bool isAddressRegisters(GLenum pname) {
  return pname >= GL_PROGRAM_ADDRESS_REGISTERS_ARB &&
         pname <= GL_MAX_PROGRAM_NATIVE_ADDRESS_REGISTERS_ARB;
}

/// True if programs of the target have no such resource.
bool isNoneOf(Target target, GLenum pname) {
  return target == Target::Vertex ? isFragmentOnly(pname) : isAddressRegisters(pname);
}

bool queryCounts(const fp::Limits &limits, const CompiledProgram *program, GLenum pname,
                 GLint *params) {
  static constexpr fp::ResourceCounts kNone;
  for (const CountRow &row : kRows) {
    if (pname == row.count)
      *params = GLint((program ? program->counts : kNone).*row.member);
    else if (pname == row.maximum)
      *params = GLint(limits.api.*row.member);
    else if (pname == row.nativeCount)
      *params = GLint((program ? program->nativeCounts : kNone).*row.member);
    else if (pname == row.nativeMaximum)
      *params = GLint(limits.native.*row.member);
    else
      continue;
    return true;
  }
  return false;
}

/// Answers limits of NV_fragment_program2 and NV_vertex_program2_option: the minimum of the
/// specification, or the compiler's limit. Vertex programs only have branches and calls.
bool queryNvLimit(const ProgramTarget &row, GLenum pname, GLint *params) {
  const bool vertex = row.target == Target::Vertex;
  const bool fragment = row.target == Target::Fragment;
  const bool blocks =
      pname != GL_MAX_PROGRAM_EXEC_INSTRUCTIONS_NV && pname != GL_MAX_PROGRAM_CALL_DEPTH_NV;
  if (!(vertex && row.limits.nvOptions >= 1 && !blocks) && !(fragment && row.limits.nvOptions >= 2))
    return false;
  switch (pname) {
  case GL_MAX_PROGRAM_EXEC_INSTRUCTIONS_NV:
    *params = fp::nv::kLeastExecuted;
    break;
  case GL_MAX_PROGRAM_CALL_DEPTH_NV:
    *params = GLint(fp::nv::kMaxCalls);
    break;
  case GL_MAX_PROGRAM_IF_DEPTH_NV:
    *params = GLint(fp::nv::kMaxBlocks);
    break;
  case GL_MAX_PROGRAM_LOOP_DEPTH_NV:
    *params = GLint(fp::nv::kMaxLoops);
    break;
  default:
    *params = fp::nv::kLeastIterations;
  }
  return true;
}

} // namespace

bool queryProgram(ProgramContext &context, const ProgramTarget &row, const ProgramObject &object,
                  GLenum pname, GLint *params) {
  const std::shared_ptr<const CompiledProgram> program = context.group->compiledOf(object);
  if (isNoneOf(row.target, pname)) {
    *params = 0;
    return true;
  }
  if (queryCounts(row.limits, program.get(), pname, params))
    return true;
  switch (pname) {
  case GL_PROGRAM_LENGTH_ARB:
    *params = program ? GLint(program->text.size()) : 0;
    return true;
  case GL_PROGRAM_FORMAT_ARB:
    *params = GL_PROGRAM_FORMAT_ASCII_ARB;
    return true;
  case GL_PROGRAM_BINDING_ARB:
    *params = GLint(object.name);
    return true;
  case GL_MAX_PROGRAM_LOCAL_PARAMETERS_ARB:
    *params = GLint(row.limits.localParameters);
    return true;
  case GL_MAX_PROGRAM_ENV_PARAMETERS_ARB:
    *params = GLint(row.limits.envParameters);
    return true;
  case GL_MAX_PROGRAM_EXEC_INSTRUCTIONS_NV:
  case GL_MAX_PROGRAM_CALL_DEPTH_NV:
  case GL_MAX_PROGRAM_IF_DEPTH_NV:
  case GL_MAX_PROGRAM_LOOP_DEPTH_NV:
  case GL_MAX_PROGRAM_LOOP_COUNT_NV:
    return queryNvLimit(row, pname, params);
  case GL_PROGRAM_UNDER_NATIVE_LIMITS_ARB:
    *params = program && program->underNativeLimits ? GL_TRUE : GL_FALSE;
    return true;
  default:
    return false;
  }
}

} // namespace arbiter::state
