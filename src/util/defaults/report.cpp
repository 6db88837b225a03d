#include "util/defaults/report.h"

namespace arbiter::defaults {

namespace {

void writeStrings(JsonWriter &json, const char *key, const std::vector<std::string> &strings) {
  if (strings.empty())
    return;
  json.key(key).beginArray();
  for (const std::string &each : strings)
    json.value(each);
  json.endArray();
}

void writeText(JsonWriter &json, const std::string &text) {
  if (text.empty())
    json.null();
  else
    json.value(text);
}

void writeSetting(JsonWriter &json, const Setting &setting) {
  json.key(setting.key->name).beginObject();
  json.key("value");
  writeText(json, setting.value->text);
  json.key("file").value(setting.entry->file);
  json.key("line").value(setting.value->line);
  json.key("title").value(setting.entry->title);
  json.key("used").value(setting.used);
  json.endObject();
}

} // namespace

void writeEntry(JsonWriter &json, const Entry &entry) {
  json.beginObject();
  json.key("title").value(entry.title);
  json.key("file").value(entry.file);
  json.key("line").value(entry.line);
  json.key("match").beginObject();
  writeStrings(json, "name", entry.match.names);
  writeStrings(json, "path", entry.match.paths);
  writeStrings(json, "windows", entry.match.windows);
  writeStrings(json, "xxh128", entry.match.hashes);
  json.endObject();
  json.key("set").beginObject();
  for (const Value &value : entry.values)
    for (const Key &key : keys())
      if (key.variable == value.variable) {
        json.key(key.name);
        writeText(json, value.text);
      }
  json.endObject();
  json.key("source").beginArray();
  for (const std::string &source : entry.sources)
    json.value(source);
  json.endArray();
  json.key("note").value(entry.note);
  json.endObject();
}

void writeChoice(JsonWriter &json, const Choice *choice) {
  if (choice == nullptr) {
    json.null();
    return;
  }
  json.beginObject();
  json.key("program").beginObject();
  json.key("name").value(choice->program.name);
  json.key("path").value(choice->program.path);
  json.key("windows");
  writeText(json, choice->program.windows);
  json.key("windows_path");
  writeText(json, choice->program.windowsPath);
  json.endObject();
  json.key("entries").beginArray();
  for (const Chosen &chosen : choice->entries) {
    json.beginObject();
    json.key("title").value(chosen.entry->title);
    json.key("file").value(chosen.entry->file);
    json.key("line").value(chosen.entry->line);
    json.key("why").value(chosen.why);
    json.endObject();
  }
  json.endArray();
  json.key("settings").beginObject();
  for (const Setting &setting : choice->settings)
    writeSetting(json, setting);
  json.endObject();
  json.key("errors").beginArray();
  for (const File &file : choice->files)
    for (const std::string &error : file.errors)
      json.value(error);
  json.endArray();
  json.endObject();
}

} // namespace arbiter::defaults
