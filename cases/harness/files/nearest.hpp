// "Did you mean": the known names most like a mistyped one.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

// At most `most` of the names, best first; each once. The distance counts inserted, dropped, replaced and
// swapped neighbouring letters (Damerau-Levenshtein, optimal string alignment), upper and lower case alike.
// A name of which `wrong` (two letters or more) is the beginning or a part between separators (. - _) has
// distance at most 1. A name farther than a third of the longer length (at least 1), or with no letter in
// common, is not offered. Ties: longer common beginning first, then the order given.
std::vector<std::string> nearest(std::string_view wrong, std::span<const std::string> names, std::size_t most = 3);

}  // namespace plumbline
