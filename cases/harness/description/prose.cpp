#include "cases/harness/description/prose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace plumbline {
namespace {

struct Written {
  const char *markdown, *sketch;
};
std::map<std::string, Written>& texts() {
  static std::map<std::string, Written> all;
  return all;
}
const Written& written(const std::string& name) {
  const auto text = texts().find(name);
  if (text == texts().end()) throw std::invalid_argument(name + ".md: is not there");
  return text->second;
}

// "2" or "4/3"; none of anything else.
std::optional<double> order_of(std::string_view text) {
  double upper = 0, lower = 1;
  const char* const end = text.data() + text.size();
  auto read = std::from_chars(text.data(), end, upper);
  if (read.ec == std::errc() && read.ptr != end && *read.ptr == '/') read = std::from_chars(read.ptr + 1, end, lower);
  if (read.ec != std::errc() || read.ptr != end || !std::isfinite(upper / lower)) return std::nullopt;
  return upper / lower;
}

// "A, B of order 1: why" as two orders.
void add_orders(const Prose& prose, const std::string& item, std::vector<Statement::TheoryOrder>& orders) {
  const std::string between = " of order ";
  const std::size_t of = item.find(between), why = item.find(": ", of);
  if (of == std::string::npos || why == std::string::npos)
    throw prose.wrong("Orders", "'MEASURE, ... of order NUMBER: why' is wanted, not '" + item + "'");
  const std::string number = item.substr(of + between.size(), why - of - between.size());
  const std::optional<double> order = order_of(number);
  if (!order) throw prose.wrong("Orders", "'" + number + "' is no order: '2' or '4/3' is wanted");
  for (std::size_t from = 0; from < of;) {
    const std::size_t end = std::min(item.find(", ", from), of);
    orders.push_back({item.substr(from, end - from), *order, item.substr(why + 2)});
    from = end == of ? of : end + 2;
  }
}

}  // namespace

Prose::Prose(std::string name, const std::string& markdown, const TextOf& text_of) : name_(std::move(name)) {
  divide(markdown);
  for (Section& section : sections_) {
    std::vector<std::string> lines;
    for (const std::string& line : section.lines) {
      if (!line.starts_with("{{") || !line.ends_with("}}")) {
        lines.push_back(line);
        continue;
      }
      const std::string other = line.substr(2, line.size() - 4);
      const Prose shared(other, text_of(other), text_of);
      for (const std::string& more : shared.wanted(section.heading).lines) {
        if (!more.empty()) lines.push_back(more);
      }
    }
    section.lines = std::move(lines);
  }
}

void Prose::divide(const std::string& markdown) {
  std::istringstream in(markdown);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("## ")) {
      sections_.push_back({line.substr(3), {}});
    } else if (line.starts_with("# ") && title_.empty() && sections_.empty()) {
      title_ = line.substr(2);
    } else if (!sections_.empty()) {
      sections_.back().lines.push_back(line);
    } else if (!line.empty()) {
      throw wrong("# title", "comes first, not '" + line + "'");
    }
  }
  if (title_.empty()) throw wrong("# title", "is not there");
}

std::invalid_argument Prose::wrong(const std::string& heading, const std::string& what) const {
  return std::invalid_argument(fmt::format("{}.md: {}: {}", name_, heading, what));
}

const Prose::Section* Prose::find(const std::string& heading) const {
  const auto found = std::find_if(sections_.begin(), sections_.end(),
                                  [&](const Section& section) { return section.heading == heading; });
  return found == sections_.end() ? nullptr : &*found;
}

const Prose::Section& Prose::wanted(const std::string& heading) const {
  if (const Section* section = find(heading)) return *section;
  throw wrong(heading, "is not there");
}

bool Prose::has(const std::string& heading) const { return find(heading) != nullptr; }

std::string Prose::rest_of_heading(const std::string& begin) const {
  for (const Section& section : sections_) {
    if (section.heading.starts_with(begin)) return section.heading.substr(begin.size());
  }
  throw wrong(begin, "is not there");
}

std::string Prose::paragraphs(const std::string& heading) const {
  std::string all;
  bool begins = true;
  for (const std::string& line : wanted(heading).lines) {
    if (!line.empty()) all += (all.empty() ? "" : begins ? "\n\n" : " ") + line;
    begins = line.empty();
  }
  return all;
}

std::vector<std::string> Prose::items(const std::string& heading) const {
  std::vector<std::string> all;
  if (!has(heading)) return all;
  for (const std::string& line : wanted(heading).lines) {
    if (line.starts_with("- ")) {
      all.push_back(line.substr(2));
    } else if (line.starts_with("  ") && !all.empty()) {
      all.back() += line.substr(1);
    } else if (!line.empty()) {
      throw wrong(heading, "no item of a list: '" + line + "'");
    }
  }
  return all;
}

std::vector<std::string> Prose::code(const std::string& heading) const {
  std::vector<std::string> all;
  if (!has(heading)) return all;
  for (const std::string& line : wanted(heading).lines) {
    if (line.starts_with("    ")) {
      all.push_back(line.substr(4));
    } else if (!line.empty()) {
      throw wrong(heading, "a line of code begins with four blanks, not '" + line + "'");
    }
  }
  return all;
}

Prose written_prose(const std::string& name) {
  return {name, written(name).markdown, [](const std::string& other) { return written(other).markdown; }};
}

std::string written_sketch(const std::string& name) { return written(name).sketch; }

Statement statement_of(const Prose& prose, std::string sketch) {
  Statement s;
  s.name = prose.name();
  s.title = prose.title();
  s.source = prose.paragraphs("Source");
  s.claim = prose.paragraphs("Claim");
  s.physics = prose.paragraphs("Physics");
  s.equations = prose.code("Equations");
  s.sketch = std::move(sketch);
  if (prose.has("Cells")) s.cells_along = prose.paragraphs("Cells");
  const std::string reference = "Reference: ";
  s.reference_name = prose.rest_of_heading(reference);
  s.reference_text = prose.paragraphs(reference + s.reference_name);
  s.reference_bound = prose.paragraphs("Bound of the reference");
  for (const std::string& item : prose.items("Orders")) add_orders(prose, item, s.theory_orders);
  s.known_limits = prose.items("Known limits");
  return s;
}

std::vector<std::string> numerical_keys(const Prose& prose) {
  const std::string heading = "Numerical keys";
  std::vector<std::string> keys;
  for (const std::string& item : prose.items(heading)) {
    const std::size_t end = item.find(": ");
    if (end == std::string::npos) throw prose.wrong(heading, "'KEY: why' is wanted, not '" + item + "'");
    keys.push_back(item.substr(0, end));
  }
  return keys;
}

bool is_numerical(const Case& entry, const std::string& key) {
  const auto is_own = [&entry](const std::string& name) {
    return std::any_of(entry.keys.begin(), entry.keys.end(), [&](const Key& own) { return own.name == name; });
  };
  if (!is_own(key)) return true;
  const Prose prose = written_prose(entry.name);
  const std::vector<std::string> said = numerical_keys(prose);
  const auto unknown = std::find_if_not(said.begin(), said.end(), is_own);
  if (unknown != said.end()) throw prose.wrong("Numerical keys", "the case has no key '" + *unknown + "' of its own");
  return std::find(said.begin(), said.end(), key) != said.end();
}

RegisterProse::RegisterProse(const char* name, const char* markdown, const char* sketch) {
  texts().emplace(name, Written{markdown, sketch});
}

}  // namespace plumbline
