#include "cases/harness/results/fingerprint.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/results/provenance.hpp"
#include "kernel/engine/stage_queue.hpp"

namespace plumbline {
namespace {

struct Code {
  std::vector<ObjectHash> objects;
  std::vector<std::pair<std::string, std::string>> uses;
  std::vector<std::string> plugins;  // their hashes
};

Code& code() {
  static Code known;
  return known;
}

// "cases/catalog/gas/sod.cpp" of however the compiler was told the path.
std::string below_cases(const std::string& path) {
  const std::size_t start = path.rfind("cases/");
  return start == std::string::npos ? path : path.substr(start);
}

// "gas" of "cases/catalog/gas/sod.cpp"; empty elsewhere.
std::string folder_of(const std::string& source) {
  const std::string catalog = "cases/catalog/";
  if (!source.starts_with(catalog)) return {};
  return source.substr(catalog.size(), source.find('/', catalog.size()) - catalog.size());
}

// What judges and compares results makes none.
bool is_common(const std::string& source) {
  for (const char* apart : {"integrators/", "compare/", "exchange/", "commands/"}) {
    if (source.starts_with(std::string("cases/harness/") + apart)) return false;
  }
  return folder_of(source).empty();
}

// The folder and those it includes, and so on.
std::set<std::string> reached_from(const std::string& folder) {
  std::set<std::string> reached{folder};
  for (std::size_t before = 0; before != reached.size();) {
    before = reached.size();
    for (const auto& [user, used] : code().uses) {
      if (reached.count(user) > 0) reached.insert(used);
    }
  }
  return reached;
}

std::string compiled_with() {
  const Provenance p = build_provenance();
  std::string text = p.compiler + "\n" + p.flags + "\n" + p.instruction_set + "\n";
  if (!fuses_stages()) text += "stages one by one\n";
  for (const char* library : {"eigen", "gsl", "boost"}) text += p.libraries.at(library) + "\n";
  return text;
}

template <class Counts>
std::string hash_of(const Counts& counts) {
  std::string text = compiled_with();
  for (const std::string& plugin : code().plugins) text += plugin + "\n";
  for (const ObjectHash& object : code().objects) {
    if (counts(object)) text += object.source + " " + object.hash + "\n";
  }
  return short_hash(text);
}

bool is_told(const std::string& own) {
  return std::any_of(code().objects.begin(), code().objects.end(),
                     [&](const ObjectHash& object) { return object.source == own; });
}

std::string fingerprint_of_file(const std::string& own) {
  std::set<std::string> registering;
  for (const Case* entry : cases()) registering.insert(below_cases(entry->source_file));
  const std::set<std::string> folders = reached_from(folder_of(own));
  return hash_of([&](const ObjectHash& object) {
    if (is_common(object.source) || object.source == own) return true;
    if (folders.count(folder_of(object.source)) == 0) return false;
    return object.has_header || registering.count(object.source) == 0;
  });
}

std::map<std::string, std::string>& found() {
  static std::map<std::string, std::string> by_file;
  return by_file;
}

}  // namespace

RegisterCode::RegisterCode(std::vector<ObjectHash> objects, std::vector<std::pair<std::string, std::string>> uses) {
  code() = {std::move(objects), std::move(uses), {}};
  found().clear();
}

void add_plugin_to_code(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw FileError(file, file + ": cannot be read");
  const std::string content{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  code().plugins.push_back(short_hash(content));
  found().clear();
}

std::string code_fingerprint() {
  return code().objects.empty() ? std::string{} : hash_of([](const ObjectHash&) { return true; });
}

std::string fingerprint(const Case& entry) {
  if (code().objects.empty()) return {};
  const std::string own = below_cases(entry.source_file);
  std::string& known = found()[own];
  if (known.empty() && is_told(own)) known = fingerprint_of_file(own);
  return known;
}

}  // namespace plumbline
