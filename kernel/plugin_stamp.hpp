// What a file that registers parts of a scheme was compiled against. The program reads it from a plug-in's file before any line
// of the plug-in runs: what was built against other headers, or for another standard library, would not fail but go astray.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>

#include "kernel/header_hash.hpp"  // made by the build: PLUMBLINE_VERSION, PLUMBLINE_INTEGRATOR_HEADERS

#define PLUMBLINE_TEXT_OF_VALUE(value) #value
#define PLUMBLINE_TEXT_OF(macro) PLUMBLINE_TEXT_OF_VALUE(macro)

#if defined(_LIBCPP_VERSION)
#define PLUMBLINE_LIBRARY "libc++ " PLUMBLINE_TEXT_OF(_LIBCPP_ABI_VERSION)
#elif defined(_GLIBCXX_USE_CXX11_ABI)
#define PLUMBLINE_LIBRARY "libstdc++ with _GLIBCXX_USE_CXX11_ABI=" PLUMBLINE_TEXT_OF(_GLIBCXX_USE_CXX11_ABI)
#else
#define PLUMBLINE_LIBRARY "unknown"
#endif

namespace plumbline {

// Where it stands in an object file.
#define PLUMBLINE_STAMP_SECTION ".plumbline.stamp"

// Lines of a name, a blank and a value; zeros behind them.
struct PluginStamp {
  char text[256];
};

// `of`: what the file registers, one word; `headers`: the hash of the headers that it sees. `sizes`: of the types that cross the
// border, for what the texts of the headers do not tell (how the standard library was configured, how structs are packed).
constexpr PluginStamp plugin_stamp(const char* of, const char* headers, std::initializer_list<std::size_t> sizes) {
  PluginStamp stamp{};
  std::size_t end = 0;
  const auto append = [&](const char* text) {
    for (; *text; ++text) stamp.text[end++] = *text;
  };
  append("registers ");
  append(of);
  append("\nversion " PLUMBLINE_VERSION "\nheaders ");
  append(headers);
  append("\ncompiler C++ ABI " PLUMBLINE_TEXT_OF(__GXX_ABI_VERSION) "\nlibrary " PLUMBLINE_LIBRARY "\nlayout ");
  std::uint64_t hash = 0xcbf29ce484222325ULL;  // FNV-1a
  for (const std::size_t size : sizes) hash = (hash ^ size) * 0x100000001b3ULL;
  for (int shift = 60; shift >= 0; shift -= 4) stamp.text[end++] = "0123456789abcdef"[(hash >> shift) & 15];
  return stamp;
}

}  // namespace plumbline
