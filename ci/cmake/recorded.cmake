# Puts cases/regressions.json into a source, for the executable alone: it is no part of what makes a result, so that a new
# recording leaves stored runs as good as they were. Called with -DFILE and -DOUTPUT. A literal for each line: compilers need not
# take one above 65536 characters.
file(READ ${FILE} text)
string(STRIP "${text}" text)
string(REPLACE "\n" ")json\",\n    R\"json(" lines "${text}")
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT [[// Made by the build.
#include "cases/harness/commands/recorded.hpp"

namespace plumbline {
namespace {

constexpr const char* lines[] = {
    R"json(@lines@)json"};

}  // namespace

const Regressions& recorded_values() {
  static const Regressions values = [] {
    std::string text;
    for (const char* line : lines) text += line;
    return Regressions(parse_regressions(text, "cases/regressions.json"));
  }();
  return values;
}

}  // namespace plumbline
]] @ONLY)
