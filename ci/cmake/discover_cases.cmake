# Writes the ctest entries of each case and tier from what the executable lists, so that a new case needs no line here:
# `runs.CASE.TIER` makes the runs, `case.CASE.TIER` judges their orders and all else, and needs the former.
execute_process(COMMAND ${PLUMBLINE} list --json - OUTPUT_VARIABLE listed RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${PLUMBLINE} list --json - failed")
endif()
string(JSON count LENGTH "${listed}" cases)
math(EXPR last "${count} - 1")
set(text "")
foreach(k RANGE ${last})
  string(JSON name GET "${listed}" cases ${k} name)
  foreach(tier quick full)
    set(runs "runs.${name}.${tier}")
    set(case "case.${name}.${tier}")
    set(results "${RESULTS}/${tier}")
    string(APPEND text
      "add_test([[${runs}]] [[${PLUMBLINE}]] sweep ${name} --tier ${tier} --jobs 1 --results [[${results}]])\n"
      "set_tests_properties([[${runs}]] PROPERTIES LABELS \"runs;${tier}\" TIMEOUT 1800 FIXTURES_SETUP [[${runs}]])\n"
      "add_test([[${case}]] [[${PYTHON}]] -B [[${MEASUREMENTS}]] --results [[${results}]] --case ${name}\n"
      "  --picture [[${RESULTS}/pictures/${case}.png]] --\n"
      "  [[${PLUMBLINE}]] verify ${name} --tier ${tier} --threads 1 --reuse --results [[${results}]] --junit [[${RESULTS}/${case}.xml]])\n"
      "set_tests_properties([[${case}]] PROPERTIES LABELS \"case;${tier}\" TIMEOUT 1800 FIXTURES_REQUIRED [[${runs}]])\n")
  endforeach()
endforeach()
file(WRITE ${OUTPUT} "${text}")
