#include "cases/harness/commands/recorded.hpp"

namespace plumbline {
namespace {

constexpr const char* lines[] = {
#include "regressions.inc"
};

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
