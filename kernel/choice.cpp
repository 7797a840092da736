#include "kernel/choice.hpp"

namespace plumbline {
namespace {

std::vector<CollectedPart>* collected = nullptr;  // where registrations go while a plug-in is loaded

}  // namespace

std::string name_refusal(const std::string& name) {
  constexpr std::size_t longest = 63;
  const auto letter_or_digit = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); };
  const bool whole = std::all_of(name.begin(), name.end(),
                                 [&](char c) { return letter_or_digit(c) || c == '.' || c == '_' || c == '-'; });
  if (whole && !name.empty() && letter_or_digit(name.front()) && name.size() <= longest) return {};
  return "a name has 1 to 63 characters of a-z, 0-9, '.', '_' and '-', the first a letter or a digit";
}

std::vector<CollectedPart> collect_parts(const std::function<void()>& load) {
  struct Collecting {
    explicit Collecting(std::vector<CollectedPart>& into) { collected = &into; }
    ~Collecting() { collected = nullptr; }
  };
  std::vector<CollectedPart> found;
  const Collecting now(found);
  load();
  return found;
}

void register_or_collect(CollectedPart part) {
  if (collected) {
    collected->push_back(std::move(part));
  } else {
    part.add();
  }
}

}  // namespace plumbline
