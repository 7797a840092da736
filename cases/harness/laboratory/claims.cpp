#include "cases/harness/laboratory/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline {

Claims claims_of(const IntegratorChoice& choice) {
  const auto integrator = find_integrator(choice.name)->make();
  set_parameters(*integrator, choice.parameters);
  return integrator->claims();
}

std::optional<double> claimed_order(const Claims& claims, const std::string& of, const std::string& field) {
  const auto found = std::find_if(claims.orders.begin(), claims.orders.end(),
                                  [&](const OrderClaim& claim) { return claim.of == of && claim.field == field; });
  return found == claims.orders.end() ? std::nullopt : std::optional(found->order);
}

std::string oscillator_limit_in_words(double limit) {
  if (std::isinf(limit)) return "no limit";
  return limit > 0 ? fmt::format("{:.4f}/omega", limit) : "no stable step";
}

std::map<std::string, std::string> claims_in_words(const Claims& claims) {
  std::map<std::string, std::string> words;
  std::string& orders = words["order"];
  for (std::size_t k = 0; k < claims.orders.size(); ++k) {
    const OrderClaim& claim = claims.orders[k];
    const bool ends_class = k + 1 == claims.orders.size() || claims.orders[k + 1].of != claim.of;
    orders += fmt::format("{}{:.3g} of {}", k == 0 ? "" : ", ", claim.order, claim.field);
    if (ends_class) orders += fmt::format(" ({})", claim.of);
  }
  if (claims.limit) words["stability"] = oscillator_limit_in_words(*claims.limit);
  if (claims.energy) {
    constexpr const char* names[] = {"conserved", "bounded", "decaying"};
    words["energy"] = names[static_cast<std::size_t>(*claims.energy)];
  }
  if (claims.reversible) words["invariance"] = "reversible";
  if (orders.empty()) words.erase("order");
  return words;
}

}  // namespace plumbline
