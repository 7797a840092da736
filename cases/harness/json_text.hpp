// JSON from files that anybody may have written.
#pragma once

#include <string>

#include "cases/harness/documents.hpp"

namespace plumbline {

// Deeper than any document of ours: what copies or prints a document calls itself once per level.
inline constexpr int deepest_json = 64;

// Throws Json::exception for what is no JSON or nests deeper.
Json parse_json(const std::string& text);

// The text with a replacement sign for each byte that is no UTF-8.
std::string valid_utf8(const std::string& text);

}  // namespace plumbline
