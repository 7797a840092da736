#include "kernel/transfers/transfer.hpp"

#include <stdexcept>
#include <utility>

namespace plumbline {
namespace {

std::vector<TransferEntry>& registered() {
  static std::vector<TransferEntry> all;
  return all;
}

}  // namespace

const std::vector<TransferEntry>& transfers() { return registered(); }

const TransferEntry& transfer_named(const std::string& name) { return named(registered(), name, TransferEntry::kind); }

Transfer transfer_of(const std::string& name, int order) {
  const TransferEntry& entry = transfer_named(name);
  Transfer transfer = entry.does;
  if (!entry.has_order) return transfer;
  if (order < 1) throw std::invalid_argument("the order of " + name + " is at least 1, not " + std::to_string(order));
  transfer.order = order;
  return transfer;
}

std::string transfer_in_words(const std::string& name, int order) {
  const TransferEntry* entry = find_named(registered(), name);
  return entry && entry->has_order ? name + std::to_string(order) : name;
}

void add_part(TransferEntry entry) {
  const Transfer& does = entry.does;
  const bool otherwise = does.affine || does.filters_end || entry.has_order;
  if (!(does.keep >= 0 && does.keep <= 1) || (does.keep > 0 && otherwise))
    throw std::logic_error("transfer " + entry.name +
                           ": keep is within [0, 1], and 0 where points take velocities otherwise");
  add_named(registered(), std::move(entry), TransferEntry::kind);
}

}  // namespace plumbline
