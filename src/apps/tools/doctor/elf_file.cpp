#include "apps/tools/doctor/elf_file.h"

#include <algorithm>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <gelf.h>
#include <iterator>
#include <libelf.h>
#include <memory>
#include <unistd.h>

namespace arbiter::tools::doctor {

namespace {

/// Owns a file descriptor and libelf's handle for it.
class Handle {
public:
  explicit Handle(const std::string &path)
      : m_descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK)) {
    if (m_descriptor >= 0 && elf_version(EV_CURRENT) != EV_NONE)
      m_elf = elf_begin(m_descriptor, ELF_C_READ, nullptr);
  }
  ~Handle() {
    elf_end(m_elf);
    if (m_descriptor >= 0)
      ::close(m_descriptor);
  }
  Handle(const Handle &) = delete;
  Handle &operator=(const Handle &) = delete;

  [[nodiscard]] Elf *get() const { return m_elf; }

private:
  int m_descriptor;
  Elf *m_elf = nullptr;
};

std::string textAt(Elf *elf, std::size_t section, std::size_t offset) {
  const char *const text = elf_strptr(elf, section, offset);
  return text == nullptr ? std::string() : text;
}

std::vector<std::string> split(const std::string &list) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t end = std::min(list.find(':', at), list.size());
    if (end != at)
      parts.push_back(list.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

void readInterpreter(Elf *elf, ElfFile &file) {
  std::size_t count = 0;
  if (elf_getphdrnum(elf, &count) != 0)
    return;
  std::size_t bytes = 0;
  const char *const raw = elf_rawfile(elf, &bytes);
  for (std::size_t i = 0; i < count; ++i) {
    GElf_Phdr header;
    if (gelf_getphdr(elf, int(i), &header) == nullptr || header.p_type != PT_INTERP)
      continue;
    if (raw != nullptr && header.p_offset < bytes && header.p_filesz <= bytes - header.p_offset)
      file.interpreter.assign(raw + header.p_offset,
                              strnlen(raw + header.p_offset, header.p_filesz));
  }
}

void readDynamic(Elf *elf, Elf_Scn *section, const GElf_Shdr &header, ElfFile &file) {
  Elf_Data *const data = elf_getdata(section, nullptr);
  if (data == nullptr || header.sh_entsize == 0)
    return;
  for (std::size_t i = 0; i < header.sh_size / header.sh_entsize; ++i) {
    GElf_Dyn row;
    if (gelf_getdyn(data, int(i), &row) == nullptr || row.d_tag == DT_NULL)
      return;
    const auto text = [&] { return textAt(elf, header.sh_link, row.d_un.d_val); };
    if (row.d_tag == DT_NEEDED)
      file.needed.push_back(text());
    else if (row.d_tag == DT_SONAME)
      file.soname = text();
    else if (row.d_tag == DT_RPATH)
      file.rpath = split(text());
    else if (row.d_tag == DT_RUNPATH)
      file.runpath = split(text());
  }
}

void readSymbols(Elf *elf, Elf_Scn *section, const GElf_Shdr &header, ElfFile &file) {
  Elf_Data *const data = elf_getdata(section, nullptr);
  if (data == nullptr || header.sh_entsize == 0)
    return;
  for (std::size_t i = 0; i < header.sh_size / header.sh_entsize; ++i) {
    GElf_Sym symbol;
    if (gelf_getsym(data, int(i), &symbol) == nullptr)
      return;
    std::string name = textAt(elf, header.sh_link, symbol.st_name);
    if (name.empty())
      continue;
    if (symbol.st_shndx == SHN_UNDEF)
      file.imports.push_back(std::move(name));
    else if (GELF_ST_TYPE(symbol.st_info) == STT_FUNC)
      file.exports.push_back(std::move(name));
  }
}

} // namespace

bool ElfFile::needs(std::string_view library) const {
  return std::find(needed.begin(), needed.end(), library) != needed.end();
}

std::optional<ElfFile> readElf(const std::string &path) {
  const Handle handle(path);
  Elf *const elf = handle.get();
  GElf_Ehdr header;
  if (elf == nullptr || elf_kind(elf) != ELF_K_ELF || gelf_getehdr(elf, &header) == nullptr)
    return std::nullopt;
  ElfFile file;
  file.bits = gelf_getclass(elf) == ELFCLASS32 ? 32 : 64;
  file.machine = header.e_machine;
  file.executable = header.e_type == ET_EXEC || header.e_type == ET_DYN;
  readInterpreter(elf, file);
  for (Elf_Scn *section = elf_nextscn(elf, nullptr); section != nullptr;
       section = elf_nextscn(elf, section)) {
    GElf_Shdr row;
    if (gelf_getshdr(section, &row) == nullptr)
      break;
    if (row.sh_type == SHT_DYNAMIC)
      readDynamic(elf, section, row, file);
    else if (row.sh_type == SHT_DYNSYM)
      readSymbols(elf, section, row, file);
  }
  return file;
}

std::string machineName(std::uint16_t machine) {
  switch (machine) {
  case EM_X86_64:
    return "x86-64";
  case EM_386:
    return "i386";
  case EM_AARCH64:
    return "AArch64";
  case EM_ARM:
    return "ARM";
  default:
    return "machine " + std::to_string(machine);
  }
}

std::vector<std::string> libraryNames(const std::string &path,
                                      const std::vector<std::string_view> &words) {
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  std::vector<std::string> names;
  const auto printable = [](char c) { return c > 0x20 && c < 0x7F; };
  for (std::size_t at = 0; (at = bytes.find(".so", at)) != std::string::npos; ++at) {
    std::size_t begin = at, end = at;
    while (begin > 0 && printable(bytes[begin - 1]) && at - begin < 4096)
      --begin;
    while (end < bytes.size() && printable(bytes[end]))
      ++end;
    if (end == bytes.size() || bytes[end] != '\0')
      continue;
    std::string name = bytes.substr(begin, end - begin);
    const std::string last = name.substr(name.rfind('/') + 1);
    const bool one = std::any_of(words.begin(), words.end(),
                                 [&](std::string_view word) { return last.starts_with(word); });
    if (one && std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(std::move(name));
  }
  return names;
}

} // namespace arbiter::tools::doctor
