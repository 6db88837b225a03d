#include "apps/tools/page/frame.h"

#include "apps/tools/page/html.h"
#include "apps/tools/page/parts.h"

namespace arbiter::tools {

std::string pageHead(std::string_view title) {
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
                     "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
                     "style-src 'unsafe-inline'; script-src '";
  html += kPageScriptHash;
  html += "'; base-uri 'none'; form-action 'none'\">\n"
          "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
          "<meta name=\"color-scheme\" content=\"light dark\">\n<title>";
  html += escapedAttribute(title);
  html += "</title>\n<style>\n";
  html += kPageStyle;
  return html + "</style></head><body>\n";
}

std::string sortableTable(std::span<const Column> columns) {
  std::string html = "<form id=find hidden><label>Filter <input type=search name=filter "
                     "autocomplete=off spellcheck=false></label> <label>Status <select name=status>"
                     "<option value=\"\">any</option></select></label> <output></output></form>\n"
                     "<div class=scroll tabindex=0 role=region aria-label=\"Table of programs\">"
                     "<table id=programs><thead><tr>";
  for (const Column &column : columns) {
    html += std::string("<th scope=col data-k=\"") + column.key + "\"";
    html += column.numeric ? " class=n" : "";
    if (*column.hint)
      html += " title=\"" + escapedAttribute(column.hint) + "\"";
    html += std::string("><button type=button>") + column.title + "</button></th>";
  }
  return html + "</tr></thead><tbody>\n";
}

std::string pageFoot() {
  // The hash covers exactly the bytes between the tags.
  return "<script>" + std::string(kPageScript) + "</script></body></html>\n";
}

} // namespace arbiter::tools
