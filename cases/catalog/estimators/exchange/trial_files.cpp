#include "cases/catalog/estimators/exchange/trial_files.hpp"

#include "cases/catalog/estimators/exchange/given_stress.hpp"

namespace plumbline {

void add_table(const std::string& name, const ForeignReader& file, const std::string& dataset,
               const std::vector<std::size_t>& shape, const std::vector<double>& values, KnownAnswers& all) {
  const bool there = file.has(dataset);
  all.push_back(yes(name + ".there", there));
  if (!there) return;
  const NumberTable table = file.numbers(dataset);
  all.push_back(yes(name + ".shape", table.shape == shape));
  all.push_back({name, farthest(table.values, values), 0});
}

}  // namespace plumbline
