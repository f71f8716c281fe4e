# Builds the example games of the engine's README against an installed engine, with the README's own CMake lines.
include(${CMAKE_CURRENT_LIST_DIR}/readme.cmake)
set(work ${BUILD}/readme_example)
file(REMOVE_RECURSE ${work})

run(${CMAKE_COMMAND} --install ${BUILD} --component impulse --prefix ${work}/installed)
extract(engine/README.md "Use the engine in a game" cmake ${work}/CMakeLists.txt)
extract(engine/README.md "Use the engine in a game" cpp ${work}/game.cpp)
build_example(${work})
run(${work}/build/game)

# The same from C.
set(work_c ${BUILD}/readme_example_c)
file(REMOVE_RECURSE ${work_c})
extract(engine/README.md "Use the engine from C" c ${work_c}/game.c)
file(READ ${work}/CMakeLists.txt project)
string(REPLACE "LANGUAGES CXX" "LANGUAGES C CXX" project "${project}")
string(REPLACE "game.cpp" "game.c" project "${project}")
file(WRITE ${work_c}/CMakeLists.txt "${project}")
run(${CMAKE_COMMAND} -S ${work_c} -B ${work_c}/build -G Ninja -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_C_FLAGS=${FLAGS}
    -DCMAKE_PREFIX_PATH=${work}/installed)
run(${CMAKE_COMMAND} --build ${work_c}/build)
run(${work_c}/build/game)
