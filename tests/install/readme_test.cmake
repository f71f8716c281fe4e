# Builds the example game of the engine's README against an installed engine, with the README's own CMake lines.
include(${CMAKE_CURRENT_LIST_DIR}/readme.cmake)
set(work ${BUILD}/readme_example)
file(REMOVE_RECURSE ${work})

run(${CMAKE_COMMAND} --install ${BUILD} --component impulse --prefix ${work}/installed)
extract(engine/README.md "Use the engine in a game" cmake ${work}/CMakeLists.txt)
extract(engine/README.md "Use the engine in a game" cpp ${work}/game.cpp)
build_example(${work})
run(${work}/build/game)
