#include "cases/catalog/estimators/exchange/written_start.hpp"

#include <fstream>
#include <sstream>

namespace plumbline {
namespace {

Provenance of_this_version() {
  Provenance made;
  made.version = "1.2.3";
  return made;
}

}  // namespace

WrittenStart::WrittenStart(std::string name, const Case& entry, KnownAnswers& all)
    : name_(std::move(name)),
      path_(folder_ / (name_ + ".h5")),
      description_(write_initial_state(entry, "default", settings_of_given(), path_, of_this_version())),
      file_(path_),
      all_(all) {}

std::string WrittenStart::text_beside() const {
  std::ifstream file(folder_ / (name_ + ".json"));
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string WrittenStart::wanted_at_end(std::size_t body) const {
  const Json state = described(body)["final_state"];
  std::string all;
  for (const Json& wanted : state["datasets"]) {
    all += wanted["name"].get<std::string>() + ":" + std::to_string(wanted["components"].get<int>()) + " ";
  }
  return all + state["points"].get<std::string>();
}

void WrittenStart::say(const std::string& what, const Json& found, const char* exact) {
  say(what, found == Json::parse(exact));
}

void WrittenStart::say(const std::string& what, bool found) { all_.push_back(yes(name_ + "." + what, found)); }

void WrittenStart::holds(std::size_t body, const ColumnId& id, int components) {
  const int points = described(body)["points"], dim = description_["grid"]["dim"];
  holds(body, id, components, given_rows(id, components == 0 ? 1 : components, points, dim));
}

void WrittenStart::holds(std::size_t body, const ColumnId& id, int components, const std::vector<double>& rows) {
  const Json about = described(body);
  const std::string group = about["group"], name = name_ + "." + std::to_string(body) + "." + id.name();
  std::vector<std::size_t> shape{about["points"]};
  if (components > 0) shape.push_back(static_cast<std::size_t>(components));
  add_table(name, file_, group + "/" + id.name(), shape, rows, all_);
  const bool listed = about["datasets"].contains(id.name());
  all_.push_back(yes(name + ".listed", listed && about["datasets"][id.name()]["shape"] == Json(shape) &&
                                           about["datasets"][id.name()]["unit"] == id.unit()));
}

void WrittenStart::holds_nothing_else(std::size_t body, int members) {
  const std::string group = described(body)["group"], name = name_ + "." + std::to_string(body) + ".members";
  all_.push_back({name, static_cast<double>(file_.members(group).size()), static_cast<double>(members)});
}

}  // namespace plumbline
