# Builds the README's example as a game would: against an installed engine, with the README's own CMake lines.
# Needs PROJECT (source tree), BUILD (built tree), COMPILER and FLAGS (those of the built tree).
set(work ${BUILD}/readme_example)
file(REMOVE_RECURSE ${work})

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(extract language file)
  file(READ ${PROJECT}/README.md readme)
  string(FIND "${readme}" "```${language}\n" start)
  if(start EQUAL -1)
    message(FATAL_ERROR "README.md has no block of ${language}")
  endif()
  string(SUBSTRING "${readme}" ${start} -1 block)
  string(FIND "${block}" "\n" first)
  math(EXPR first "${first} + 1")
  string(SUBSTRING "${block}" ${first} -1 block)
  string(FIND "${block}" "```" end)
  string(SUBSTRING "${block}" 0 ${end} block)
  file(WRITE ${file} "${block}")
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --component impulse --prefix ${work}/installed)
extract(cmake ${work}/CMakeLists.txt)
extract(cpp ${work}/game.cpp)
run(${CMAKE_COMMAND} -S ${work} -B ${work}/build -G Ninja -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${FLAGS}
    -DCMAKE_PREFIX_PATH=${work}/installed)
run(${CMAKE_COMMAND} --build ${work}/build)
run(${work}/build/game)
