#include "cases/harness/description/parameters.hpp"

namespace plumbline {

Value Parameters::value_of(Key key) {
  keys_.push_back(std::move(key));
  return given_ ? (*given_)[keys_.back().name] : keys_.back().value;
}

double Parameters::number(Key key) { return std::get<double>(value_of(std::move(key))); }

int Parameters::integer(Key key) {
  key.integer = true;
  return static_cast<int>(number(std::move(key)));
}

std::optional<double> Parameters::optional_number(Key key) {
  key.optional = true;
  const Value value = value_of(std::move(key));
  if (std::holds_alternative<std::monostate>(value)) return std::nullopt;
  return std::get<double>(value);
}

std::string Parameters::text(Key key) { return std::get<std::string>(value_of(std::move(key))); }

double Parameters::any_number(std::string name, double value, std::string unit, std::string description) {
  return number(
      {.name = std::move(name), .value = value, .unit = std::move(unit), .description = std::move(description)});
}

double Parameters::positive(std::string name, double value, std::string unit, std::string description) {
  return number(positive_key(std::move(name), value, std::move(unit), std::move(description)));
}

double Parameters::not_negative(std::string name, double value, std::string unit, std::string description) {
  return number({.name = std::move(name),
                 .value = value,
                 .unit = std::move(unit),
                 .low = 0,
                 .description = std::move(description)});
}

double Parameters::within(std::string name, double value, std::string unit, double low, double high,
                          std::string description) {
  return number({.name = std::move(name),
                 .value = value,
                 .unit = std::move(unit),
                 .low = low,
                 .high = high,
                 .low_open = true,
                 .description = std::move(description)});
}

std::string Parameters::one_of(std::string name, std::string value, std::vector<std::string> choices,
                               std::string description) {
  return text({.name = std::move(name),
               .value = std::move(value),
               .choices = std::move(choices),
               .description = std::move(description)});
}

std::string Parameters::method(std::string name, std::string value, std::vector<std::string> choices,
                               std::string description) {
  return text({.name = std::move(name),
               .value = std::move(value),
               .choices = std::move(choices),
               .description = std::move(description),
               .method = true});
}

bool Parameters::yes_or_no(std::string name, bool value, std::string description) {
  return one_of(std::move(name), value ? "yes" : "no", {"yes", "no"}, std::move(description)) == "yes";
}

}  // namespace plumbline
