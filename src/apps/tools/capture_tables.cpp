#include "apps/tools/capture_tables.h"

#include <cstdio>

#include "apps/tools/page/html.h"

namespace arbiter::tools {

std::string parameterTable(const CapturedProgram &program) {
  std::string html =
      "<table><tr><th>parameter at last use</th><th>x</th><th>y</th><th>z</th><th>w</th></tr>\n";
  for (const CapturedParameter &parameter : program.parameters) {
    html += "<tr>" + cell("<code>" + escaped(parameter.name) + "</code>");
    for (const double component : parameter.value) {
      char text[48];
      std::snprintf(text, sizeof text, "<td class=n>%.9g</td>", component);
      html += text;
    }
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

std::string textureTable(const CapturedProgram &program) {
  std::string html = "<table><tr><th>unit</th><th>target</th><th>texture</th><th>size</"
                     "th><th>format</th><th>enabled</th></tr>\n";
  for (const CapturedTexture &texture : program.textures) {
    std::string enabled;
    for (const std::string &name : texture.enabled)
      enabled += (enabled.empty() ? "" : " ") + name;
    html += "<tr>" + numberCell(texture.unit) + cell(escaped(texture.target)) +
            numberCell(texture.name) +
            cell(number(texture.width) + "&times;" + number(texture.height) + "&times;" +
                 number(texture.depth)) +
            cell(escaped(texture.format)) + cell(escaped(enabled)) + "</tr>\n";
  }
  return html + "</table>\n";
}

} // namespace arbiter::tools
