#include "cases/harness/files/whole.hpp"

#include <fmt/format.h>

#include <limits>

#include "cases/harness/files/errors.hpp"

namespace plumbline {

int whole(double count) {
  constexpr double most = std::numeric_limits<int>::max();
  if (count >= -most && count <= most) return static_cast<int>(count);
  const std::string value = fmt::format("{:.3g}", count), allowed = fmt::format("at most {:.0f}", most);
  throw UsageError("cells", value, allowed, {},
                   fmt::format("these choices make a scene of {} cells or points along a line: {}", value, allowed));
}

}  // namespace plumbline
