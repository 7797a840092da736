# Puts a text of JSON into literals, to be included by a source between the braces of an array: one for each line, since compilers
# need not take one above 65536 characters. Called with -DFILE and -DOUTPUT.
cmake_minimum_required(VERSION 3.25)
file(READ ${FILE} text)
string(STRIP "${text}" text)
string(REPLACE "\n" ")json\",\nR\"json(" lines "${text}")
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "R\"json(@lines@)json\"\n" @ONLY)
