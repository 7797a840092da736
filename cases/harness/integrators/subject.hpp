// The integrator that is judged, and the one that it is compared with.
#pragma once

#include <any>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "cases/harness/laboratory/step_map.hpp"
#include "kernel/integrator_traits.hpp"

namespace plumbline {

class Subject {
 public:
  // An integrator with the values of its parameters. Throws UsageError for an unknown name.
  explicit Subject(IntegratorChoice choice);

  const std::string& name() const { return choice_.name; }
  const IntegratorChoice& choice() const { return choice_; }
  const IntegratorEntry& entry() const { return *entry_; }
  const IntegratorTraits& traits() const { return traits_of(*entry_); }
  const Claims& claims() const { return claims_; }
  // Steps that iterate: each costs many forces, more on larger scenes.
  bool has_inner_solver() const { return traits().force_evaluations > 8; }

  // What several gates read is found once: the first caller finds it, others wait.
  template <class Found>
  const Found& once(const std::string& key, const std::function<Found()>& find) const {
    Slot* slot = nullptr;
    {
      const std::lock_guard lock(*guard_);
      auto& place = (*found_)[key];
      if (!place) place = std::make_unique<Slot>();
      slot = place.get();
    }
    std::call_once(slot->done, [&] { slot->value = find(); });
    return std::any_cast<const Found&>(slot->value);
  }

 private:
  struct Slot {
    std::once_flag done;
    std::any value;
  };
  IntegratorChoice choice_;
  const IntegratorEntry* entry_;
  Claims claims_;
  std::shared_ptr<std::mutex> guard_ = std::make_shared<std::mutex>();
  std::shared_ptr<std::map<std::string, std::unique_ptr<Slot>>> found_ =
      std::make_shared<std::map<std::string, std::unique_ptr<Slot>>>();
};

}  // namespace plumbline
