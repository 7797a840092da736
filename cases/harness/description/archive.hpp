// What an object must keep for a run to be taken up again: numbers by name. One function of the object names them for
// writing and for reading alike, so that nothing is written that is not read:
//
//   void history(Archive& archive) {
//     archive("times", times_);
//     archive("energy", energy_);  // an object with a history() of its own
//   }
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace plumbline {

// The numbers are not those of such an object: one is missing, too many are there, or one is out of its type's range.
struct ArchiveError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Archive {
 public:
  // By name; '/' parts the names of objects within objects. Whole numbers are exact up to 2^53.
  using Table = std::map<std::string, std::vector<double>>;

  Archive() = default;                                   // writes
  explicit Archive(const Table& kept) : kept_(&kept) {}  // reads; `kept` must outlive this

  bool reads() const { return kept_ != nullptr; }

  // Writes the value, or gives it the one that was written under the name: a number, an array or a vector of numbers or of
  // arrays, a vector of vectors of numbers, or an object with history(Archive&). A name is used once. Throws ArchiveError.
  template <class T>
  void operator()(const std::string& name, T& value) {
    if constexpr (requires { value.history(*this); }) {
      const std::string outside = within_;
      within_ += name + "/";
      value.history(*this);
      within_ = outside;
    } else if (reads()) {
      Source source{within_ + name, &taken(within_ + name), 0};
      get(source, value);
      source.require_end();
    } else {
      put(added(within_ + name), value);
    }
  }

  // What was written.
  Table take() { return std::move(written_); }
  // Throws ArchiveError if something was kept that nobody has read.
  void require_all_read() const;

 private:
  struct Source {
    std::string name;
    const std::vector<double>* values;
    std::size_t at;
    std::size_t left() const { return values->size() - at; }
    double next();
    double next_whole(double low, double high);
    void require_end() const;
  };
  std::vector<double>& added(const std::string& name);
  const std::vector<double>& taken(const std::string& name);

  template <class T>
  static constexpr bool is_vector = false;

  template <class T>
  static void put(std::vector<double>& to, const T& value);
  template <class T, std::size_t n>
  static void put(std::vector<double>& to, const std::array<T, n>& values) {
    for (const T& value : values) put(to, value);
  }
  template <class T>
  static void put(std::vector<double>& to, const std::vector<T>& values) {
    for (const T& value : values) {
      if constexpr (is_vector<T>) to.push_back(static_cast<double>(value.size()));
      put(to, value);
    }
  }

  template <class T>
  static void get(Source& from, T& value);
  template <class T, std::size_t n>
  static void get(Source& from, std::array<T, n>& values) {
    for (T& value : values) get(from, value);
  }
  // To the end: a vector has no other mark.
  template <class T>
  static void get(Source& from, std::vector<T>& values) {
    values.clear();
    while (from.left() > 0) {
      values.emplace_back();
      if constexpr (is_vector<T>) {
        values.back().resize(static_cast<std::size_t>(from.next_whole(0, static_cast<double>(from.left() - 1))));
        for (auto& value : values.back()) get(from, value);
      } else {
        get(from, values.back());
      }
    }
  }

  const Table* kept_ = nullptr;
  Table written_;
  std::set<std::string> read_;
  std::string within_;
};

template <class T>
constexpr bool Archive::is_vector<std::vector<T>> = true;

template <class T>
void Archive::put(std::vector<double>& to, const T& value) {
  static_assert(std::is_arithmetic_v<T>, "neither numbers nor an object with a history");
  to.push_back(static_cast<double>(value));
}

template <class T>
void Archive::get(Source& from, T& value) {
  static_assert(std::is_arithmetic_v<T>, "neither numbers nor an object with a history");
  constexpr double exact = 9007199254740992.0;  // 2^53
  if constexpr (std::is_floating_point_v<T>) {
    value = static_cast<T>(from.next());
  } else if constexpr (std::is_same_v<T, bool>) {
    value = from.next_whole(0, 1) != 0;
  } else if constexpr (sizeof(T) <= 4) {
    value = static_cast<T>(from.next_whole(std::is_signed_v<T> ? -2147483648.0 : 0.0, 2147483647.0));
  } else {
    value = static_cast<T>(from.next_whole(std::is_signed_v<T> ? -exact : 0.0, exact));
  }
}

}  // namespace plumbline
