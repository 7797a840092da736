#pragma once
// The catalog of references: each names itself, its parameters and its source, and answers with values and bounds.
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/bounded.hpp"
#include "reference/parameter.hpp"

namespace plumbline::reference {

/// Named numbers in the order in which they are printed.
using Record = std::vector<std::pair<std::string, double>>;

/// `bounds` and `at_bounds` have the keys of `values` and `at` (without the abscissa) and bound |value - true|.
struct Answer {
  Record values, bounds;
  std::vector<Record> at, at_bounds;
  void add(const std::string& key, Bounded value);
};

class Reference {
 public:
  virtual ~Reference() = default;
  virtual std::string name() const = 0;
  virtual std::string title() const = 0;
  virtual std::string source() const = 0;
  virtual std::vector<Parameter> parameters() const = 0;
  virtual Parameter abscissa() const = 0;  // of the rows in Answer::at; its default value is not used
  std::string at_name() const { return abscissa().key; }

  /// The answer for the chosen parameters (defaults for the rest) and one row for each value of `at`.
  /// Throws UnknownParameter or ParameterError.
  Answer evaluate(const std::map<std::string, double>& chosen, std::span<const double> at) const;

 private:
  virtual Answer solve(const std::map<std::string, double>& settings, std::span<const double> at) const = 0;
};

/// A static object of this type in a reference's own source file enters it into the catalog.
class Registration {
 public:
  explicit Registration(std::unique_ptr<Reference> reference);
};

/// All references in the order of their names.
std::vector<const Reference*> references();

/// The reference of that name, or nullptr.
const Reference* find_reference(std::string_view name);

}  // namespace plumbline::reference
