// Which velocity information goes back and forth between points and grid. Each transfer registers itself in its own source file.
#pragma once

#include <string>
#include <vector>

#include "kernel/choice.hpp"

namespace plumbline {

// What the loops over points do for a transfer.
struct Transfer {
  bool affine = false;       // points carry C_p beside v_p
  double keep = 0;           // alpha of v_p <- alpha (v_p + sum N dv) + (1 - alpha) sum N v~ [Blend 1]; flip 1, pic 0
  int order = 0;             // m of a filter on the nodes, kernel/engine/velocity_filter.hpp; 0: no filter
  bool filters_end = false;  // it filters v~ instead of v
};

struct TransferEntry : Choice {
  static constexpr const char* kind = "transfer";
  Transfer does;
  bool has_order = false;  // a scene chooses m
};

// In the order of their names.
const std::vector<TransferEntry>& transfers();

// Throws std::invalid_argument for an unknown name.
const TransferEntry& transfer_named(const std::string& name);

// What the loops do; order: m, where the transfer has one. Throws std::invalid_argument for an unknown name or an order below 1.
Transfer transfer_of(const std::string& name, int order);

// "xpic3", of a transfer without an order its name.
std::string transfer_in_words(const std::string& name, int order);

// Takes one in: RegisterPart. keep outside of [0, 1], or with another way to take velocities, throws std::logic_error.
void add_part(TransferEntry entry);

}  // namespace plumbline
