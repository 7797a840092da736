#include "kernel/transfers/transfers.hpp"

#include <stdexcept>

namespace plumbline {

TransferChoice transfer_choice(const std::string& name, int order) {
  if (name == "pic") return {};
  if (name == "flip") return {.increments = true};
  if (name == "apic") return {.affine = true};
  if (name != "xpic" && name != "fmpm") throw std::invalid_argument("no transfer " + name);
  if (order < 1) throw std::invalid_argument("the order of " + name + " is at least 1, not " + std::to_string(order));
  return {.order = order, .filters_end = name == "fmpm"};
}

}  // namespace plumbline
