// What a case says of itself, as it is written beside its code: NAME.md, and NAME.svg for its sketch. The build takes both in.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cases/harness/description/case.hpp"

namespace plumbline {

// A text in Markdown: `# title`, then sections below `## headings`. A line `{{OTHER}}` stands for the lines below the same
// heading of OTHER.md. All functions throw std::invalid_argument, which names text and heading, for what is not there or has
// another form.
class Prose {
 public:
  using TextOf = std::function<std::string(const std::string& name)>;
  Prose(std::string name, const std::string& markdown, const TextOf& text_of);

  const std::string& name() const { return name_; }
  const std::string& title() const { return title_; }
  bool has(const std::string& heading) const;
  // The one heading that begins so, without that.
  std::string rest_of_heading(const std::string& begin) const;
  // Lines joined by blanks, paragraphs by an empty line.
  std::string paragraphs(const std::string& heading) const;
  // What follows each `- `, its lines joined; none where there is no such heading.
  std::vector<std::string> items(const std::string& heading) const;
  // Lines of code, without the four blanks that they begin with; none where there is no such heading.
  std::vector<std::string> code(const std::string& heading) const;
  std::invalid_argument wrong(const std::string& heading, const std::string& what) const;

 private:
  struct Section {
    std::string heading;
    std::vector<std::string> lines;
  };
  void divide(const std::string& markdown);
  const Section* find(const std::string& heading) const;
  const Section& wanted(const std::string& heading) const;
  std::string name_, title_;
  std::vector<Section> sections_;
};

// The text of this name among those that the build took in, and its sketch.
Prose written_prose(const std::string& name);
std::string written_sketch(const std::string& name);

// Sections: Source, Claim, Physics, [Equations] (code), [Cells], Reference: NAME, Bound of the reference, [Orders] (items
// `MEASURE, ... of order NUMBER: why`, the number as 2 or 4/3), [Known limits] (items).
Statement statement_of(const Prose& prose, std::string sketch);

// The keys of the items `KEY: why` of the section [Numerical keys].
std::vector<std::string> numerical_keys(const Prose& prose);

// Whether a key of a case chooses how its problem is solved, and not which one it is: all keys of schemes do, and of the case's own
// those that its text says. Throws std::invalid_argument where the text names a key that is none of its own.
bool is_numerical(const Case& entry, const std::string& key);

// Of the source that the build makes of the texts.
struct RegisterProse {
  RegisterProse(const char* name, const char* markdown, const char* sketch);
};

}  // namespace plumbline
