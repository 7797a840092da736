// What a case says of itself, as it is written beside its code: NAME.md, and NAME.svg for its sketch. The build takes both in.
#pragma once

#include <functional>
#include <string>

#include "cases/harness/case.hpp"

namespace plumbline {

// The statement of a text in Markdown: `# title`, then these headings, those in brackets where there is something to say:
// `## Source`, `## Claim`, `## Physics`, [`## Equations`, a line of code each], `## Cells`, `## Reference: NAME`,
// `## Bound of the reference`, [`## Orders`, items `- MEASURE, ... of order NUMBER: why`], [`## Known limits`, items]. Lines of a
// paragraph are joined. A line `{{OTHER}}` stands for the lines below the same heading of OTHER.md, which `text_of` knows. Throws
// std::invalid_argument naming case and heading.
using TextOf = std::function<std::string(const std::string& name)>;
Statement parse_statement(const std::string& name, const std::string& markdown, const std::string& sketch,
                          const TextOf& text_of);

// The statement of the case of this name; std::invalid_argument if there is no text of it.
const Statement& written_statement(const std::string& name);

// Of the sources that the build makes of the texts.
struct RegisterProse {
  RegisterProse(const char* name, const char* markdown, const char* sketch);
};

}  // namespace plumbline
