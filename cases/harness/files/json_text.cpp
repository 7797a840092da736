#include "cases/harness/files/json_text.hpp"

#include <fmt/format.h>

namespace plumbline {

Json parse_json(const std::string& text) {
  return Json::parse(text, [](int depth, Json::parse_event_t, Json&) {
    if (depth > deepest_json)
      throw Json::other_error::create(501, fmt::format("nested more than {} deep", deepest_json), nullptr);
    return true;
  });
}

std::string json_text(const Json& document, int indent) {
  return document.dump(indent, ' ', false, Json::error_handler_t::replace);
}

std::string fault_of(const Json::exception& error) {
  const std::string text = error.what();
  const auto end = text.find("] ");
  return text.starts_with("[json.exception.") && end != std::string::npos ? text.substr(end + 2) : text;
}

std::string valid_utf8(const std::string& text) { return Json::parse(json_text(text)).get<std::string>(); }

}  // namespace plumbline
