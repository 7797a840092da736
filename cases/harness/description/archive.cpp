#include "cases/harness/description/archive.hpp"

#include <cmath>

namespace plumbline {

double Archive::Source::next() {
  if (left() == 0) throw ArchiveError(name + " has too few numbers");
  return (*values)[at++];
}

double Archive::Source::next_whole(double low, double high) {
  const double value = next();
  if (!(value >= low && value <= high) || value != std::floor(value)) {
    throw ArchiveError(name + " is no whole number in its range");
  }
  return value;
}

void Archive::Source::require_end() const {
  if (left() > 0) throw ArchiveError(name + " has too many numbers");
}

std::vector<double>& Archive::added(const std::string& name) {
  const auto [place, is_new] = written_.try_emplace(name);
  if (!is_new) throw std::logic_error(name + " is kept twice");
  return place->second;
}

const std::vector<double>& Archive::taken(const std::string& name) {
  const auto found = kept_->find(name);
  if (found == kept_->end()) throw ArchiveError(name + " is missing");
  read_.insert(name);
  return found->second;
}

void Archive::require_all_read() const {
  if (!reads()) return;
  for (const auto& [name, values] : *kept_) {
    if (read_.count(name) == 0) throw ArchiveError(name + " belongs to nothing");
  }
}

}  // namespace plumbline
