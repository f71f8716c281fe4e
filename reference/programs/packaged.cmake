# cmake -DSOURCE=DIR -DOUT=FILE -P packaged.cmake: packaged_files() of program_engine.h, from the folder of this file.
set(rows "")
function(add engine name file)
  file(READ ${file} text)
  set(rows "${rows}    {\"${engine}\", \"${name}\", R\"~~(${text})~~\"},\n" PARENT_SCOPE)
endfunction()
add("" plumb_engine.mjs ${SOURCE}/plumb_engine.mjs)
file(GLOB engines RELATIVE ${SOURCE}/npm ${SOURCE}/npm/*)
list(SORT engines)
foreach(engine ${engines})
  file(GLOB names RELATIVE ${SOURCE}/npm/${engine} ${SOURCE}/npm/${engine}/*.*)
  foreach(name ${names})
    add(${engine} ${name} ${SOURCE}/npm/${engine}/${name})
  endforeach()
endforeach()
file(WRITE ${OUT} "#include \"reference/programs/program_engine.h\"

namespace plumb {
namespace {

constexpr PackagedFile files[] = {
${rows}};

}  // namespace

std::span<const PackagedFile> packaged_files() { return files; }

}  // namespace plumb
")
