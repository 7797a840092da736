// The parameters of a case, each said once: key, default, unit, range and meaning where the member stands that holds it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cases/harness/description/settings.hpp"

namespace plumbline {

// A struct that derives from this initialises its members, or those of what it holds, by the functions below:
//
//   struct Swing : Parameters {
//     double gravity = positive("gravity", 20, "m/s^2", "gravity");
//     reference::Pendulum pendulum;
//     explicit Swing(Parameters given = {}) : Parameters(std::move(given)) {
//       pendulum.mass = positive("mass", pendulum.mass, "kg", "of the bob");
//     }
//   };
//
// Swing() holds the defaults, and keys() their keys in the order in which they were read; Swing(settings) holds what the
// settings say.
class Parameters {
 public:
  Parameters() = default;
  Parameters(const Settings& given) : given_(&given) {}

  const std::vector<Key>& keys() const { return keys_; }

 protected:
  // A key whose value is a number, a whole number, a number or none, or a name. Settings hold their values checked.
  double number(Key key);
  int integer(Key key);
  std::optional<double> optional_number(Key key);
  std::string text(Key key);

  double any_number(std::string name, double value, std::string unit, std::string description);
  double positive(std::string name, double value, std::string unit, std::string description);  // > 0
  double not_negative(std::string name, double value, std::string unit, std::string description);
  // low < the value <= high
  double within(std::string name, double value, std::string unit, double low, double high, std::string description);
  std::string one_of(std::string name, std::string value, std::vector<std::string> choices, std::string description);
  // The same of a key by which a study leaves its scheme: it chooses how the problem is solved, not which one it is.
  std::string method(std::string name, std::string value, std::vector<std::string> choices, std::string description);
  // "yes" or "no".
  bool yes_or_no(std::string name, bool value, std::string description);

 private:
  Value value_of(Key key);
  const Settings* given_ = nullptr;  // while members are initialised
  std::vector<Key> keys_;
};

}  // namespace plumbline
