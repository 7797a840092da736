// JSON from files that anybody may have written, and to files that everybody may read.
#pragma once

#include <string>

#include "cases/harness/files/json.hpp"

namespace plumbline {

// Deeper than any document of ours: what copies or prints a document calls itself once per level.
inline constexpr int deepest_json = 64;

// Throws Json::exception for what is no JSON or nests deeper.
Json parse_json(const std::string& text);

// The document as JSON, `indent` blanks a level, all in one line if negative. Text in it may be anybody's: what is no UTF-8 of it
// is replaced, so that the whole is.
std::string json_text(const Json& document, int indent = -1);

// What is wrong, for somebody who knows the text and not the library that reads it.
std::string fault_of(const Json::exception& error);

// The text with a replacement sign for each byte that is no UTF-8.
std::string valid_utf8(const std::string& text);

}  // namespace plumbline
