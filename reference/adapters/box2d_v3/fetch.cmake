# Fetches Box2D 3 in the version that Plumb knows, and builds and installs it in the build tree while configuring: as a
# part of this build its target would have the name of 2.4's. Sets box2d_ROOT, where find_package looks first. The hash
# of the commit pins every file. Once fetched, no network is needed.
include(FetchContent)
set(PLUMB_BOX2D3_REPOSITORY https://github.com/erincatto/box2d.git CACHE STRING "Where -DPLUMB_BOX2D3=fetch clones from")
set(PLUMB_BOX2D3_COMMIT 8c661469c9507d3ad6fbd2fea3f1aa71669c2fe3 CACHE STRING "What it builds; default: tag v3.1.1")
message(STATUS "Box2D 3: commit ${PLUMB_BOX2D3_COMMIT} of ${PLUMB_BOX2D3_REPOSITORY}")
FetchContent_Declare(box2d_v3 GIT_REPOSITORY ${PLUMB_BOX2D3_REPOSITORY} GIT_TAG ${PLUMB_BOX2D3_COMMIT}
  SOURCE_SUBDIR not_a_part_of_this_build)
FetchContent_MakeAvailable(box2d_v3)

set(box2d_ROOT ${box2d_v3_BINARY_DIR}/${PLUMB_BOX2D3_COMMIT})
if(NOT EXISTS ${box2d_ROOT}/.installed)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${box2d_v3_SOURCE_DIR} -B ${box2d_v3_BINARY_DIR}/build -G ${CMAKE_GENERATOR}
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=${box2d_ROOT} -DBOX2D_SAMPLES=OFF -DBOX2D_UNIT_TESTS=OFF
    -DBOX2D_VALIDATE=OFF OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${box2d_v3_BINARY_DIR}/build --config Release --target install
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  file(TOUCH ${box2d_ROOT}/.installed)
endif()
