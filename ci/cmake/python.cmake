# Finds a Python that *has* the modules, not merely the python3 that stands first on PATH.
# -DPLUMBLINE_PYTHON=... names one explicitly; a wrong explicit choice is an error, not a hint.
function(plumbline_find_python)
  set(modules numpy,scipy,h5py,matplotlib,PIL,jinja2,jsonschema,mpmath,pytest)
  if(PLUMBLINE_PYTHON)
    set(candidates "${PLUMBLINE_PYTHON}")
  else()
    find_program(first_on_path NAMES python3 NO_CACHE)
    set(candidates "${first_on_path}" /usr/bin/python3 /usr/local/bin/python3)
  endif()
  foreach(candidate IN LISTS candidates)
    execute_process(COMMAND "${candidate}" -c "import ${modules},sys;print(sys.executable)"
      RESULT_VARIABLE status OUTPUT_VARIABLE executable ERROR_VARIABLE message OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(status EQUAL 0)
      set(Python3_EXECUTABLE "${executable}" CACHE FILEPATH "Python with the modules of the report" FORCE)
      message(STATUS "Python for the report and the tests: ${executable}")
      return()
    endif()
    string(APPEND reasons "\n  ${candidate}: ${message}")
  endforeach()
  message(FATAL_ERROR "No Python with the modules ${modules}; tried:${reasons}\n"
    "Run ci/setup, or name one with -DPLUMBLINE_PYTHON=/path/to/python3.")
endfunction()
