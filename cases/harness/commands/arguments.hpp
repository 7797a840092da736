// What the command line may say. The parser's own header takes seconds to compile; few sources include it.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace plumbline {

// An option or a positional argument: what it wants beyond its type.
class Argument {
 public:
  explicit Argument(CLI::Option& option) : option_(&option) {}
  const Argument& required() const;
  const Argument& repeatable() const;  // one value after each --name
  const Argument& separated_by_commas() const;
  const Argument& hidden() const;  // not in --help
  const Argument& not_empty() const;
  const Argument& one_of(const std::vector<std::string>& names) const;
  // Digits alone, within the range.
  const Argument& whole_number(long low = -1'000'000'000, long high = 1'000'000'000) const;
  const Argument& number_within(double low, double high) const;

 private:
  CLI::Option* option_;
};

// Those of one command, or of the program.
class Arguments {
 public:
  explicit Arguments(CLI::App& app) : app_(&app) {}

  // A command with arguments of its own. `footer`: the last lines of its --help.
  Arguments command(const std::string& name, const std::string& what, const std::string& footer) const;

  // A value goes to `to`, which outlives the parsing. Names as --name, or a word: an argument by position. T: a text, a number,
  // an optional or a vector of one.
  template <class T>
  Argument option(const std::string& name, T& to, const std::string& what) const;
  Argument flag(const std::string& name, bool& to, const std::string& what) const;
  // A number of bytes, as 500MB or 2GB.
  void size(const std::string& name, double& to, double least, double most, const std::string& what) const;

  // What has been typed: the first value of an option that may not be one of this command's, empty if it was not.
  std::string first_value(const std::string& name) const;
  bool given(const std::string& name) const { return !first_value(name).empty(); }
  CLI::App& app() const { return *app_; }

 private:
  CLI::App* app_;
};

}  // namespace plumbline
