#include "cases/catalog/stability/map_scheme.hpp"

#include <map>

namespace plumbline {
namespace {

template <class Value>
std::optional<Value> look_up(const std::map<std::string, Value>& known, const std::string& name) {
  const auto found = known.find(name);
  if (found == known.end()) return std::nullopt;
  return found->second;
}

}  // namespace

std::optional<reference::StressUpdate> stress_update(const std::string& integrator) {
  using reference::StressUpdate;
  return look_up<StressUpdate>({{"usf", StressUpdate::first},
                                {"usl", StressUpdate::last},
                                {"musl", StressUpdate::modified_last},
                                {"usavg", StressUpdate::averaged}},
                               integrator);
}

std::optional<reference::MapScheme> map_scheme(const Settings& settings) {
  using reference::GridShape, reference::GridTransfer;
  const auto update = stress_update(settings.text("integrator"));
  const auto shape = look_up<GridShape>({{"linear", GridShape::linear},
                                         {"gimp", GridShape::boxes},
                                         {"quadratic", GridShape::quadratic},
                                         {"cubic", GridShape::cubic}},
                                        settings.text("shape"));
  const auto transfer = look_up<GridTransfer>({{"pic", GridTransfer::pic},
                                               {"flip", GridTransfer::flip},
                                               {"apic", GridTransfer::apic},
                                               {"xpic", GridTransfer::xpic},
                                               {"fmpm", GridTransfer::fmpm}},
                                              settings.text("transfer"));
  if (!update || !shape || !transfer || settings.text("positions") != "frozen") return std::nullopt;
  return reference::MapScheme{*update, *shape, *transfer, settings.integer("transfer_order"), 0};
}

}  // namespace plumbline
