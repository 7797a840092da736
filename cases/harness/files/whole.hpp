// Counts of cells and points that follow from lengths, which users may choose as they like.
#pragma once

namespace plumbline {

// The number as an int; whole already. Throws UsageError where no int holds it.
int whole(double count);

}  // namespace plumbline
