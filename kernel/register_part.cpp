#include "kernel/register_part.hpp"

#include <cstring>
#include <stdexcept>

namespace plumbline {

const PluginStamp& part_stamp() { return part_stamp_of_this_file; }

void want_part_stamp(const PluginStamp& built_against) {
  if (std::memcmp(built_against.text, part_stamp().text, sizeof built_against.text) != 0)
    throw std::logic_error("a part was built against another kernel");
}

}  // namespace plumbline
