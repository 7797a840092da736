// Reads requests from standard input, one a line:   NAME [key=value ...] [@ v1 v2 ...]
// and prints for each one line:   name value bound name value bound ... (values, then the rows of `at` without the abscissa,
// the third of them as name[2]).
// A refused request prints `error` and the message. Numbers carry 17 digits, so they survive the trip unchanged.
#include <cstdio>
#include <exception>
#include <iostream>
#include <sstream>
#include <string>

#include "reference/registry.hpp"

namespace {

using namespace plumbline::reference;

void print(const std::string& line) {
  std::istringstream words(line);
  std::string name, word;
  std::map<std::string, double> settings;
  std::vector<double> at;
  words >> name;
  for (bool rows = false; words >> word;) {
    if (word == "@") {
      rows = true;
    } else if (rows) {
      at.push_back(std::stod(word));
    } else {
      const auto equals = word.find('=');
      settings[word.substr(0, equals)] = std::stod(word.substr(equals + 1));
    }
  }
  const Answer answer = find_reference(name)->evaluate(settings, at);
  for (std::size_t i = 0; i < answer.values.size(); ++i) {
    std::printf("%s %.17g %.17g ", answer.values[i].first.c_str(), answer.values[i].second, answer.bounds[i].second);
  }
  for (std::size_t row = 0; row < answer.at.size(); ++row) {
    for (std::size_t i = 1; i < answer.at[row].size(); ++i) {
      std::printf("%s[%zu] %.17g %.17g ", answer.at[row][i].first.c_str(), row, answer.at[row][i].second,
                  answer.at_bounds[row][i - 1].second);
    }
  }
}

}  // namespace

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    try {
      print(line);
    } catch (const std::exception& error) {
      std::printf("error %s", error.what());
    }
    std::puts("");
  }
}
