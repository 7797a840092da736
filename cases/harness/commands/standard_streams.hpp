// Standard output and error: what was printed has arrived, or the exit status says that it has not.
#pragma once

#include <cstdio>
#include <string>

namespace plumbline {

// Gives standard streams that the caller has closed a descriptor of their own, lest a file that is opened later becomes one of
// them. What is printed to a closed standard output is an error, as on a full disk.
void open_standard_streams();

// Prints to standard output or error, with a replacement sign for each byte that is no UTF-8: what is printed may quote anybody's
// text. No stream's failure throws: after_output() tells what was lost.
void print_text(std::FILE* stream, const std::string& anything);

// The exit status of a command that ended with `status`: 4, with a message, where not all of its output could be written.
int after_output(int status);

}  // namespace plumbline
