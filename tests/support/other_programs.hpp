#pragma once
// Programs of others that a test has do something: whether they do it here. That a program is there, or a
// folder with its name, says too little: of gnuplot a drawing is asked, of TeX the packages, of Python a
// function of the module.

#include <cstdlib>
#include <string>

namespace signorini::test {

/// Whether a command of the shell ends with exit code 0.
inline bool succeeds(const std::string& command) {
  return std::system(("{ " + command + "; } >/dev/null 2>&1 </dev/null").c_str()) == 0;
}

/// Whether gnuplot knows the formats in which figures are drawn; one without cairo knows but the first.
inline bool gnuplot_draws() {
  return succeeds("gnuplot -e 'set terminal svg; set terminal pdfcairo; set terminal pngcairo'");
}
constexpr const char* kNoGnuplot = "no gnuplot with svg, pdfcairo and pngcairo is installed (gnuplot-nox)";

}  // namespace signorini::test
