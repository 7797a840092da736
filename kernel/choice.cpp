#include "kernel/choice.hpp"

namespace plumbline {

std::string name_refusal(const std::string& name) {
  constexpr std::size_t longest = 63;
  const auto letter_or_digit = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); };
  const bool whole = std::all_of(name.begin(), name.end(),
                                 [&](char c) { return letter_or_digit(c) || c == '.' || c == '_' || c == '-'; });
  if (whole && !name.empty() && letter_or_digit(name.front()) && name.size() <= longest) return {};
  return "a name has 1 to 63 characters of a-z, 0-9, '.', '_' and '-', the first a letter or a digit";
}

}  // namespace plumbline
