#include "cases/harness/integrators/subject.hpp"

#include "cases/harness/files/errors.hpp"
#include "cases/harness/laboratory/claims.hpp"

namespace plumbline {
namespace {

const IntegratorEntry& known(const std::string& name) {
  if (const IntegratorEntry* entry = find_integrator(name)) return *entry;
  std::vector<std::string> names;
  for (const IntegratorEntry& entry : integrators()) names.push_back(entry.name);
  throw unknown_name("integrator", name, names);
}

}  // namespace

Subject::Subject(IntegratorChoice choice)
    : choice_(std::move(choice)),
      entry_(&known(choice_.name)),
      claims_(claims_of(choice_)) {}

}  // namespace plumbline
