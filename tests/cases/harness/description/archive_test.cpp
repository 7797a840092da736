// What is written is what is read, and what does not fit is refused.
#include "cases/harness/description/archive.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace plumbline::archive_test {
namespace {

using testing::HasSubstr;

struct Inner {
  double rise = 0;
  bool started = false;
  void history(Archive& archive) {
    archive("rise", rise);
    archive("started", started);
  }
};

struct Outer {
  Inner inner;
  long step = 0;
  std::vector<double> times;
  std::vector<float> places;
  std::vector<int> id;
  std::array<double, 3> sums{};
  std::vector<std::array<double, 2>> rows;
  std::vector<std::vector<double>> ragged;
  void history(Archive& archive) {
    archive("inner", inner);
    archive("step", step);
    archive("times", times);
    archive("places", places);
    archive("id", id);
    archive("sums", sums);
    archive("rows", rows);
    archive("ragged", ragged);
  }
};

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

Archive::Table written(Outer& outer) {
  Archive archive;
  archive("outer", outer);
  return archive.take();
}

void read(const Archive::Table& table, Outer& outer) {
  Archive archive(table);
  archive("outer", outer);
  archive.require_all_read();
}

Outer sample() {
  Outer outer;
  outer.inner = {0.1, true};
  outer.step = 9007199254740991;
  outer.times = {nan, -0.0, inf, std::numeric_limits<double>::denorm_min(), 1.0 / 3};
  outer.places = {0.1F, std::numeric_limits<float>::max()};
  outer.id = {3, -1, std::numeric_limits<int>::max()};
  outer.sums = {1, 2, 3};
  outer.rows = {{1, 2}, {3, 4}};
  outer.ragged = {{}, {1}, {2, 3}, {}};
  return outer;
}

TEST(Archive, EveryBitComesBack) {
  Outer outer = sample(), back;
  back.times = {7};  // is replaced, not added to
  const Archive::Table table = written(outer);
  EXPECT_EQ(table.count("outer/inner/rise"), 1U);
  read(table, back);
  EXPECT_EQ(back.inner.rise, 0.1);
  EXPECT_TRUE(back.inner.started);
  EXPECT_EQ(back.step, outer.step);
  ASSERT_EQ(back.times.size(), outer.times.size());
  for (std::size_t k = 0; k < outer.times.size(); ++k) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(back.times[k]), std::bit_cast<std::uint64_t>(outer.times[k]));
  }
  EXPECT_EQ(back.places, outer.places);
  EXPECT_EQ(back.id, outer.id);
  EXPECT_EQ(back.sums, outer.sums);
  EXPECT_EQ(back.rows, outer.rows);
  EXPECT_EQ(back.ragged, outer.ragged);
}

TEST(Archive, EmptyVectorsComeBack) {
  Outer outer, back = sample();
  read(written(outer), back);
  EXPECT_TRUE(back.times.empty() && back.rows.empty() && back.ragged.empty());
}

void expect_refused(const Archive::Table& table, const std::string& what) {
  Outer back;
  try {
    read(table, back);
    ADD_FAILURE() << what << " was taken";
  } catch (const ArchiveError& error) {
    EXPECT_THAT(error.what(), HasSubstr(what));
  }
}

TEST(Archive, WhatDoesNotFitIsRefusedByName) {
  Outer outer = sample();
  const Archive::Table good = written(outer);
  for (const auto& [name, values] : good) {
    Archive::Table bad = good;
    bad.erase(name);
    expect_refused(bad, name + " is missing");
  }
  const auto with = [&](const std::string& name, std::vector<double> values) {
    Archive::Table bad = good;
    bad[name] = std::move(values);
    return bad;
  };
  expect_refused(with("outer/nobody", {1}), "outer/nobody belongs to nothing");
  expect_refused(with("outer/step", {}), "outer/step has too few");
  expect_refused(with("outer/step", {1, 2}), "outer/step has too many");
  expect_refused(with("outer/sums", {1, 2}), "outer/sums has too few");
  expect_refused(with("outer/rows", {1, 2, 3}), "outer/rows has too few");
  for (const double bad : {0.5, nan, inf, -inf, 1e300}) {
    expect_refused(with("outer/step", {bad}), "outer/step is no whole number");
    expect_refused(with("outer/id", {bad}), "outer/id is no whole number");
    expect_refused(with("outer/inner/started", {bad}), "outer/inner/started is no whole number");
  }
  expect_refused(with("outer/id", {2147483648.0}), "outer/id is no whole number");
  expect_refused(with("outer/inner/started", {2}), "outer/inner/started is no whole number");
  for (const double size : {-1.0, 2.0, nan, 1e300}) {
    expect_refused(with("outer/ragged", {size, 1}), "outer/ragged is no whole number");
  }
}

TEST(Archive, ANameIsUsedOnce) {
  Archive archive;
  double value = 1;
  archive("twice", value);
  EXPECT_THROW(archive("twice", value), std::logic_error);
}

}  // namespace
}  // namespace plumbline::archive_test
