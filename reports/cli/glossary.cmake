# cmake -DSOURCE=DIR -DOUT=FILE -P glossary.cmake: glossary_text() of glossary.h, from the checkout.
file(READ ${SOURCE}/README.md readme)
string(REGEX MATCH "## Reading a report.*" readme "${readme}")
string(REGEX REPLACE "\n## Your scene.*" "\n" readme "${readme}")
file(READ ${SOURCE}/reports/glossary.md glossary)
file(WRITE ${OUT} "#include \"reports/cli/glossary.h\"

namespace plumb {

std::string_view glossary_text() {
  return R\"~~(${readme}${glossary})~~\";
}

}  // namespace plumb
")
