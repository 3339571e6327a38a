# gnuplot chain3-massless-penalty.gp makes chain3-massless-penalty.svg and chain3-massless-penalty.pdf of chain3-massless-penalty.dat
data = 'chain3-massless-penalty.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'chain3-massless-penalty.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'penalty, in units of its scale [-]'
set ylabel 'error of x [-]'
set xrange [3.33e+00:3.00e+06]
set yrange [1.51e-04:4.90e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'penalty-hbm[harmonics=160,compensate=false]' at graph 1.06,0.1516 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 1.000000e+06,5.153405e-04 to graph 1.05,0.1516 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'augmented-lagrangian[harmonics=40,plain=true]' at graph 1.06,0.4142 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.000000e+04,4.304670e-03 to graph 1.05,0.4142 nohead lc rgb '#D55E00' lw 0.5 back
set label 'penalty-hbm[harmonics=40,compensate=false]' at graph 1.06,0.4762 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 1.000000e+06,4.550599e-03 to graph 1.05,0.4762 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'penalty-hbm[harmonics=40]' at graph 1.06,0.5382 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.000000e+06,4.550599e-03 to graph 1.05,0.5382 nohead lc rgb '#E69F00' lw 0.5 back
set label 'augmented-lagrangian[harmonics=40]' at graph 1.06,0.6002 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.000000e+06,4.551106e-03 to graph 1.05,0.6002 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm[harmonics=10,compensate=false]' at graph 1.06,0.8641 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.000000e+05,1.633800e-01 to graph 1.05,0.8641 nohead lc rgb '#009E73' lw 0.5 back
set label '' at 1.000000e+02,2.885392e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+03,3.664865e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+04,4.304670e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+05,4.502693e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+06,4.551106e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+01,3.844632e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+02,1.364910e-01 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+03,1.578543e-01 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+04,1.624027e-01 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+05,1.633800e-01 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+01,6.480137e-02 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
set label '' at 1.000000e+02,5.419845e-03 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
set label '' at 1.000000e+03,7.200242e-04 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '' at 1.000000e+04,4.537987e-04 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '' at 1.000000e+05,5.115039e-04 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '' at 1.000000e+06,5.153405e-04 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#D55E00' dt '-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#D55E00' pt 7 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 5 with points lc rgb '#009E73' pt 9 ps 1.1 notitle, \
  data index 6 with points lc rgb '#009E73' pt 8 ps 1.1 notitle, \
  data index 7 with lines lc rgb '#CC79A7' dt '_.' lw 1.6 notitle, \
  data index 8 with points lc rgb '#CC79A7' pt 11 ps 1.1 notitle, \
  data index 9 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 10 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 11 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 12 with points lc rgb '#56B4E9' pt 15 ps 1.1 notitle
unset output
}
