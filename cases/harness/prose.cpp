#include "cases/harness/prose.hpp"

#include <fmt/format.h>

#include <map>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace plumbline {
namespace {

struct Section {
  std::string heading;
  std::vector<std::string> lines;
};

struct Text {
  std::string name, title;
  std::vector<Section> sections;

  std::invalid_argument wrong(const std::string& heading, const std::string& what) const {
    return std::invalid_argument(fmt::format("{}.md: {}: {}", name, heading, what));
  }
  const Section* find(const std::string& heading) const {
    for (const Section& section : sections) {
      if (section.heading == heading) return &section;
    }
    return nullptr;
  }
  const Section& wanted(const std::string& heading) const {
    if (const Section* section = find(heading)) return *section;
    throw wrong("## " + heading, "is not there");
  }
};

Text divided(const std::string& name, const std::string& markdown);

// Puts in what other texts say below the same heading.
void put_in(Text& text, const TextOf& text_of) {
  for (Section& section : text.sections) {
    std::vector<std::string> lines;
    for (const std::string& line : section.lines) {
      if (!line.starts_with("{{") || !line.ends_with("}}")) {
        lines.push_back(line);
        continue;
      }
      const std::string other = line.substr(2, line.size() - 4);
      const std::vector<std::string> more = divided(other, text_of(other)).wanted(section.heading).lines;
      lines.insert(lines.end(), more.begin(), more.end());
      while (!lines.empty() && lines.back().empty()) lines.pop_back();
    }
    section.lines = std::move(lines);
  }
}

Text divided(const std::string& name, const std::string& markdown) {
  Text text{name, {}, {}};
  std::istringstream in(markdown);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("## ")) {
      text.sections.push_back({line.substr(3), {}});
    } else if (line.starts_with("# ") && text.title.empty()) {
      text.title = line.substr(2);
    } else if (!text.sections.empty()) {
      text.sections.back().lines.push_back(line);
    } else if (!line.empty()) {
      throw text.wrong("# title", "comes first, not '" + line + "'");
    }
  }
  if (text.title.empty()) throw text.wrong("# title", "is not there");
  return text;
}

// Lines joined by a blank, paragraphs by an empty line.
std::string paragraphs(const Section& section) {
  std::string all;
  bool begins = true;
  for (const std::string& line : section.lines) {
    if (!line.empty()) all += (all.empty() ? "" : begins ? "\n\n" : " ") + line;
    begins = line.empty();
  }
  return all;
}

std::vector<std::string> items(const Text& text, const Section& section) {
  std::vector<std::string> all;
  for (const std::string& line : section.lines) {
    if (line.starts_with("- ")) {
      all.push_back(line.substr(2));
    } else if (line.starts_with("  ") && !all.empty()) {
      all.back() += line.substr(1);
    } else if (!line.empty()) {
      throw text.wrong("## " + section.heading, "no item of a list: '" + line + "'");
    }
  }
  return all;
}

std::vector<std::string> equations(const Text& text, const Section& section) {
  std::vector<std::string> all;
  for (const std::string& line : section.lines) {
    if (line.starts_with("    ")) {
      all.push_back(line.substr(4));
    } else if (!line.empty()) {
      throw text.wrong("## " + section.heading, "a line of code begins with four blanks, not '" + line + "'");
    }
  }
  return all;
}

void add_orders(const Text& text, const std::string& item, std::vector<Statement::TheoryOrder>& orders) {
  const std::size_t of = item.find(" of order "), why = item.find(": ", of);
  if (of == std::string::npos || why == std::string::npos)
    throw text.wrong("## Orders", "'MEASURE, ... of order NUMBER: why' is wanted, not '" + item + "'");
  const double order = std::stod(item.substr(of + 10, why - of - 10));
  for (std::size_t from = 0; from < of;) {
    const std::size_t end = std::min(item.find(", ", from), of);
    orders.push_back({item.substr(from, end - from), order, item.substr(why + 2)});
    from = end == of ? of : end + 2;
  }
}

constexpr const char* reference_heading = "Reference: ";

struct Written {
  const char *markdown, *sketch;
};
std::map<std::string, Written>& texts() {
  static std::map<std::string, Written> all;
  return all;
}
const Written& text_of(const std::string& name) {
  const auto text = texts().find(name);
  if (text == texts().end()) throw std::invalid_argument(name + ".md: is not there");
  return text->second;
}

}  // namespace

Statement parse_statement(const std::string& name, const std::string& markdown, const std::string& sketch,
                          const TextOf& text_of) {
  Text text = divided(name, markdown);
  put_in(text, text_of);
  Statement s;
  s.name = name;
  s.title = text.title;
  s.source = paragraphs(text.wanted("Source"));
  s.claim = paragraphs(text.wanted("Claim"));
  s.physics = paragraphs(text.wanted("Physics"));
  if (const Section* section = text.find("Equations")) s.equations = equations(text, *section);
  s.sketch = sketch;
  s.cells_along = paragraphs(text.wanted("Cells"));
  for (const Section& section : text.sections) {
    if (!section.heading.starts_with(reference_heading)) continue;
    s.reference_name = section.heading.substr(std::string(reference_heading).size());
    s.reference_text = paragraphs(section);
  }
  if (s.reference_name.empty()) throw text.wrong("## Reference: NAME", "is not there");
  s.reference_bound = paragraphs(text.wanted("Bound of the reference"));
  if (const Section* section = text.find("Orders")) {
    for (const std::string& item : items(text, *section)) add_orders(text, item, s.theory_orders);
  }
  if (const Section* section = text.find("Known limits")) s.known_limits = items(text, *section);
  return s;
}

const Statement& written_statement(const std::string& name) {
  static std::map<std::string, Statement> parsed;
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  const auto known = parsed.find(name);
  if (known != parsed.end()) return known->second;
  const Written& text = text_of(name);
  const auto other = [](const std::string& of) { return std::string(text_of(of).markdown); };
  return parsed.emplace(name, parse_statement(name, text.markdown, text.sketch, other)).first->second;
}

RegisterProse::RegisterProse(const char* name, const char* markdown, const char* sketch) {
  texts().emplace(name, Written{markdown, sketch});
}

}  // namespace plumbline
