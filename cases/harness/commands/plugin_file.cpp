#include "cases/harness/commands/plugin_file.hpp"

#include <elf.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <link.h>
#include <sys/stat.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <map>
#include <vector>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/json_text.hpp"
#include "kernel/register_part.hpp"
#include "kernel/time_integrator.hpp"

namespace plumbline {
namespace {

using Header = ElfW(Ehdr);
using Segment = ElfW(Phdr);
using Section = ElfW(Shdr);

constexpr unsigned char own_class = sizeof(void*) == 8 ? ELFCLASS64 : ELFCLASS32;
constexpr unsigned char own_data = std::endian::native == std::endian::little ? ELFDATA2LSB : ELFDATA2MSB;

class SharedLibrary {
 public:
  SharedLibrary(const std::string& path, const std::string& name)
      : name_(name),
        file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    struct stat found {};
    if (file_ < 0 || ::fstat(file_, &found) != 0) refuse(std::strerror(errno));
    if (!S_ISREG(found.st_mode)) refuse("no file of its own");
    size_ = static_cast<std::uint64_t>(found.st_size);
    read_header();
    read_segments();
    read_sections();
  }
  ~SharedLibrary() {
    if (file_ >= 0) ::close(file_);
  }
  SharedLibrary(const SharedLibrary&) = delete;
  SharedLibrary& operator=(const SharedLibrary&) = delete;

  [[noreturn]] void refuse(const std::string& why) const {
    throw FileError(name_, fmt::format("plug-in {}: {}", name_, why));
  }

  // What stands in the section; empty if there is none.
  std::string section(const std::string& name) const {
    if (header_.e_shstrndx >= sections_.size()) return {};
    const std::string names = content(sections_[header_.e_shstrndx]);
    for (const Section& section : sections_) {
      if (section.sh_name < names.size() && names.c_str() + section.sh_name == name) return content(section);
    }
    return {};
  }

 private:
  bool holds(std::uint64_t offset, std::uint64_t bytes) const { return offset <= size_ && bytes <= size_ - offset; }

  void read(std::uint64_t offset, void* to, std::uint64_t bytes) const {
    if (!holds(offset, bytes))
      refuse(fmt::format("truncated: it has {} bytes and places something at byte {}", size_, offset + bytes));
    const ssize_t count = ::pread(file_, to, bytes, static_cast<off_t>(offset));
    if (count < 0 || static_cast<std::uint64_t>(count) != bytes) refuse("cannot be read");
  }

  void read_header() {
    if (size_ < sizeof header_) refuse("not a shared library");
    read(0, &header_, sizeof header_);
    if (std::memcmp(header_.e_ident, ELFMAG, SELFMAG) != 0) refuse("not a shared library");
    if (header_.e_ident[EI_CLASS] != own_class || header_.e_ident[EI_DATA] != own_data)
      refuse("made for another kind of machine");
    if (header_.e_type != ET_DYN) refuse("not a shared library, but another ELF file");
  }

  // A table of entries, each of this size.
  template <class Entry>
  std::vector<Entry> table(std::uint64_t offset, std::uint64_t count, std::uint64_t entry) const {
    std::vector<Entry> all(count);
    if (count == 0) return all;
    if (entry != sizeof(Entry)) refuse("damaged: the entries of its tables have another size");
    read(offset, all.data(), count * sizeof(Entry));
    return all;
  }

  void read_segments() {
    for (const Segment& segment : table<Segment>(header_.e_phoff, header_.e_phnum, header_.e_phentsize))
      require(segment.p_offset, segment.p_filesz);
  }

  void read_sections() {
    sections_ = table<Section>(header_.e_shoff, header_.e_shnum, header_.e_shentsize);
    for (const Section& section : sections_) {
      if (section.sh_type != SHT_NOBITS && section.sh_type != SHT_NULL) require(section.sh_offset, section.sh_size);
    }
  }

  void require(std::uint64_t offset, std::uint64_t bytes) const {
    if (!holds(offset, bytes))
      refuse(fmt::format("truncated: it has {} bytes and places {} from byte {} on", size_, bytes, offset));
  }

  std::string content(const Section& section) const {
    std::string text(section.sh_type == SHT_NOBITS ? 0 : section.sh_size, '\0');
    if (!text.empty()) read(section.sh_offset, text.data(), text.size());
    return text;
  }

  std::string name_;
  int file_;
  std::uint64_t size_ = 0;
  Header header_{};
  std::vector<Section> sections_;
};

// The lines of a stamp by their first word.
std::map<std::string, std::string> lines_of(const std::string& stamp) {
  std::map<std::string, std::string> lines;
  for (std::size_t start = 0; start < stamp.size();) {
    const std::size_t end = std::min(stamp.find('\n', start), stamp.size()),
                      blank = std::min(stamp.find(' ', start), end);
    lines[stamp.substr(start, blank - start)] = blank < end ? stamp.substr(blank + 1, end - blank - 1) : "";
    start = end + 1;
  }
  return lines;
}

std::string difference(const std::string& stamp) {
  const auto theirs = lines_of(stamp);
  const auto registers = theirs.find("registers");
  const bool parts = registers != theirs.end() && registers->second == "parts";
  const auto ours = lines_of(parts ? part_stamp().text : kernel_stamp().text);
  for (const char* line : {"version", "compiler", "library", "headers", "layout"}) {
    const auto found = theirs.find(line);
    if (found == theirs.end() || found->second != ours.at(line)) {
      return fmt::format("{} {}, this program {}", line, found == theirs.end() ? "unknown" : valid_utf8(found->second),
                         ours.at(line));
    }
  }
  return "its stamp is damaged";
}

}  // namespace

void check_plugin_file(const std::string& path, const std::string& file) {
  const SharedLibrary library(path, file);
  const std::string stamps = library.section(PLUMBLINE_STAMP_SECTION);
  bool any = false;
  for (std::size_t start = stamps.find_first_not_of('\0'); start != std::string::npos;) {
    const std::size_t end = std::min(stamps.find('\0', start), stamps.size());
    const std::string stamp = stamps.substr(start, end - start);
    if (stamp != kernel_stamp().text && stamp != part_stamp().text)
      library.refuse(fmt::format("it was built for another Plumbline ({}): build it again", difference(stamp)));
    any = true;
    start = stamps.find_first_not_of('\0', end);
  }
  if (!any) library.refuse("it has no stamp of Plumbline's: it registers nothing, or was built for 0.6.0 or older");
}

}  // namespace plumbline
