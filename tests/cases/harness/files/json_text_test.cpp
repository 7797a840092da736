// JSON that nobody meant well.
#include "cases/harness/files/json_text.hpp"

#include <gtest/gtest.h>

namespace plumbline::json_text_test {
namespace {

std::string nested(int depth) { return std::string(depth, '[') + std::string(depth, ']'); }

TEST(JsonText, NestsAsDeepAsAnyDocumentOfOurs) {
  EXPECT_EQ(parse_json(nested(deepest_json)).size(), 1u);
  EXPECT_EQ(parse_json("{\"a\": [1, {\"b\": null}]}").dump(), "{\"a\":[1,{\"b\":null}]}");
}

TEST(JsonText, DeeperIsRefusedBeforeTheStackIsUsedUp) {
  EXPECT_THROW(parse_json(nested(deepest_json + 2)), Json::exception);
  EXPECT_THROW(parse_json(nested(1'000'000)), Json::exception);
  EXPECT_THROW(parse_json(std::string(1'000'000, '[')), Json::exception);
}

TEST(JsonText, WhatIsNoJsonIsRefused) {
  for (const char* text : {"", "{", "nul", "[1,]", "\"\xff\"", "{} x"})
    EXPECT_THROW(parse_json(text), Json::exception) << text;
}

TEST(JsonText, FaultsAreToldWithoutTheNameOfTheLibrary) {
  try {
    parse_json("[1,]");
    FAIL();
  } catch (const Json::exception& error) {
    EXPECT_EQ(fault_of(error).rfind("parse error at line 1, column 4", 0), 0u) << fault_of(error);
  }
}

TEST(JsonText, BytesThatAreNoTextAreReplaced) {
  EXPECT_EQ(valid_utf8("density \u03c1"), "density \u03c1");
  EXPECT_EQ(valid_utf8("6\xd4!"), "6\ufffd!");
  EXPECT_EQ(valid_utf8(""), "");
}

}  // namespace
}  // namespace plumbline::json_text_test
