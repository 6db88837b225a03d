#include "state/context.h"
#include "state/lifecycle.h"
#include "host/handlers.h"
#include "host/host_table.h"
#include <mutex>
#include <cstdio>
#include <cstdlib>
#include <cstring>
namespace arbiter::state { 

static Context g_null; constinit thread_local ContextHot *t_current = &g_null; static int g_serial; static std::mutex g_m; static unsigned long g_draws; static int g_ctx, g_frames;
Context *createContext(Provider, const host::HostTable *t, Context *share){ auto*c=new Context; c->host=t; c->drawCounter=&g_draws; c->serial=++g_serial; g_ctx++; if(getenv("FAKE_LOG")) fprintf(stderr,"create %d share %d\n",c->serial, share?share->serial:0); return c;}
void makeCurrent(Context*c){ std::lock_guard l(g_m); auto*old=static_cast<Context*>(t_current); if(c)c->cur++; t_current=c?c:&g_null; if(old!=&g_null && --old->cur==0 && old->dead){ if(getenv("FAKE_LOG"))fprintf(stderr,"free %d\n",old->serial); delete old;}}
Context *currentContext(){return t_current==&g_null?nullptr:static_cast<Context*>(t_current);}
void destroyContext(Context*c){ std::lock_guard l(g_m); c->dead=true; if(getenv("FAKE_LOG"))fprintf(stderr,"destroy %d\n",c->serial); if(!c->cur) delete c;}
void frameEnd(Context*){g_frames++;}
void setNullTable(const host::HostTable*t){ g_null.host=t; g_null.drawCounter=&g_null.counted; g_null.passThrough=true;}
__attribute__((destructor)) static void bye(){ if(const char*f=getenv("ARBITER_STATS")){ if(FILE*o=fopen(f,"w")){ fprintf(o,"{\"contexts\": %d, \"draws\": %lu, \"frames\": %d}\n",g_ctx,g_draws,g_frames); fclose(o);} } }
namespace handlers { bool beginDraw(Context&){return true;} void restoreApplicationProgram(Context&){} GLuint guardName(Context&,GLuint n){return n;}
void Begin(Context &c_, GLenum mode) { return c_.host->Begin(mode); }
void BindProgramARB(Context &c_, GLenum target, GLuint program) { return c_.host->BindProgramARB(target, program); }
void CallList(Context &c_, GLuint list) { return c_.host->CallList(list); }
void CallLists(Context &c_, GLsizei n, GLenum type, const void * lists) { return c_.host->CallLists(n, type, lists); }
void CopyTexImage1D(Context &c_, GLenum target, GLint level, GLenum internalformat, GLint x, GLint y, GLsizei width, GLint border) { return c_.host->CopyTexImage1D(target, level, internalformat, x, y, width, border); }
void CopyTexImage2D(Context &c_, GLenum target, GLint level, GLenum internalformat, GLint x, GLint y, GLsizei width, GLsizei height, GLint border) { return c_.host->CopyTexImage2D(target, level, internalformat, x, y, width, height, border); }
void CopyTexSubImage1D(Context &c_, GLenum target, GLint level, GLint xoffset, GLint x, GLint y, GLsizei width) { return c_.host->CopyTexSubImage1D(target, level, xoffset, x, y, width); }
void CopyTexSubImage2D(Context &c_, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint x, GLint y, GLsizei width, GLsizei height) { return c_.host->CopyTexSubImage2D(target, level, xoffset, yoffset, x, y, width, height); }
void CopyTexSubImage3D(Context &c_, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset, GLint x, GLint y, GLsizei width, GLsizei height) { return c_.host->CopyTexSubImage3D(target, level, xoffset, yoffset, zoffset, x, y, width, height); }
void DeleteLists(Context &c_, GLuint list, GLsizei range) { return c_.host->DeleteLists(list, range); }
void DeleteObjectARB(Context &c_, GLhandleARB obj) { return c_.host->DeleteObjectARB(obj); }
void DeleteProgram(Context &c_, GLuint program) { return c_.host->DeleteProgram(program); }
void DeleteProgramsARB(Context &c_, GLsizei n, const GLuint * programs) { return c_.host->DeleteProgramsARB(n, programs); }
void Disable(Context &c_, GLenum cap) { return c_.host->Disable(cap); }
void Enable(Context &c_, GLenum cap) { return c_.host->Enable(cap); }
void End(Context &c_) { return c_.host->End(); }
void EndList(Context &c_) { return c_.host->EndList(); }
GLuint GenLists(Context &c_, GLsizei range) { return c_.host->GenLists(range); }
void GenProgramsARB(Context &c_, GLsizei n, GLuint * programs) { return c_.host->GenProgramsARB(n, programs); }
void GetBooleanv(Context &c_, GLenum pname, GLboolean * data) { return c_.host->GetBooleanv(pname, data); }
void GetDoublev(Context &c_, GLenum pname, GLdouble * data) { return c_.host->GetDoublev(pname, data); }
GLenum GetError(Context &c_) { return c_.host->GetError(); }
void GetFloatv(Context &c_, GLenum pname, GLfloat * data) { return c_.host->GetFloatv(pname, data); }
void GetIntegerv(Context &c_, GLenum pname, GLint * data) { return c_.host->GetIntegerv(pname, data); }
void GetNamedProgramLocalParameterdvEXT(Context &c_, GLuint program, GLenum target, GLuint index, GLdouble * params) { return c_.host->GetNamedProgramLocalParameterdvEXT(program, target, index, params); }
void GetNamedProgramLocalParameterfvEXT(Context &c_, GLuint program, GLenum target, GLuint index, GLfloat * params) { return c_.host->GetNamedProgramLocalParameterfvEXT(program, target, index, params); }
void GetNamedProgramStringEXT(Context &c_, GLuint program, GLenum target, GLenum pname, void * string) { return c_.host->GetNamedProgramStringEXT(program, target, pname, string); }
void GetNamedProgramivEXT(Context &c_, GLuint program, GLenum target, GLenum pname, GLint * params) { return c_.host->GetNamedProgramivEXT(program, target, pname, params); }
void GetProgramEnvParameterdvARB(Context &c_, GLenum target, GLuint index, GLdouble * params) { return c_.host->GetProgramEnvParameterdvARB(target, index, params); }
void GetProgramEnvParameterfvARB(Context &c_, GLenum target, GLuint index, GLfloat * params) { return c_.host->GetProgramEnvParameterfvARB(target, index, params); }
void GetProgramLocalParameterdvARB(Context &c_, GLenum target, GLuint index, GLdouble * params) { return c_.host->GetProgramLocalParameterdvARB(target, index, params); }
void GetProgramLocalParameterfvARB(Context &c_, GLenum target, GLuint index, GLfloat * params) { return c_.host->GetProgramLocalParameterfvARB(target, index, params); }
void GetProgramStringARB(Context &c_, GLenum target, GLenum pname, void * string) { return c_.host->GetProgramStringARB(target, pname, string); }
void GetProgramivARB(Context&c, GLenum t, GLenum p, GLint*v){ if(p==0x880D){*v=4;return;} c.host->GetProgramivARB(t,p,v);}
const GLubyte * GetString(Context &c_, GLenum name) { return c_.host->GetString(name); }
const GLubyte * GetStringi(Context &c_, GLenum name, GLuint index) { return c_.host->GetStringi(name, index); }
GLboolean IsEnabled(Context &c_, GLenum cap) { return c_.host->IsEnabled(cap); }
GLboolean IsList(Context &c_, GLuint list) { return c_.host->IsList(list); }
GLboolean IsProgramARB(Context &c_, GLuint program) { return c_.host->IsProgramARB(program); }
void ListBase(Context &c_, GLuint base) { return c_.host->ListBase(base); }
void NamedProgramLocalParameter4dEXT(Context &c_, GLuint program, GLenum target, GLuint index, GLdouble x, GLdouble y, GLdouble z, GLdouble w) { return c_.host->NamedProgramLocalParameter4dEXT(program, target, index, x, y, z, w); }
void NamedProgramLocalParameter4dvEXT(Context &c_, GLuint program, GLenum target, GLuint index, const GLdouble * params) { return c_.host->NamedProgramLocalParameter4dvEXT(program, target, index, params); }
void NamedProgramLocalParameter4fEXT(Context &c_, GLuint program, GLenum target, GLuint index, GLfloat x, GLfloat y, GLfloat z, GLfloat w) { return c_.host->NamedProgramLocalParameter4fEXT(program, target, index, x, y, z, w); }
void NamedProgramLocalParameter4fvEXT(Context &c_, GLuint program, GLenum target, GLuint index, const GLfloat * params) { return c_.host->NamedProgramLocalParameter4fvEXT(program, target, index, params); }
void NamedProgramLocalParameters4fvEXT(Context &c_, GLuint program, GLenum target, GLuint index, GLsizei count, const GLfloat * params) { return c_.host->NamedProgramLocalParameters4fvEXT(program, target, index, count, params); }
void NamedProgramStringEXT(Context &c_, GLuint program, GLenum target, GLenum format, GLsizei len, const void * string) { return c_.host->NamedProgramStringEXT(program, target, format, len, string); }
void NewList(Context &c_, GLuint list, GLenum mode) { return c_.host->NewList(list, mode); }
void PopAttrib(Context &c_) { return c_.host->PopAttrib(); }
void ProgramEnvParameter4dARB(Context &c_, GLenum target, GLuint index, GLdouble x, GLdouble y, GLdouble z, GLdouble w) { return c_.host->ProgramEnvParameter4dARB(target, index, x, y, z, w); }
void ProgramEnvParameter4dvARB(Context &c_, GLenum target, GLuint index, const GLdouble * params) { return c_.host->ProgramEnvParameter4dvARB(target, index, params); }
void ProgramEnvParameter4fARB(Context &c_, GLenum target, GLuint index, GLfloat x, GLfloat y, GLfloat z, GLfloat w) { return c_.host->ProgramEnvParameter4fARB(target, index, x, y, z, w); }
void ProgramEnvParameter4fvARB(Context &c_, GLenum target, GLuint index, const GLfloat * params) { return c_.host->ProgramEnvParameter4fvARB(target, index, params); }
void ProgramEnvParameters4fvEXT(Context &c_, GLenum target, GLuint index, GLsizei count, const GLfloat * params) { return c_.host->ProgramEnvParameters4fvEXT(target, index, count, params); }
void ProgramLocalParameter4dARB(Context &c_, GLenum target, GLuint index, GLdouble x, GLdouble y, GLdouble z, GLdouble w) { return c_.host->ProgramLocalParameter4dARB(target, index, x, y, z, w); }
void ProgramLocalParameter4dvARB(Context &c_, GLenum target, GLuint index, const GLdouble * params) { return c_.host->ProgramLocalParameter4dvARB(target, index, params); }
void ProgramLocalParameter4fARB(Context &c_, GLenum target, GLuint index, GLfloat x, GLfloat y, GLfloat z, GLfloat w) { return c_.host->ProgramLocalParameter4fARB(target, index, x, y, z, w); }
void ProgramLocalParameter4fvARB(Context &c_, GLenum target, GLuint index, const GLfloat * params) { return c_.host->ProgramLocalParameter4fvARB(target, index, params); }
void ProgramLocalParameters4fvEXT(Context &c_, GLenum target, GLuint index, GLsizei count, const GLfloat * params) { return c_.host->ProgramLocalParameters4fvEXT(target, index, count, params); }
void ProgramStringARB(Context &c_, GLenum target, GLenum format, GLsizei len, const void * string) { return c_.host->ProgramStringARB(target, format, len, string); }
void PushAttrib(Context &c_, GLbitfield mask) { return c_.host->PushAttrib(mask); }
void ReadBuffer(Context &c_, GLenum src) { return c_.host->ReadBuffer(src); }
void TexParameterf(Context &c_, GLenum target, GLenum pname, GLfloat param) { return c_.host->TexParameterf(target, pname, param); }
void TexParameterfv(Context &c_, GLenum target, GLenum pname, const GLfloat * params) { return c_.host->TexParameterfv(target, pname, params); }
void TexParameteri(Context &c_, GLenum target, GLenum pname, GLint param) { return c_.host->TexParameteri(target, pname, param); }
void TexParameteriv(Context &c_, GLenum target, GLenum pname, const GLint * params) { return c_.host->TexParameteriv(target, pname, params); }
void UseProgram(Context &c_, GLuint program) { return c_.host->UseProgram(program); }
}}
