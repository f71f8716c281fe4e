# cmake -DSOURCE=DIR -DOUT=FILE -P embedded.cmake: reported_scenes() of reported.h, from the scene files of DIR.
set(rows "")
file(GLOB scenes ${SOURCE}/*.json)
list(SORT scenes)
foreach(scene ${scenes})
  cmake_path(GET scene STEM name)
  file(READ ${scene} text)
  string(APPEND rows "    {\"${name}\", R\"~~(${text})~~\"},\n")
endforeach()
file(WRITE ${OUT} "#include \"scenarios/tracker/reported.h\"

namespace plumb {
namespace {

constexpr ReportedScene scenes[] = {
${rows}};

}  // namespace

std::span<const ReportedScene> reported_scenes() { return scenes; }

}  // namespace plumb
")
