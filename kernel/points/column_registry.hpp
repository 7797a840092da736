// All columns that the program knows, whoever declared them.
#pragma once

#include <vector>

#include "kernel/points/column_names.hpp"

namespace plumbline {

// In the order of ColumnId::index(), which may differ from one build to the next.
std::vector<ColumnId> registered_columns();

}  // namespace plumbline
