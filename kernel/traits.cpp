#include "kernel/traits.hpp"

#include <array>
#include <utility>

namespace plumbline {
namespace {

struct TraitText {
  std::string name, absence;
};

const TraitText& text_of(Trait trait) {
  static const std::array<TraitText, 6> all{
      {{"unfiltered-velocities", "filters velocities once a step, so that points have no rate of change"},
       {"returnable-loss", "gives points other velocities than the grid has, so that what they lose is not known"},
       {"smooth-gradients", "has gradients that jump between cells"},
       {"constant-inertia",
        "has an affine inertia that depends on where points stand, and changes energy as they move"},
       {"returned-loss", "does not return what the maps take from points as heat"},
       {"forward-steps", "goes back in time within a step, where dissipation would create energy"}}};
  return all[static_cast<std::size_t>(trait)];
}

std::string sentence(const std::vector<Lack>& lacks) {
  std::string all;
  for (const Lack& lack : lacks) all += (all.empty() ? "" : "; ") + lack.text();
  return all;
}

}  // namespace

const std::string& name(Trait trait) { return text_of(trait).name; }
const std::string& absence(Trait trait) { return text_of(trait).absence; }

std::string Lack::text() const {
  return needed_by + " needs " + name(trait) + ": " + not_offered_by + " " + absence(trait);
}

CannotWork::CannotWork(std::vector<Lack> all) : std::invalid_argument(sentence(all)), lacks(std::move(all)) {}

}  // namespace plumbline
