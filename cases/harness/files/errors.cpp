#include "cases/harness/files/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cases/harness/files/nearest.hpp"

namespace plumbline {

UsageError unknown_name(const std::string& what, const std::string& value, const std::vector<std::string>& known) {
  const auto offers = nearest(value, known);
  const std::string all = fmt::format("{}", fmt::join(known, ", "));
  const std::string hint = offers.empty() ? "" : fmt::format("; did you mean {}?", fmt::join(offers, ", "));
  return {what, value, all, offers, fmt::format("unknown {} '{}'{} (known: {})", what, value, hint, all)};
}

}  // namespace plumbline
