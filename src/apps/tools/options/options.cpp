#include "apps/tools/options/options.h"

#include "apps/tools/options/verbs.h"

namespace arbiter::tools {

void addVerbs(CLI::App &app, Arguments &arguments) {
  useOwnWords(app);
  addCheck(app, arguments.check);
  addCompile(app, arguments.compile);
  addDraw(app, arguments.draw);
  addDebug(app, arguments.debug);
  addRun(app, arguments.run);
  addDefaults(app, arguments.defaults);
  addDoctor(app, arguments.doctor);
  addStats(app, arguments.stats);
  addCapture(app, arguments.capture);
  addReport(app, arguments.report);
  addProfiles(app, arguments.profiles);
  addCache(app, arguments.cache);
  addCtl(app, arguments.ctl);
  addRender(app, arguments.render);
  addLsp(app, arguments.lsp);
  Verb(app, kDrawsVerb, "").hide();
  Verb(app, kCompleteVerb, "").hide();
  addBuilder(app, arguments.builder);
  addHelp(app, arguments.helpOf);
}

} // namespace arbiter::tools
