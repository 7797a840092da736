// Files of HDF5 as they are written and read: by the reader of our own ones, which have a seal, and by that of others'.
#include <cmath>
#include <cstdint>
#include <fstream>
#include <numeric>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/catalog/estimators/exchange/trial_files.hpp"
#include "cases/harness/exchange/foreign_file.hpp"
#include "cases/harness/files/hdf5_file.hpp"

namespace plumbline {
namespace {

constexpr std::size_t few = 12, many = 3 * 40;  // numbers: those of few are not compressed
constexpr std::size_t longest_of_texts = 4096;  // that others may write as an attribute

std::vector<double> thirds(std::size_t count) {
  std::vector<double> all;
  for (std::size_t k = 0; k < count; ++k) all.push_back((static_cast<double>(k) - 5) / 3);
  return all;
}
template <class Number>
std::vector<Number> whole_numbers(std::size_t count) {
  std::vector<Number> all(count);
  std::iota(all.begin(), all.end(), Number{3});
  return all;
}
template <class Number>
std::vector<double> as_doubles(const std::vector<Number>& values) {
  return {values.begin(), values.end()};
}

void write_everything(const std::string& path) {
  Hdf5Writer file(path);
  file.attribute("/", "text", "w\xc3\xb6rter");
  file.attribute("/", "whole", std::int64_t{-7000000000});
  file.real_attribute("/", "real", 1.0 / 3);
  file.ascii_attribute("/", "letters", "VTKHDF");
  file.integers_attribute("/", "one", {5});
  file.integers_attribute("/", "two", {2, 3});
  file.attribute("/", "longest", std::string(longest_of_texts - 1, 'x'));  // and the end mark
  file.attribute("/", "too_long", std::string(longest_of_texts, 'x'));
  file.group("/groups/empty");
  file.attribute("/groups", "whole", std::int64_t{11});
  file.text("/words", "w\xc3\xb6rter");
  file.numbers("/lists/doubles", thirds(few));
  file.numbers("/lists/none", {});
  file.array<double>("/tables/few", thirds(few), 3);
  file.array<double>("/tables/many", thirds(many), 3);
  file.array<double>("/lists/many", thirds(many));
  file.array<double>("/tables/none", std::vector<double>(), 3);
  file.array<double>("/tables/zeros", std::vector<double>(many, 0.0), 3);
  file.array<float>("/lists/floats", std::vector<float>{0.25F, -1.5F});
  file.array<std::int64_t>("/lists/whole64", std::vector<std::int64_t>{-7000000000, 3});
  file.array<std::int32_t>("/tables/whole32", whole_numbers<std::int32_t>(few), 4);
  file.array<std::uint8_t>("/lists/bytes", whole_numbers<std::uint8_t>(many));
  file.commit();
}

void add_read_by_own(const std::string& path, KnownAnswers& all) {
  const Hdf5Reader file(path);
  const auto numbers = [&](const std::string& dataset, const std::vector<double>& found,
                           const std::vector<double>& exact) {
    double most = found.size() == exact.size() ? 0 : NAN;
    for (std::size_t k = 0; k < std::min(found.size(), exact.size()); ++k) {
      most = larger(most, std::abs(found[k] - exact[k]));
    }
    all.push_back({"own." + dataset, most, 0});
  };
  all.push_back(yes("own.name", file.name() == path));
  all.push_back({"own.whole", static_cast<double>(file.attribute("/", "whole")), -7e9, 7e9});
  all.push_back({"own.group", static_cast<double>(file.attribute("/groups", "whole")), 11});
  all.push_back({"own.one", static_cast<double>(read_hdf5_integer(path, "/", "one")), 5});
  all.push_back(yes("own.two", refuses([&] { file.attribute("/", "two"); })));
  all.push_back(yes("own.no_attribute", refuses([&] { file.attribute("/", "none"); })));
  all.push_back(yes("own.words", read_hdf5_text(path, "/words") == "w\xc3\xb6rter"));
  all.push_back(yes("own.no_words", refuses([&] { file.text("/lists/doubles"); })));
  all.push_back(yes("own.has", file.has("/groups") && file.has("/words")));
  all.push_back(no("own.has_not", file.has("/others")));
  numbers("doubles", file.numbers("/lists/doubles"), thirds(few));
  numbers("none", file.numbers("/lists/none"), {});
  numbers("few", file.numbers("/tables/few"), thirds(few));
  numbers("many", file.numbers("/tables/many"), thirds(many));
  numbers("floats", file.numbers("/lists/floats"), {0.25, -1.5});
  numbers("bytes", as_doubles(file.bytes("/lists/bytes")), as_doubles(whole_numbers<std::uint8_t>(many)));
  all.push_back(yes("own.no_bytes", refuses([&] { file.bytes("/lists/doubles"); })));
  all.push_back(yes("own.no_numbers", refuses([&] { file.numbers("/lists/bytes"); })));
  all.push_back(yes("own.missing", refuses([&] { file.numbers("/lists/others"); })));
}

void add_read_by_other(const std::string& path, KnownAnswers& all) {
  const ForeignReader file(path);
  all.push_back(yes("other.text", file.text_attribute("text") == "w\xc3\xb6rter"));
  all.push_back(yes("other.letters", file.text_attribute("letters") == "VTKHDF"));
  all.push_back(yes("other.longest", file.text_attribute("longest") == std::string(longest_of_texts - 1, 'x')));
  all.push_back(yes("other.too_long", refuses([&] { file.text_attribute("too_long"); })));
  all.push_back(no("other.no_text", file.text_attribute("none").has_value()));
  all.push_back(yes("other.number_for_text", refuses([&] { file.text_attribute("whole"); })));
  all.push_back({"other.real", file.number_attribute("real").value_or(NAN), 1.0 / 3});
  all.push_back({"other.whole", file.number_attribute("whole").value_or(NAN), -7e9, 7e9});
  all.push_back({"other.one", file.number_attribute("one").value_or(NAN), 5});
  all.push_back(yes("other.two", refuses([&] { file.number_attribute("two"); })));
  all.push_back(no("other.no_number", file.number_attribute("none").has_value()));
  all.push_back(yes("other.text_for_number", refuses([&] { file.number_attribute("text"); })));
  add_table("other.doubles", file, "/lists/doubles", {few}, thirds(few), all);
  add_table("other.none", file, "/lists/none", {0}, {}, all);
  add_table("other.no_rows", file, "/tables/none", {0, 3}, {}, all);
  add_table("other.few", file, "/tables/few", {few / 3, 3}, thirds(few), all);
  add_table("other.many", file, "/tables/many", {many / 3, 3}, thirds(many), all);
  add_table("other.long", file, "/lists/many", {many}, thirds(many), all);
  add_table("other.zeros", file, "/tables/zeros", {many / 3, 3}, std::vector<double>(many, 0.0), all);
  add_table("other.floats", file, "/lists/floats", {2}, {0.25, -1.5}, all);
  add_table("other.whole64", file, "/lists/whole64", {2}, {-7e9, 3}, all);
  add_table("other.whole32", file, "/tables/whole32", {3, 4}, as_doubles(whole_numbers<std::int32_t>(few)), all);
  add_table("other.bytes", file, "/lists/bytes", {many}, as_doubles(whole_numbers<std::uint8_t>(many)), all);
  all.push_back(yes("other.words", refuses([&] { file.numbers("/words"); })));
  all.push_back(yes("other.group", refuses([&] { file.numbers("/groups"); })));
  all.push_back(yes("other.missing", refuses([&] { file.numbers("/lists/others"); })));
  all.push_back(yes("other.has", file.has("/groups/empty") && file.has("/lists") && file.has("/words")));
  all.push_back(no("other.has_not", file.has("/groups/other") || file.has("/others") || file.has("/others/empty")));
  const std::vector<std::string> roots{"groups", "lists", "tables", "words"};
  all.push_back(yes("other.roots", file.members("/") == roots || file.members("/.") == roots));
  const std::vector<std::string> tables{"few", "many", "none", "whole32", "zeros"};
  all.push_back(yes("other.members", file.members("/tables") == tables));
  all.push_back({"other.no_members", static_cast<double>(file.members("/others").size()), 0});
}

// The same by a process of its own.
void add_read_elsewhere(const std::string& path, KnownAnswers& all) {
  const ForeignFile file(path);
  const NumberTable table = file.numbers("/tables/many");
  const std::vector<std::string> tables{"few", "many", "none", "whole32", "zeros"};
  all.push_back(yes("elsewhere.shape", table.shape == std::vector<std::size_t>{many / 3, 3}));
  all.push_back(yes("elsewhere.values", table.values == thirds(many)));
  all.push_back(yes("elsewhere.members", file.members("/tables") == tables));
  all.push_back(yes("elsewhere.text", file.text_attribute("text") == "w\xc3\xb6rter"));
  all.push_back({"elsewhere.number", file.number_attribute("whole").value_or(NAN), -7e9, 7e9});
  all.push_back(no("elsewhere.no_text", file.text_attribute("none") || file.number_attribute("none")));
  all.push_back(yes("elsewhere.has", file.has("/tables") && !file.has("/others")));
  all.push_back(yes("elsewhere.refused", refuses([&] { file.number_attribute("text"); }) && file.has("/tables")));
}

// A file that is not committed is not there; one that another program wrote over is no longer ours; nor is a text HDF5.
void add_refused_files(const ScratchFolder& folder, const std::string& path, KnownAnswers& all) {
  const std::string given_up = folder / "given_up.h5", text = folder / "text.h5", changed = folder / "changed.h5";
  { Hdf5Writer(given_up).numbers("/lists", thirds(few)); }
  all.push_back(no("refused.given_up", std::filesystem::exists(given_up)));
  { std::ofstream(text) << "no HDF5"; }
  all.push_back(yes("refused.text", refuses([&] { Hdf5Reader{text}; })));
  all.push_back(yes("refused.text_of_others", refuses([&] { ForeignReader{text}; })));
  all.push_back(yes("refused.none", refuses([&] { Hdf5Reader{folder / "none.h5"}; })));
  all.push_back(yes("refused.none_of_others", refuses([&] { ForeignReader{folder / "none.h5"}; })));
  std::filesystem::copy_file(path, changed);
  {
    std::fstream file(changed, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(-1, std::ios::end);
    file.put('\x55');
  }
  all.push_back(yes("refused.changed", refuses([&] { Hdf5Reader{changed}; })));
}

}  // namespace

KnownAnswers file_answers() {
  KnownAnswers all;
  const ScratchFolder folder;
  const std::string path = folder / "everything.h5";
  write_everything(path);
  add_read_by_own(path, all);
  add_read_by_other(path, all);
  add_read_elsewhere(path, all);
  add_refused_files(folder, path, all);
  return all;
}

}  // namespace plumbline
