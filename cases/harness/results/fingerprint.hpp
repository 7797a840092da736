// By which code a result was made: a hash that is another one as soon as code that can change the result is, or how it is called.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cases/harness/description/case.hpp"

namespace plumbline {

// A source of this program, and the object file that it is compiled to, maybe with others.
struct ObjectHash {
  std::string source;  // "cases/catalog/gas/sod.cpp"
  std::string hash;
  bool has_header = false;  // a header of the same name: others may call into it
};

// The table of the program's objects, as the build writes it, and which folder of cases includes which.
struct RegisterCode {
  RegisterCode(std::vector<ObjectHash> objects, std::vector<std::pair<std::string, std::string>> uses);
};

// A plug-in is part of the code, too. Throws FileError if the file cannot be read.
void add_plugin_to_code(const std::string& file);

// Of everything that any result depends on; empty where the build has told nothing, as in tests.
std::string code_fingerprint();

// Of what the numbers of one case depend on: compiler and flags; kernel, references, harness; its own object; and what
// its folder, and folders that this one includes, share. An object is shared unless it registers cases and has no header.
// Empty where the build has told nothing, or nothing of the case.
std::string fingerprint(const Case& entry);

}  // namespace plumbline
