# gnuplot sdof-stop-penalty.gp makes sdof-stop-penalty.svg and sdof-stop-penalty.pdf of sdof-stop-penalty.dat
data = 'sdof-stop-penalty.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-stop-penalty.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'penalty, in units of its scale [-]'
set ylabel 'error of x [-]'
set xrange [3.33e+00:3.00e+06]
set yrange [2.16e-04:2.65e+00]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'augmented-lagrangian[harmonics=40]' at graph 1.06,0.1167 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.000000e+06,6.494719e-04 to graph 1.05,0.1167 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm[harmonics=40]' at graph 1.06,0.1787 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.000000e+06,6.494723e-04 to graph 1.05,0.1787 nohead lc rgb '#E69F00' lw 0.5 back
set label 'penalty-hbm[harmonics=160,compensate=false]' at graph 1.06,0.4707 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 1.000000e+06,1.818799e-02 to graph 1.05,0.4707 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'augmented-lagrangian[harmonics=40,plain=true]' at graph 1.06,0.5824 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.000000e+06,5.207860e-02 to graph 1.05,0.5824 nohead lc rgb '#D55E00' lw 0.5 back
set label 'penalty-hbm[harmonics=40,compensate=false]' at graph 1.06,0.6444 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 1.000000e+06,5.244749e-02 to graph 1.05,0.6444 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'penalty-hbm[harmonics=10,compensate=false]' at graph 1.06,0.7078 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.000000e+06,1.695666e-01 to graph 1.05,0.7078 nohead lc rgb '#009E73' lw 0.5 back
set label '' at 1.000000e+02,1.458579e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+03,9.707175e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+04,6.930189e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+05,6.518130e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+06,6.494719e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+04,8.316630e-02 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '' at 1.000000e+05,6.026143e-02 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '' at 1.000000e+06,5.207860e-02 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '' at 1.000000e+01,8.846863e-01 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+02,5.723764e-01 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+03,3.051175e-01 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+04,2.017019e-01 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+05,1.754430e-01 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+06,1.695666e-01 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+04,1.122674e-01 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
set label '' at 1.000000e+03,1.729288e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '' at 1.000000e+05,3.649110e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '' at 1.000000e+06,1.818799e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#D55E00' dt '-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#D55E00' pt 7 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 5 with points lc rgb '#009E73' pt 8 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#CC79A7' dt '_.' lw 1.6 notitle, \
  data index 7 with points lc rgb '#CC79A7' pt 11 ps 1.1 notitle, \
  data index 8 with points lc rgb '#CC79A7' pt 10 ps 1.1 notitle, \
  data index 9 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 10 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 11 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 12 with points lc rgb '#56B4E9' pt 15 ps 1.1 notitle, \
  data index 13 with points lc rgb '#56B4E9' pt 14 ps 1.1 notitle
unset output
}
