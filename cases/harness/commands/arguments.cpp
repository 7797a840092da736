#include "cases/harness/commands/arguments.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <charconv>
#include <cstdint>
#include <optional>

namespace plumbline {
namespace {

// The whole text as a number.
template <class Number>
std::optional<Number> number_of(const std::string& text) {
  Number value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

template <class FaultOf>
void check(CLI::Option& option, const FaultOf& fault_of) {
  option.check(CLI::Validator(fault_of, "", ""));
}

}  // namespace

const Argument& Argument::required() const {
  option_->required();
  return *this;
}

const Argument& Argument::repeatable() const {
  option_->allow_extra_args(false);
  return *this;
}

const Argument& Argument::separated_by_commas() const {
  option_->delimiter(',');
  return *this;
}

const Argument& Argument::hidden() const {
  option_->group("");
  return *this;
}

const Argument& Argument::not_empty() const {
  check(*option_, [](const std::string& text) { return text.empty() ? "'' is not allowed: a name is wanted" : ""; });
  return *this;
}

const Argument& Argument::one_of(const std::vector<std::string>& names) const {
  option_->check(CLI::IsMember(names));
  return *this;
}

const Argument& Argument::whole_number(long low, long high) const {
  check(*option_, [=](const std::string& text) {
    const auto value = number_of<long>(text);
    if (value && *value >= low && *value <= high) return std::string();
    const std::string range = value ? fmt::format("in [{}, {}]", low, high) : "of digits alone, such as 100";
    return fmt::format("'{}' is not allowed: a whole number {}", text, range);
  });
  return *this;
}

const Argument& Argument::number_within(double low, double high) const {
  check(*option_, [=](const std::string& text) {
    const auto value = number_of<double>(text);
    const bool inside = value && *value >= low && *value <= high;
    return inside ? "" : fmt::format("'{}' is not allowed: a number in [{:g}, {:g}]", text, low, high);
  });
  return *this;
}

Arguments Arguments::command(const std::string& name, const std::string& what, const std::string& footer) const {
  CLI::App* const sub = app_->add_subcommand(name, what);
  sub->footer(footer);
  return Arguments(*sub);
}

template <class T>
Argument Arguments::option(const std::string& name, T& to, const std::string& what) const {
  return Argument(*app_->add_option(name, to, what));
}
template Argument Arguments::option(const std::string&, std::string&, const std::string&) const;
template Argument Arguments::option(const std::string&, int&, const std::string&) const;
template Argument Arguments::option(const std::string&, double&, const std::string&) const;
template Argument Arguments::option(const std::string&, std::optional<std::string>&, const std::string&) const;
template Argument Arguments::option(const std::string&, std::optional<int>&, const std::string&) const;
template Argument Arguments::option(const std::string&, std::optional<long>&, const std::string&) const;
template Argument Arguments::option(const std::string&, std::optional<double>&, const std::string&) const;
template Argument Arguments::option(const std::string&, std::vector<std::string>&, const std::string&) const;
template Argument Arguments::option(const std::string&, std::vector<int>&, const std::string&) const;
template Argument Arguments::option(const std::string&, std::vector<double>&, const std::string&) const;

Argument Arguments::flag(const std::string& name, bool& to, const std::string& what) const {
  return Argument(*app_->add_flag(name, to, what));
}

void Arguments::size(const std::string& name, double& to, double least, double most, const std::string& what) const {
  app_->add_option_function<std::uint64_t>(
          name, [&to](const std::uint64_t& bytes) { to = static_cast<double>(bytes); }, what)
      ->transform(CLI::AsSizeValue(true))
      ->check(CLI::Range(static_cast<std::uint64_t>(least), static_cast<std::uint64_t>(most)));
}

std::string Arguments::first_value(const std::string& name) const {
  const CLI::Option* const option = app_->get_option_no_throw(name);
  return option && option->count() > 0 ? option->results().front() : "";
}

}  // namespace plumbline
