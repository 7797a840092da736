# Puts cases/regressions.json into a source, for the executable alone: it is no part of what makes a result, so that a new
# recording leaves stored runs as good as they were. Called with -DFILE and -DOUTPUT.
file(READ ${FILE} text)
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT [[// Made by the build.
#include "cases/commands/recorded.hpp"

namespace plumbline {

const Regressions& recorded_values() {
  static const Regressions values(parse_regressions(R"json(@text@)json", "cases/regressions.json"));
  return values;
}

}  // namespace plumbline
]] @ONLY)
