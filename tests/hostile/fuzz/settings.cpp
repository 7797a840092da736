// Any lines as `--set` of any case and scheme: refused, or choices that are read back as they are written.
#include <cstdlib>
#include <sstream>

#include "cases/harness/description/case.hpp"
#include "cases/harness/files/errors.hpp"
#include "reference/parameter.hpp"
#include "tests/hostile/fuzz/memory_file.hpp"

namespace {

using namespace plumbline;

void require_same_when_typed(const Case& entry, const std::string& scheme, const Settings& settings) {
  std::vector<std::string> typed;
  for (const Key& key : settings.keys()) typed.push_back(key.name + "=" + to_text(key.value));
  if (!(entry.settings(scheme, {}, typed) == settings)) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size < 2) return 0;
  const Case& entry = *cases()[bytes[0] % cases().size()];
  const std::string scheme = bytes[1] % 2 == 0 ? "default" : "york1997";
  std::istringstream lines(std::string(bytes + 2, bytes + size));
  std::vector<std::string> typed;
  for (std::string line; std::getline(lines, line) && typed.size() < 8;) typed.push_back(line);
  try {
    require_same_when_typed(entry, scheme, entry.settings(scheme, {}, typed));
  } catch (const UsageError&) {
  } catch (const reference::ParameterError&) {}
  return 0;
}
