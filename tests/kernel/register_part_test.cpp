#include "kernel/register_part.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "kernel/contact/contact.hpp"
#include "kernel/materials/material_entry.hpp"
#include "kernel/pack.hpp"
#include "kernel/shapes/shape.hpp"
#include "kernel/transfers/transfer.hpp"

namespace plumbline::register_part_test {
namespace {

template <class Entry>
Entry renamed(Entry entry, const std::string& name) {
  entry.name = name;
  return entry;
}

template <class Entry>
void expect_names_are_checked(const Entry& known) {
  EXPECT_THROW(RegisterPart{known}, std::logic_error) << known.name;
  EXPECT_THROW(RegisterPart{renamed(known, "Capital")}, std::logic_error) << known.name;
}

TEST(RegisterPart, TakenAndMalformedNamesAreRefused) {
  expect_names_are_checked(shape_named("quadratic"));
  expect_names_are_checked(transfer_named("apic"));
  expect_names_are_checked(*find_named(contacts(), "touching"));
  expect_names_are_checked(material_named("neo_hookean"));
}

TEST(RegisterPart, IncompletePartsAreRefused) {
  ShapeEntry shape = renamed(shape_named("quadratic"), "test_shape");
  std::get<MakeLoops<Solid>>(shape.loops) = nullptr;
  EXPECT_THROW(RegisterPart{shape}, std::logic_error);
  ShapeEntry wide = renamed(shape_named("quadratic"), "test_shape");
  wide.lanes = 2 * lanes;
  EXPECT_THROW(RegisterPart{wide}, std::logic_error) << "arrays end before its last pack does";
  ContactEntry contact = renamed(*find_named(contacts(), "touching"), "test_contact");
  std::get<MakeContact<3>>(contact.make) = nullptr;
  EXPECT_THROW(RegisterPart{contact}, std::logic_error);
  MaterialEntry material = renamed(material_named("neo_hookean"), "test_material");
  material.make = {};
  EXPECT_THROW(RegisterPart{material}, std::logic_error);
}

TEST(RegisterPart, OneBuiltAgainstAnotherKernelIsNone) {
  PluginStamp other = part_stamp();
  other.text[0] = 'x';
  EXPECT_THROW(RegisterPart(renamed(transfer_named("apic"), "test_transfer"), other), std::logic_error);
  EXPECT_EQ(find_named(transfers(), "test_transfer"), nullptr);
  EXPECT_THAT(std::string(part_stamp().text), testing::StartsWith("registers parts\nversion " PLUMBLINE_VERSION "\n"));
}

TEST(RegisterPart, CollectedPartsAreUncheckedAndNotRegistered) {
  const std::size_t before = transfers().size();
  const std::vector<CollectedPart> found = collect_parts([] {
    RegisterPart(renamed(transfer_named("apic"), "Capital"));
    RegisterPart(shape_named("quadratic"));
  });
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].kind + " " + found[0].name, "transfer Capital");
  EXPECT_EQ(found[1].kind + " " + found[1].name, "shape quadratic");
  EXPECT_EQ(transfers().size(), before);
  for (const CollectedPart& part : found) EXPECT_THROW(part.add(), std::logic_error);
  EXPECT_THROW(collect_parts([] { throw std::runtime_error("no library"); }), std::runtime_error);
  EXPECT_THROW(RegisterPart(shape_named("quadratic")), std::logic_error) << "checked again";
}

}  // namespace
}  // namespace plumbline::register_part_test
