// A start as it was written for other programs, and what is asked of it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cases/catalog/estimators/exchange/given_scenes.hpp"
#include "cases/catalog/estimators/exchange/trial_files.hpp"
#include "cases/harness/exchange/initial_state.hpp"

namespace plumbline {

class WrittenStart {
 public:
  // Answers go to `all`, which must outlive this.
  WrittenStart(std::string name, const Case& entry, KnownAnswers& all);

  const Json& description() const { return description_; }
  Json described(std::size_t body) const { return description_["bodies"].at(body); }
  const ForeignReader& file() const { return file_; }
  std::string text_beside() const;
  // "position:2 mass:1 any number": what is to be handed in of a body, and how many points.
  std::string wanted_at_end(std::size_t body) const;

  void say(const std::string& what, const Json& found, const char* exact);
  void say(const std::string& what, bool found);
  // A column that holds what the scene gave it, or these rows; components: 0 of a list without a second dimension.
  void holds(std::size_t body, const ColumnId& id, int components = 0);
  void holds(std::size_t body, const ColumnId& id, int components, const std::vector<double>& rows);
  void holds_nothing_else(std::size_t body, int members);

 private:
  ScratchFolder folder_;
  std::string name_, path_;
  Json description_;
  ForeignReader file_;
  KnownAnswers& all_;
};

// Of solids, of bands around an axis, and of loads that follow the points.
void add_other_starts(KnownAnswers& all);

}  // namespace plumbline
