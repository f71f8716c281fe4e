# Runs the engine that reference/programs/README.md prints, and example.py, as programs.
include(${CMAKE_CURRENT_LIST_DIR}/readme.cmake)
set(work ${BUILD}/python_example)
file(REMOVE_RECURSE ${work})
extract(reference/programs/README.md "Engines in any language" python ${work}/drops.py)
file(COPY ${PROJECT}/reference/programs/plumb_engine.py ${PROJECT}/reference/programs/example.py DESTINATION ${work})

foreach(engine drops example)
  execute_process(COMMAND ${PLUMB} engine check "exec:${PYTHON} ${work}/${engine}.py"
    RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${engine}.py: ${code}\n${said}")
  endif()
endforeach()

# A hundredth more gravity.
file(READ ${work}/drops.py drops)
string(REPLACE "scale * dt" "scale * dt * 1.01" heavy "${drops}")
file(WRITE ${work}/heavy.py "${heavy}")
execute_process(COMMAND ${PLUMB} engine check "exec:${PYTHON} ${work}/heavy.py" RESULT_VARIABLE code OUTPUT_VARIABLE said)
if(NOT code EQUAL 1 OR NOT said MATCHES "BROKEN +free fall")
  message(FATAL_ERROR "heavy.py: ${code}\n${said}")
endif()

execute_process(COMMAND ${PLUMB} run bounce slope-disc --engine "exec:${PYTHON} ${work}/drops.py"
  --engine "exec:${PYTHON} ${work}/example.py" --engine impulse --out ${work}/out RESULT_VARIABLE code OUTPUT_VARIABLE said
  ERROR_VARIABLE said)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "run: ${code}\n${said}")
endif()
file(READ ${work}/out/report.json report)
string(JSON last LENGTH "${report}" runs)
math(EXPR last "${last} - 1")
foreach(i RANGE ${last})
  foreach(field scenario engine verdict)
    string(JSON ${field} GET "${report}" runs ${i} ${field})
  endforeach()
  if(scenario STREQUAL bounce AND NOT verdict MATCHES "^(right|coarse)$")
    message(FATAL_ERROR "${engine} in bounce: \"${verdict}\", should be right or coarse")
  endif()
endforeach()
