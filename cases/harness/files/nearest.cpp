#include "cases/harness/files/nearest.hpp"

#include <algorithm>

namespace plumbline {
namespace {

// ASCII only: names of this program are ASCII, and the result must not depend on the locale.
std::string lower(std::string_view name) {
  std::string result(name);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

// Optimal string alignment: Levenshtein plus the swap of neighbours.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

bool has_part(std::string_view name, std::string_view part) {
  constexpr std::string_view separators = ".-_";
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find_first_of(separators, begin), name.size());
    if (name.substr(begin, end - begin) == part) return true;
    begin = end + 1;
  }
  return false;
}

std::size_t common_beginning(std::string_view a, std::string_view b) {
  const std::size_t length = std::min(a.size(), b.size());
  std::size_t k = 0;
  while (k < length && a[k] == b[k]) ++k;
  return k;
}

struct Candidate {
  const std::string* name;
  std::size_t distance;
  std::size_t beginning;
};

Candidate compare(const std::string& wrong, const std::string& name) {
  const std::string known = lower(name);
  std::size_t distance = edit_distance(wrong, known);
  if (wrong.size() >= 2 && (known.starts_with(wrong) || has_part(known, wrong)))
    distance = std::min<std::size_t>(distance, 1);
  return {&name, distance, common_beginning(wrong, known)};
}

bool is_near(const Candidate& candidate, std::size_t wrong_size) {
  const std::size_t longer = std::max(candidate.name->size(), wrong_size);
  return candidate.distance < longer && candidate.distance <= std::max<std::size_t>(1, longer / 3);
}

}  // namespace

std::vector<std::string> nearest(std::string_view wrong, std::span<const std::string> names, std::size_t most) {
  const std::string typed = lower(wrong);
  std::vector<Candidate> candidates;
  for (const std::string& name : names)
    if (const Candidate candidate = compare(typed, name); is_near(candidate, typed.size()))
      candidates.push_back(candidate);
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.beginning > b.beginning;
  });
  std::vector<std::string> result;
  for (const Candidate& candidate : candidates)
    if (result.size() < most && std::find(result.begin(), result.end(), *candidate.name) == result.end())
      result.push_back(*candidate.name);
  return result;
}

}  // namespace plumbline
