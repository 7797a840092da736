#include "cases/harness/commands/command.hpp"
#include "cases/harness/exchange/final_state.hpp"
#include "cases/harness/files/json_text.hpp"
#include "cases/harness/laboratory/claims.hpp"
#include "cases/harness/laboratory/problem.hpp"
#include "kernel/contact/contact.hpp"
#include "kernel/materials/material_entry.hpp"
#include "kernel/shapes/shape.hpp"
#include "kernel/transfers/transfer.hpp"
#include "reference/registry.hpp"

namespace plumbline {
namespace {

template <class Entry>
Json choices(const std::vector<Entry>& all) {
  Json list = Json::array();
  for (const Entry& c : all) list.push_back({{"name", c.name}, {"title", c.title}, {"source", c.source}});
  return list;
}

Json scheme_entries() {
  Json list = Json::array();
  for (const std::string& scheme : scheme_names()) {
    Json resolved = Json::object();
    for (const Case* entry : cases()) resolved[entry->name] = to_json(entry->settings(scheme, {}));
    Json by_kind = Json::object();
    for (const Kind kind : all_kinds) {
      for (const auto& [key, value] : scheme_values(scheme, kind)) by_kind[name(kind)][key] = to_json(value);
    }
    list.push_back({{"name", scheme},
                    {"title", scheme_title(scheme)},
                    {"source", scheme_source(scheme)},
                    {"kinds", by_kind},
                    {"settings", resolved}});
  }
  return list;
}

Json case_entries() {
  Json list = Json::array();
  for (const Case* entry : cases()) {
    const Statement s = entry->statement();
    Json keys = Json::array();
    for (const Key& key : entry->keys) keys.push_back(key.name);
    list.push_back({{"name", s.name},
                    {"title", s.title},
                    {"source", s.source},
                    {"cells_along", s.cells_along.empty() ? Json() : Json(s.cells_along)},
                    {"keys", keys},
                    {"kind", entry->trials.empty() ? name(entry->kind) : "trials"},
                    {"scored", why_not_scored(*entry, entry->settings("default", {})).empty()}});
  }
  return list;
}

Json document() {
  Json all{{"cases", case_entries()}, {"schemes", scheme_entries()}};
  all["integrators"] = Json::array();
  for (const IntegratorEntry& i : integrators()) {
    all["integrators"].push_back(
        {{"name", i.name}, {"title", i.title}, {"source", i.source}, {"claims", claims_in_words(claims_of({i.name}))}});
  }
  all["shapes"] = choices(shapes());
  all["transfers"] = choices(transfers());
  all["densities"] = choices(densities());
  all["contacts"] = choices(contacts());
  all["materials"] = choices(materials());
  all["references"] = Json::array();
  for (const reference::Reference* r : reference::references()) {
    all["references"].push_back({{"name", r->name()}, {"title", r->title()}, {"source", r->source()}});
  }
  all["problems"] = Json::array();
  for (const StabilityProblem* problem : stability_problems()) {
    const ProblemStatement s = problem->statement();
    all["problems"].push_back({{"name", s.name}, {"title", s.title}, {"source", s.source}});
  }
  return all;
}

void print(const Output& out, const Json& all) {
  for (const auto& [group, entries] : all.items()) {
    if (entries.empty()) continue;
    out.line("{}", group);
    for (const auto& e : entries) {
      out.line("  {:18} {}  [{}]", e.at("name").get<std::string>(), e.at("title").get<std::string>(),
               e.at("source").get<std::string>());
      if (e.contains("cells_along")) {
        std::string keys;
        for (const auto& key : e.at("keys")) keys += " " + key.get<std::string>();
        const auto& along = e.at("cells_along");
        out.line("  {:18} {}own keys:{}{}", "", along.is_null() ? "" : "cells along " + along.get<std::string>() + "; ",
                 keys, e.at("scored").get<bool>() ? "; scored" : "");
      }
      if (e.contains("claims") && !e.at("claims").empty()) {
        std::string claims;
        for (const auto& [family, text] : e.at("claims").items()) {
          claims += fmt::format("{}{} {}", claims.empty() ? "" : "; ", family, text.template get<std::string>());
        }
        out.line("  {:18} claims {}", "", claims);
      }
      if (group == "schemes") {
        for (const auto& [kind, values] : e.at("kinds").items()) {
          std::string text;
          for (const auto& [key, value] : values.items()) {
            if (!value.is_null())
              text += fmt::format(" {}={}", key,
                                  value.is_string() ? value.template get<std::string>() : json_text(value));
          }
          out.line("  {:18} {}:{}", "", kind, text);
        }
      }
    }
  }
}

}  // namespace

Command add_list(const Arguments& program, Invocation& invocation) {
  const Arguments sub = program.command(
      "list", "cases, schemes, integrators, shapes, transfers, contact laws, materials, references, stability problems",
      "Example: plumbline list --json -");
  add_json(sub, invocation.options);
  return {sub, [&invocation] {
            const Json all = document();
            if (invocation.options.json != "-") print(Output(invocation.options), all);
            write_json(invocation.options, all);
            return 0;
          }};
}

}  // namespace plumbline
