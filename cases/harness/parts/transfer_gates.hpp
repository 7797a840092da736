// Gates that any transfer must meet, in each geometry of a shape.
#pragma once

#include <vector>

#include "cases/harness/judge/measured_gates.hpp"
#include "kernel/shapes/shape.hpp"
#include "kernel/transfers/transfer.hpp"

namespace plumbline {

// What a transfer claims is what it does for affine velocities, its order where it has one, and the traits that it offers.
std::vector<MeasuredGate> transfer_gates(const TransferEntry& transfer, const ShapeEntry& shape);

// How much of a wave one pass takes, and the order in k h with which that vanishes.
std::vector<MeasuredGate> transfer_filter_gates(const TransferEntry& transfer, const ShapeEntry& shape);

}  // namespace plumbline
